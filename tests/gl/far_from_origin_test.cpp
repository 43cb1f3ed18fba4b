// A scene far from the world's origin gives the same picture: lit surfaces must not become speckled where float32
// lacks precision for world positions.
#include "gl_test.h"
#include "topics/hidden/numbers/hidden_views.h"

namespace viewing {
namespace {

using testing::pixels_beyond;

constexpr glm::ivec2 far_away_px(640, 360);

struct Place {
    Params params;
    Scene scene;
};

/// Returns the opening state moved by `offset`.
Place moved_by(const glm::dvec3& offset) {
    Place made{testing::params_with({"view.samples=0"}), testing::scene_named("torus-and-boxes")};
    made.params.camera.position += offset;
    made.params.camera.target += offset;
    for (PlaneParams& plane : made.params.planes) plane.equation.w -= glm::dot(glm::dvec3(plane.equation), offset);
    for (LightParams& light : made.params.lights) light.position += glm::dvec4(light.position.w * offset, 0.0);
    std::vector<SceneObject> objects = made.scene.objects;
    for (SceneObject& object : objects) object.world_from_model[3] += glm::dvec4(offset, 0.0);
    made.scene = testing::scene_of(objects);
    return made;
}

class FarFromOrigin : public testing::GlTest {};

TEST_F(FarFromOrigin, LightDoesNotSpeckle) {
    const Place here = moved_by(glm::dvec3(0.0));
    const Image expected = draw(here.params, here.scene, far_away_px);
    for (const double far_away : {1e5, 9e5}) {
        // Moves perpendicular to the plane. Otherwise, the patch would not move with the objects, because it is
        // centered on the plane's point nearest to the origin.
        const Place there = moved_by({0.0, far_away, 0.0});
        const Image picture = draw(there.params, there.scene, far_away_px);
        EXPECT_LE(pixels_beyond(expected, picture, 16), 12) << far_away << ": edges that moved by a pixel's fraction";
        EXPECT_LE(pixels_beyond(expected, picture, 3), 300) << far_away;
    }
}

/// Methods other than the depth buffer draw their own polygons and surface points, relative to the eye.
TEST_F(FarFromOrigin, OtherMethodsDrawTheSamePicture) {
    const auto drawn = [](const Place& place, VisibilityMethod method) {
        Params params = place.params;
        params.visibility.method = method;
        const Derived derived = derive_for(params, place.scene, far_away_px);
        HiddenSurfaceSolver solver(place.scene);
        const auto question = hidden_question(params, derived, far_away_px);
        EXPECT_TRUE(question);
        const HiddenPictures pictures = answer_hidden_question(solver, *question).pictures;
        return draw(plan(params, derived, pictures), place.scene, far_away_px);
    };
    const Place here = moved_by(glm::dvec3(0.0)), there = moved_by({0.0, 9e5, 0.0});
    for (const VisibilityMethod method : {VisibilityMethod::painter, VisibilityMethod::newell, VisibilityMethod::bsp,
                                          VisibilityMethod::ray_cast, VisibilityMethod::software_depth_buffer}) {
        const Image expected = drawn(here, method), picture = drawn(there, method);
        EXPECT_LE(pixels_beyond(expected, picture, 16), 60) << static_cast<int>(method);
    }
}

}  // namespace
}  // namespace viewing
