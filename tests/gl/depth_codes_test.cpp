// The codes that really lie in the depth buffer, read back, against the formulas of depth: a square at known distances,
// over near, far, format and mapping. Formulas are written out here, not taken from the program.
// VIEWING_LONG_TESTS=N measures N times as many.
#include <cmath>
#include <cstdlib>
#include <map>

#include "gl_test.h"
#include "render/probe.h"
#include "unit/geometry/random.h"

namespace viewing {
namespace {

using testing::object;
using testing::scene_of;

constexpr glm::ivec2 size_px(8, 8);

/// Window depth of a distance z in front of the eye.
double formula(DepthMapping mapping, bool orthographic, double n, double f, double z) {
    if (mapping == DepthMapping::logarithmic) return std::log(z / n) / std::log(f / n);
    if (orthographic) return mapping == DepthMapping::reversed ? (f - z) / (f - n) : (z - n) / (f - n);
    if (mapping == DepthMapping::reversed) return n * (f - z) / ((f - n) * z);
    return f / (f - n) - f * n / ((f - n) * z);
}

class DepthCodes : public testing::GlTest {
protected:
    static PixelReport measure(const Params& params, double distance) {
        SceneObject quad = object("quad", quad_mesh(), {0, 0, 0});
        quad.world_from_model = world_from_model({0, 0, -distance}, {0, 90, 0}, glm::dvec3(distance + 20.0));
        const Scene scene = scene_of({quad});
        const Derived derived = derive_for(params, scene, size_px);
        PixelProbe probe;
        const Status prepared = probe.prepare(renderer(), plan(params, derived), scene, derived, size_px);
        EXPECT_TRUE(prepared);
        return probe.at(size_px / 2, scene);
    }
};

Params at_origin() {
    return testing::params_with({"camera.position=[0,0,0]", "camera.yaw=0", "camera.pitch=0", "shadow.enabled=false",
                                 "reflection.enabled=false", "plane.equation=[0,1,0,1000000]", "plane.extent=0.001"});
}

/// How far a code may be from the exact value: ±4 codes at 24 bits, where float32 arithmetic and GL's rounding add up
/// (facts); fewer bits are made in the shader, which rounds to the nearest code.
double allowed_codes(int bits) {
    return bits <= 16 ? 0.6 : 4.5;
}

std::string describe(const Params& params, double z) {
    const ProjectionParams& projection = params.projection;
    return "mapping " + std::to_string(static_cast<int>(params.depth.mapping)) + " format " +
           std::to_string(static_cast<int>(params.depth.format)) +
           (projection.type == ProjectionType::orthographic ? " orthographic" : " perspective") + " near " +
           std::to_string(projection.near) + " far " + std::to_string(projection.far) + " z " + std::to_string(z);
}

TEST_F(DepthCodes, AreWhatTheFormulaSays) {
    Random random(seed);
    const char* const longer = std::getenv("VIEWING_LONG_TESTS");
    const int trials = 24 * std::max(longer ? std::atoi(longer) : 1, 1);
    std::map<std::string, double> worst;
    for (int format = 0; format < 12; ++format) {
        for (const DepthMapping mapping : {DepthMapping::standard, DepthMapping::reversed, DepthMapping::logarithmic}) {
            for (int trial = 0; trial < trials; ++trial) {
                Params params = at_origin();
                params.depth.format = static_cast<DepthFormat>(format);
                params.depth.mapping = mapping;
                params.depth.func = CompareFunc::lequal;  // with few bits the cleared value is also the farthest code
                ProjectionParams& projection = params.projection;
                const bool orthographic = trial % 4 == 3;
                projection.type = orthographic ? ProjectionType::orthographic : ProjectionType::perspective;
                projection.near = std::exp(random.number(std::log(1e-3), std::log(10.0)));
                projection.far = projection.near * std::exp(random.number(std::log(1.5), std::log(1e5)));
                const double z =
                    std::exp(random.number(std::log(projection.near * 1.01), std::log(projection.far * 0.99)));
                const PixelReport report = measure(params, z);
                const std::string what = "seed " + std::to_string(seed) + " " + describe(params, z);
                ASSERT_EQ(report.object, "quad") << what;
                const double depth = formula(mapping, orthographic, projection.near, projection.far, z);
                const int bits = report.precision.bits;
                std::string kind = std::to_string(bits) + " bits, mapping " + std::to_string(static_cast<int>(mapping));
                if (!report.precision.is_float) {
                    EXPECT_EQ(bits, format < 9 ? 4 + format : format == 9 ? 16 : 24);
                    const double codes = std::abs(report.stored - depth * (std::exp2(bits) - 1.0));
                    EXPECT_LE(codes, allowed_codes(bits)) << what;
                    worst[kind] = std::max(worst[kind], codes);
                } else if (mapping == DepthMapping::standard) {
                    // 2⁻²⁴ is the last place of 0.5 … 1, where standard depth lies mostly.
                    const double places = std::abs(report.window_depth - depth) * std::exp2(24);
                    EXPECT_LE(places, 12.0) << what;
                    worst[kind] = std::max(worst[kind], places);
                } else {
                    // Codes are finer here than float32 arithmetic before them: the distance is what counts.
                    const double off = std::abs(report.eye_z + z) / z;
                    EXPECT_LE(off,
                              2e-6 * (mapping == DepthMapping::logarithmic ? std::log(projection.far / projection.near)
                                      : orthographic                       ? projection.far / z
                                                                           : 1.0))
                        << what;
                    worst[kind] = std::max(worst[kind], off);
                }
            }
        }
    }
    for (const auto& [kind, value] : worst) std::printf("%s: worst %g\n", kind.c_str(), value);
}

TEST_F(DepthCodes, ReportTheDistanceBack) {
    // What the status bar says: eye z from the code, within the width of a few codes as the formula has it.
    Random random(seed);
    for (int trial = 0; trial < 40; ++trial) {
        Params params = at_origin();
        params.depth.format = trial % 2 == 0 ? DepthFormat::d24 : DepthFormat::d16;
        params.depth.mapping = static_cast<DepthMapping>(trial % 3);
        const double n = params.projection.near, f = params.projection.far, z = random.number(1.0, 39.0);
        const PixelReport report = measure(params, z);
        const double levels = std::exp2(params.depth.format == DepthFormat::d24 ? 24 : 16) - 1.0;
        const double width = params.depth.mapping == DepthMapping::logarithmic ? z * std::log(f / n) / levels
                                                                               : z * z * (f - n) / (f * n * levels);
        EXPECT_NEAR(report.step, width, width * 0.01) << describe(params, z);
        EXPECT_NEAR(-report.eye_z, z, 5.0 * width) << describe(params, z);
        EXPECT_NEAR(report.world.z, -z, 5.0 * width);
        EXPECT_TRUE(report.written);
    }
}

TEST_F(DepthCodes, HaveNoneButTheCodesOfTheirFormat) {
    // A square seen at a slant crosses many codes; with b bits there are at most 2ᵇ of them, and neighbours differ
    // by 1.
    for (int bits = 4; bits <= 8; ++bits) {
        Params params = at_origin();
        params.depth.format = static_cast<DepthFormat>(bits - 4);
        SceneObject quad = object("quad", quad_mesh(), {0, 0, 0});
        quad.world_from_model = world_from_model({0, 0, -3}, {70, 90, 0}, glm::dvec3(2.5));
        const Scene scene = scene_of({quad});
        constexpr glm::ivec2 wide(128, 8);
        const Derived derived = derive_for(params, scene, wide);
        PixelProbe probe;
        ASSERT_TRUE(probe.prepare(renderer(), plan(params, derived), scene, derived, wide));
        std::map<std::uint32_t, int> codes;
        for (int x = 0; x < wide.x; ++x) {
            const PixelReport report = probe.at({x, 4}, scene);
            if (report.written) ++codes[report.stored];
            EXPECT_LT(report.stored, 1U << bits);
        }
        EXPECT_GT(codes.size(), 2U) << bits;
        EXPECT_LT(codes.size(), 1U << bits);
    }
}

TEST_F(DepthCodes, OfTheBackgroundIsTheClearedValue) {
    for (const char* const mapping : {"depth.mapping=standard", "depth.mapping=reversed"}) {
        const Params params = testing::params_with({mapping, "plane.extent=0.001", "plane.equation=[0,1,0,1000000]"});
        const Scene empty = scene_of({});
        const Derived derived = derive_for(params, empty, size_px);
        PixelProbe probe;
        ASSERT_TRUE(probe.prepare(renderer(), plan(params, derived), empty, derived, size_px));
        const PixelReport report = probe.at({3, 3}, empty);
        EXPECT_FALSE(report.written);
        EXPECT_EQ(report.object, "");
        EXPECT_EQ(report.window_depth, std::string(mapping) == "depth.mapping=reversed" ? 0.0 : 1.0);
        EXPECT_EQ(report.color, (Color{0x1b, 0x1f, 0x27}));
    }
}

TEST_F(DepthCodes, ProbeNamesWhatIsThere) {
    const Params params = testing::params_with({"view.samples=4", "cull.enabled=false"});
    const Scene scene = testing::scene_named("torus-and-boxes");
    constexpr glm::ivec2 larger(320, 180);
    const Derived derived = derive_for(params, scene, larger);
    PixelProbe probe;
    ASSERT_TRUE(probe.prepare(renderer(), plan(params, derived), scene, derived, larger));
    const auto report_at = [&](const glm::dvec3& point) {
        return probe.at(testing::pixel_of(point, derived, larger), scene);
    };
    const PixelReport box = report_at({1.4, 1.3, -0.65});
    EXPECT_EQ(box.object, "box");
    EXPECT_TRUE(box.front_facing);
    EXPECT_EQ(box.stencil, 0);  // the patch does not reach behind its top
    EXPECT_NEAR(box.world.y, 1.3, 0.02);
    const PixelReport ground = report_at({0.0, 0.0, 2.5});
    EXPECT_EQ(ground.object, "plane");
    EXPECT_NEAR(ground.world.y, 0.0, 1e-3);
    EXPECT_LT(glm::distance(ground.world, {0.0, 0.0, 2.5}), 0.05);
    EXPECT_EQ(ground.stencil, 1);
    EXPECT_EQ(report_at({0.72, 0.8, 1.08}).object, "small box");
    EXPECT_EQ(report_at({0.72, 0.8, 1.08}).stencil, 1);
    const PixelReport sky = probe.at({2, 2}, scene);
    EXPECT_EQ(sky.object, "");
    EXPECT_EQ(sky.eye_z, 0.0);
}

}  // namespace
}  // namespace viewing
