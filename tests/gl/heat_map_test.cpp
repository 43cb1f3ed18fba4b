// Tests the heat map as GL draws it: compares the color of a pixel with the ratio of gap to step. The ratio is computed
// here from the formula for the step and from a ray through the pixel.
#include <cmath>

#include "gl/gl_test.h"

namespace viewing {
namespace {

using testing::Rgb;

constexpr glm::ivec2 heat_px(320, 240);
constexpr double heat_near = 0.5, heat_far = 200.0, fovy_deg = 40.0;

class HeatMapPicture : public testing::GlTest {
protected:
    /// Returns two quads that face the camera, `gap` apart, and a single box beside them. The camera looks from the
    /// origin along −z.
    static Scene facing_pair(double distance, double gap) {
        const auto quad = [](const char* name, const glm::dvec3& at, double side) {
            SceneObject made = testing::object(name, quad_mesh(), at);
            made.world_from_model = world_from_model(at, {0.0, 90.0, 0.0}, glm::dvec3(side));
            return made;
        };
        return testing::scene_of({quad("back", {0.0, 0.0, -distance}, 0.2 * distance),
                                  quad("front", {0.0, 0.0, -distance + gap}, 0.2 * distance),
                                  testing::object("box", box_mesh(), {0.3 * distance, 0.0, -distance})});
    }
    static Params params_for(const char* format) {
        Params params = testing::params_with(
            {"camera.position=[0,0,0]", "camera.yaw=0", "camera.pitch=0", "camera.roll=0", "projection.near=0.5",
             "projection.far=200", "view.shows=fighting", "view.samples=0", std::string("depth.format=") + format});
        params.planes.front().extent = 1e-3;
        return params;
    }
    static Image picture(const Params& params, const Scene& scene) {
        return draw(plan(params, derive_for(params, scene, heat_px)), scene, heat_px);
    }
};

/// Returns the legend's color for a ratio, interpolated between two legend colors.
Rgb expected(double ratio) {
    const glm::dvec3 stops[] = {{0x8e, 0x1b, 0x12}, {0xc0, 0x36, 0x1e}, {0xe4, 0x57, 0x2e},
                                {0xee, 0xa2, 0x4a}, {0xf3, 0xcb, 0x85}, {0xc3, 0xe0, 0xf0}};
    if (ratio < 0.5) return Rgb(glm::round(glm::mix(stops[0], stops[1], ratio / 0.5)));
    if (ratio < 1.0) return Rgb(glm::round(glm::mix(stops[1], stops[2], (ratio - 0.5) / 0.5)));
    if (ratio < 2.0) return Rgb(glm::round(glm::mix(stops[3], stops[4], std::log2(ratio))));
    if (ratio < 4.0) return Rgb(glm::round(glm::mix(stops[4], stops[5], std::log2(ratio) - 1.0)));
    return Rgb(stops[5]);
}

TEST_F(HeatMapPicture, ShowsTheGapInStepsOfTheDepthBuffer) {
    // With 16 bits, the step equals one code to within 1 %. When the quads face the camera, the gap in eye distance
    // equals the gap along the normal at every pixel; the slant of a pixel's view ray does not lengthen it.
    const Params params = params_for("d16");
    for (const double distance : {5.0, 20.0, 60.0}) {
        const double step = distance * distance * (heat_far - heat_near) / (heat_far * heat_near * 65535.0);
        for (const double ratio : {0.05, 0.3, 0.7, 0.9, 1.2, 1.7, 3.0, 8.0}) {
            const double gap = ratio * step;
            if (gap > 0.03 * distance) continue;
            const Image image = picture(params, facing_pair(distance, gap));
            const Rgb seen = testing::rgb_at(image, {heat_px.x / 2 + 10, heat_px.y / 2 - 10});
            EXPECT_LE(testing::worst_channel(seen, expected(ratio)), 6) << "z " << distance << " ratio " << ratio;
        }
    }
}

TEST_F(HeatMapPicture, UsesTheGapAlongTheRay) {
    // When the quads are rotated by 60° about the vertical axis, the gap in eye distance is twice as wide at the
    // picture's center; at other pixels it depends on the ray.
    const double distance = 20.0, turn = glm::radians(60.0), gap = 0.012;
    Scene scene = facing_pair(distance, 0.0);
    const glm::dvec3 normal(std::sin(turn), 0.0, std::cos(turn));
    for (int object = 0; object < 2; ++object) {
        const glm::dvec3 at = glm::dvec3(0.0, 0.0, -distance) + normal * (object * gap);
        scene.objects[static_cast<std::size_t>(object)].world_from_model =
            world_from_model(at, {60.0, 90.0, 0.0}, glm::dvec3(4.0));
    }
    scene.objects.pop_back();
    const Image image = picture(params_for("d16"), scene);
    for (const int x : {heat_px.x / 2 - 15, heat_px.x / 2, heat_px.x / 2 + 15}) {
        const double half = std::tan(glm::radians(fovy_deg / 2.0));
        const double across = (2.0 * (x + 0.5) - heat_px.x) / heat_px.y * half;
        const glm::dvec3 sight(across, 0.0, -1.0);  // per unit of eye distance
        const double z = -normal.z * distance / glm::dot(normal, sight);
        const double step = z * z * (heat_far - heat_near) / (heat_far * heat_near * 65535.0);
        const double ratio = gap / std::abs(glm::dot(normal, sight)) / step;
        EXPECT_LE(testing::worst_channel(testing::rgb_at(image, {x, heat_px.y / 2}), expected(ratio)), 6)
            << "x " << x << " ratio " << ratio;
    }
}

TEST_F(HeatMapPicture, LeavesUnpairedSurfacesGray) {
    const Image image = picture(params_for("d24"), facing_pair(10.0, 0.01));
    const Derived derived = derive_for(params_for("d24"), Scene{}, heat_px);
    const Rgb box = testing::rgb_at(image, testing::pixel_of({3.0, 0.0, -9.5}, derived, heat_px));
    EXPECT_EQ(box.r, box.g);
    EXPECT_EQ(box.g, box.b);
    EXPECT_NE(box, testing::rgb_at(image, {2, 2})) << "not the background";
}

TEST_F(HeatMapPicture, IsTheSameForEveryMethod) {
    Params params = params_for("d24");
    params.reflection.enabled = params.shadow.enabled = false;
    const Scene scene = facing_pair(10.0, 0.002);
    const Image plain = picture(params, scene);
    params.visibility.method = VisibilityMethod::painter;
    params.reflection.enabled = params.shadow.enabled = true;
    EXPECT_EQ(testing::pixels_beyond(picture(params, scene), plain, 0), 0);
}

TEST_F(HeatMapPicture, WorksWithAPlanDerivedForColors) {
    Params params = params_for("d24");
    const Scene scene = facing_pair(10.0, 0.002);
    params.view.shows = Shows::color;
    const Derived derived = derive_for(params, scene, heat_px);
    params.view.shows = Shows::fighting;
    const Rgb seen = testing::rgb_at(draw(plan(params, derived), scene, heat_px), {heat_px.x / 2, heat_px.y / 2});
    EXPECT_EQ(seen.r, seen.g) << "gray";
}

}  // namespace
}  // namespace viewing
