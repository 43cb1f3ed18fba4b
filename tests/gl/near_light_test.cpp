// A light that almost touches a wall still casts the wall's whole shadow, however small the distance between them. The
// expected shadow is found by following rays, not by S.
#include "gl_test.h"
#include "platform/sanitized.h"

namespace viewing {
namespace {

using testing::rgb_at;

constexpr glm::ivec2 near_light_px(160, 120);

class NearLight : public testing::GlTest {};

/// The wall is the rectangle x = 1, 0 ≤ y ≤ 4, |z| ≤ 3; the light is beside it, at a height of 1.
Params beside_the_wall(double distance) {
    return testing::params_with({"view.samples=0", "camera.position=[4,14,16]", "camera.yaw=14", "camera.pitch=-42",
                                 "plane.extent=12", "reflection.enabled=false", "shadow.opacity=1",
                                 "shadow.color=#ff0000", "projection.far=100",
                                 "light.position=[" + std::to_string(1.0 + distance) + ",1,0,1]"});
}

struct ShadowCount {
    int missing = 0, false_shadow = 0, shadow = 0;
};

/// Compares the floor's pixels with the rays from the floor to the light, except near the shadow's edge and where the
/// wall hides the floor.
ShadowCount compared(const Image& picture, const Derived& derived, double distance) {
    const glm::dmat4 world_from_clip = glm::inverse(derived.clip_from_world);
    const glm::dvec3 eye(derived.eye_world), light(1.0 + distance, 1.0, 0.0);
    const auto meets_wall = [](const glm::dvec3& from, const glm::dvec3& to, double margin) {
        const double t = (1.0 - from.x) / (to.x - from.x);
        const glm::dvec3 at = from + t * (to - from);
        return t > 0.0 && t < 1.0 && at.y < 4.0 + margin && std::abs(at.z) < 3.0 + margin;
    };
    ShadowCount found;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const glm::dvec4 on_far = world_from_clip * glm::dvec4((x + 0.5) / picture.width * 2.0 - 1.0,
                                                                   1.0 - (y + 0.5) / picture.height * 2.0, 1.0, 1.0);
            const glm::dvec3 way = glm::dvec3(on_far) / on_far.w - eye;
            const glm::dvec3 floor = eye - way * (eye.y / way.y);
            const bool is_on_patch = way.y < 0.0 && std::max(std::abs(floor.x), std::abs(floor.z)) < 11.7;
            if (!is_on_patch || meets_wall(eye, floor, 0.3) || std::abs(floor.x - 1.0) < 0.4) continue;
            const bool is_red = rgb_at(picture, {x, y}) == testing::Rgb(255, 0, 0);
            const bool is_shadow = meets_wall(floor, light, 0.0);
            found.shadow += is_shadow ? 1 : 0;
            found.missing += is_shadow && !is_red ? 1 : 0;
            found.false_shadow += !is_shadow && is_red ? 1 : 0;
        }
    return found;
}

TEST_F(NearLight, KeepsTheWholeShadowAtEveryDistance) {
    Mesh square = quad_mesh();
    SceneObject wall = testing::object("wall", square, {0, 0, 0});
    wall.world_from_model = world_from_model({1, 2, 0}, {0.0, 0.0, 90.0}, {2, 1, 3});
    const Scene scene = testing::scene_of({wall});
    const int steps = is_sanitized ? 20 : 200;
    for (int step = 0; step < steps; ++step) {
        const double distance = 0.0005 + 0.0075 * step / steps;
        const Params params = beside_the_wall(distance);
        const ShadowCount found =
            compared(draw(params, scene, near_light_px), derive_for(params, scene, near_light_px), distance);
        EXPECT_GT(found.shadow, 3000);
        EXPECT_EQ(found.missing, 0) << "light at a distance of " << distance << ", of " << found.shadow;
        EXPECT_EQ(found.false_shadow, 0) << distance;
    }
}

}  // namespace
}  // namespace viewing
