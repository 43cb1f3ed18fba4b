// Degenerate planes, lights and eyes still yield a defined picture, finite numbers, no GL error, and a sentence that
// names the problem. planes_switches_test.cpp has the states that are broken on purpose.
#include <cmath>

#include "geometry/shapes.h"
#include "gl_test.h"
#include "render/buffer_read.h"

namespace viewing {
namespace {

using testing::params_with;
using testing::pixels_beyond;
using testing::scene_named;

constexpr glm::ivec2 edges_px(128, 72);

struct Extreme {
    const char* name;
    std::vector<std::string> state;
    bool is_told = true;  ///< whether a sentence reports the problem
};

const char* const four_lights = R"(lights=[{"position":[-3,5,3,1]},{"position":[1,4,5,0]},{"position":[1,2,1,0.4]}])";

std::vector<Extreme> extremes() {
    return {
        {"light in the plane", {"light.position=[2,0,1,1]"}},
        {"light along the plane", {"light.position=[2,0,1,0]"}},
        {"light below", {"light.position=[2,-3,1,1]"}},
        {"light in a further plane", {"light.position=[2,3,-2,1]", R"(planes=[{"equation":[0,0,1,2],"extent":3}])"}},
        {"eye in the plane", {"camera.position=[0,0,7]", "camera.yaw=0", "camera.pitch=-2"}},
        {"eye along the plane",
         {"projection.type=orthographic", "camera.position=[0,1,7]", "camera.yaw=0", "camera.pitch=0"}},
        {"casters across the plane", {"plane.equation=[0,1,0,-1]"}, false},
        {"casters across the light's plane", {"light.position=[0,0.8,0.4,1]"}},
        {"two identical planes", {R"(planes=[{"equation":[0,1,0,0],"extent":4}])"}, false},
        {"a plane and its negative", {R"(planes=[{"equation":[0,-2,0,0],"extent":4}])"}, false},
        {"a tiny patch", {"plane.extent=0.001"}, false},
        {"a huge patch", {"plane.extent=10000"}, false},
        {"reflectance 0", {"reflection.reflectance=0"}, false},
        {"reflectance 1", {"reflection.reflectance=1"}, false},
        {"16 bounces of one mirror", {"reflection.bounces=16"}, false},
        {"16 bounces of two mirrors",
         {"reflection.bounces=16", "plane.mirrors=false",
          R"(planes=[{"equation":[0,0,1,3],"extent":3},{"equation":[0,0,-1,4],"extent":3}])"}},
        {"8 planes and 4 lights",
         {"reflection.bounces=16", four_lights,
          R"(planes=[{"equation":[0,0,1,3]},{"equation":[1,0,0,4]},{"equation":[-1,0,0,5]},{"equation":[0,0,-1,9]},)"
          R"({"equation":[0,-1,0,6]},{"equation":[1,1,1,4]},{"equation":[-1,1,1,4]}])"}},
        {"R by hand without an inverse", {"overrides.mirror_from_world=[[1,0,0,0],[0,0,0,0],[0,0,1,0],[0,0,0,1]]"}},
        {"S by hand", {"overrides.shadow_from_world=[[0,0,0,0],[0,0,0,0],[0,0,0,0],[0,0,0,0]]"}},
    };
}

bool is_finite(const glm::dmat4& matrix) {
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!std::isfinite(matrix[column][row])) return false;
    return true;
}

bool is_finite(const glm::dvec4& vector) {
    return is_finite(glm::dmat4(vector, vector, vector, vector));
}

bool is_finite(const Pass& pass) {
    const auto finite = [](const glm::dvec4& vector) { return is_finite(vector); };
    return is_finite(pass.world_from_scene) && is_finite(pass.clip_from_world) && is_finite(pass.view_from_world) &&
           is_finite(pass.color) && is_finite(pass.eye_world) && is_finite(glm::dvec4(pass.sky_world, 0.0)) &&
           std::ranges::all_of(pass.clip_planes, finite) && std::ranges::all_of(pass.lights_world, finite);
}

class Extremes : public testing::GlTest {};

TEST_F(Extremes, AreFiniteAndReported) {
    const Scene scene = scene_named("torus-and-boxes");
    Result<BufferReader> reader = BufferReader::make(renderer().capabilities());
    ASSERT_TRUE(reader) << reader.error();
    for (const Extreme& extreme : extremes()) {
        for (const char* const way : {"reflection.clip=clip_distance", "reflection.clip=oblique",
                                      "reflection.mirrored=camera", "shadow.style=missing_light"}) {
            SCOPED_TRACE(std::string(extreme.name) + ", " + way);
            std::vector<std::string> settings{"view.samples=0", way};
            settings.insert(settings.end(), extreme.state.begin(), extreme.state.end());
            const Params params = params_with(settings);
            const Derived derived = derive_for(params, scene, edges_px);
            const FramePlan frame = plan(params, derived);
            if (extreme.is_told) {
                EXPECT_FALSE(find_problems(params, derived, scene, frame).empty());
            }
            EXPECT_TRUE(std::ranges::all_of(frame.passes, [](const Pass& pass) { return is_finite(pass); }));
            View view;
            const Image image = draw(frame, scene, edges_px, renderer(), view);
            EXPECT_EQ(draw(frame, scene, edges_px), image);
            for (const StoredPixel& pixel : reader->stored(view, params.depth.format, {{0, 0}, edges_px})) {
                EXPECT_GE(pixel.window_depth, 0.0);
                EXPECT_LE(pixel.window_depth, 1.0);
            }
        }
    }
}

TEST_F(Extremes, AreNeverMoreThan64Images) {
    const Scene scene = scene_named("torus-and-boxes");
    for (const Extreme& extreme : extremes()) {
        const Params params = params_with(extreme.state);
        int images = 0, region = 0;
        for (const Pass& pass : plan(params, derive_for(params, scene, edges_px)).passes) {
            images += pass.subject == Subject::objects && pass.shading == Shading::lit && pass.is_mirror_image;
            region = std::max(region, pass.stencil.reference & stencil_region_bits);
            EXPECT_LE(pass.stencil.reference, 255) << extreme.name;
        }
        EXPECT_LE(images, 64) << extreme.name;
        EXPECT_LE(region, 15) << extreme.name;
    }
}

TEST_F(Extremes, InReflectanceShowNothingOrOnlyTheMirror) {
    const Scene scene = scene_named("torus-and-boxes");
    const auto picture = [&](const char* setting, const char* other) {
        return draw(params_with({"view.samples=0", "shadow.enabled=false", setting, other}), scene, edges_px);
    };
    EXPECT_EQ(pixels_beyond(picture("reflection.reflectance=0", "plane.mirrors=true"),
                            picture("reflection.enabled=false", "plane.mirrors=true"), 0),
              0);
    EXPECT_EQ(pixels_beyond(picture("reflection.reflectance=1", "plane.gloss=true"),
                            picture("reflection.reflectance=1", "plane.gloss=false"), 0),
              0);
}

TEST_F(Extremes, InTheLightShowNoShadow) {
    const Scene scene = scene_named("torus-and-boxes");
    for (const char* const light :
         {"light.position=[2,0,1,1]", "light.position=[2,0,1,0]", "light.position=[2,-3,1,1]"}) {
        const Image with = draw(params_with({"view.samples=0", light}), scene, edges_px);
        EXPECT_EQ(draw(params_with({"view.samples=0", light, "shadow.enabled=false"}), scene, edges_px), with) << light;
    }
}

/// A square of side 1 under the light casts a shadow of side 5 / gap, which covers the whole patch however small the
/// gap is.
TEST_F(Extremes, WithALightCloseToItsCasterDarkenTheWholePatch) {
    const auto picture = [&](double gap) {
        const Scene scene =
            testing::scene_of({testing::object("square", quad_mesh(), {0.0, 5.0 - gap, 0.0}, glm::dvec3(0.5))});
        return draw(
            params_with({"view.samples=0", "light.position=[0,5,0,1]", "plane.extent=12", "reflection.enabled=false"}),
            scene, edges_px);
    };
    const Image far = picture(0.05);
    const Image lit =
        draw(params_with({"view.samples=0", "light.position=[0,5,0,1]", "plane.extent=12", "reflection.enabled=false",
                          "shadow.enabled=false"}),
             testing::scene_of({testing::object("square", quad_mesh(), {0.0, 4.95, 0.0}, glm::dvec3(0.5))}), edges_px);
    EXPECT_GT(pixels_beyond(lit, far, 8), 1000);
    for (const double gap : {0.02, 0.01, 0.004, 0.001}) EXPECT_EQ(pixels_beyond(picture(gap), far, 0), 0) << gap;
}

}  // namespace
}  // namespace viewing
