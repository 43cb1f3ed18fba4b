// For an image whose near plane is the mirror, checks the depth steps against small moves along each view ray.
#include "topics/planes/numbers/oblique_depth.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "unit/frame/frame_test.h"
#include "unit/geometry/random.h"

namespace viewing {
namespace {

using testing::object;
using testing::params_with;
using testing::scene_of;

double window_depth(const glm::dmat4& clip_from_world, const glm::dvec3& at_world) {
    const glm::dvec4 clip = clip_from_world * glm::dvec4(at_world, 1.0);
    return 0.5 * clip.z / clip.w + 0.5;
}

TEST(ObliqueDepth, MatchesTheDepthChangeAlongAViewRay) {
    const Scene scene = scene_of({object("box", box_mesh(), {0.4, 1, 0.3}), object("far", box_mesh(), {-1, 1.2, -2})});
    Random random(seed);
    int seen = 0;
    for (int trial = 0; trial < 200; ++trial) {
        SCOPED_TRACE("seed " + std::to_string(seed) + " trial " + std::to_string(trial));
        Params params = params_with({"reflection.clip=oblique", "plane.extent=100"});
        params.camera.position += random.vec3(1.5);
        params.projection.type = trial % 4 == 0 ? ProjectionType::orthographic : ProjectionType::perspective;
        params.projection.near = random.number(0.05, 1.0);
        params.planes.front().equation = {glm::normalize(glm::dvec3(0, 1, 0) + random.vec3(0.2)),
                                          random.number(0, 0.4)};
        const Derived derived = derive(params, scene, Viewport{});
        const FramePlan frame = plan(params, derived);
        const std::optional<ObliqueDepth> found = oblique_depth(params, derived, scene, frame);
        if (!found) continue;
        ++seen;
        const Pass& image = *std::find_if(frame.passes.begin(), frame.passes.end(),
                                          [](const Pass& pass) { return pass.name == "Mirror image"; });
        const glm::dmat4 plain = derived.clip_from_view * derived.view_from_world;
        double least = 1e300, greatest = 0.0;
        for (const SceneObject& one : scene.objects)
            for (const glm::vec3& vertex : one.mesh->positions) {
                const glm::dvec3 at(image.world_from_scene * one.world_from_model * glm::dvec4(vertex, 1.0));
                const glm::dvec4 clip = plain * glm::dvec4(at, 1.0), cut = image.clip_from_world * glm::dvec4(at, 1.0);
                if (std::max(std::abs(clip.x), std::abs(clip.y)) > clip.w || std::abs(cut.z) > cut.w) continue;
                const glm::dvec3 eye(derived.eye_world);
                const glm::dvec3 away = glm::normalize(derived.eye_world.w == 0.0 ? -eye : at - eye),
                                 move = 1e-5 * away;
                const auto change = [&](const glm::dmat4& by) {
                    return std::abs(window_depth(by, at + move) - window_depth(by, at - move));
                };
                const double ratio = change(plain) / change(image.clip_from_world);
                least = std::min(least, ratio);
                greatest = std::max(greatest, ratio);
            }
        EXPECT_NEAR(found->least / least, 1.0, 1e-3);
        EXPECT_NEAR(found->greatest / greatest, 1.0, 1e-3);
    }
    EXPECT_GT(seen, 100);
}

TEST(ObliqueDepth, IsAbsentWithoutAnImageOrWithShaderDepth) {
    const Scene scene = testing::box_scene();
    const auto depth_of = [&](const std::vector<std::string>& settings) {
        const Params params = params_with(settings);
        const Derived derived = derive(params, scene, Viewport{});
        return oblique_depth(params, derived, scene, plan(params, derived));
    };
    EXPECT_TRUE(depth_of({"reflection.clip=oblique"}));
    EXPECT_FALSE(depth_of({"reflection.clip=oblique", "depth.mapping=logarithmic"}));
    EXPECT_FALSE(depth_of({"reflection.clip=oblique", "reflection.enabled=false"}));
    EXPECT_FALSE(depth_of({"reflection.clip=oblique", "camera.yaw=180"}));
    const Params camera = params_with({"reflection.clip=oblique", "reflection.mirrored=camera"});
    const Derived derived = derive(camera, scene, Viewport{});
    const std::optional<ObliqueDepth> by_camera = oblique_depth(camera, derived, scene, plan(camera, derived)),
                                      by_scene = depth_of({"reflection.clip=oblique"});
    ASSERT_TRUE(by_camera && by_scene);
    EXPECT_NEAR(by_camera->least, by_scene->least, 1e-9 * by_scene->least) << "the same for either mirroring";
}

}  // namespace
}  // namespace viewing
