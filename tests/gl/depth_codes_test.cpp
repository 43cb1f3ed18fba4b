// Compares the codes read back from the depth buffer with the depth formulas, for a square at known distances and for
// many values of near, far, format and mapping. The formulas are written out here, not taken from the program. With
// VIEWING_LONG_TESTS=N, the test measures N times as many values.
#include <bit>
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

constexpr glm::ivec2 codes_px(8, 8);

using Exact = long double;

/// Returns the window depth at a distance z in front of the eye.
Exact formula(DepthMapping mapping, bool orthographic, Exact n, Exact f, Exact z) {
    if (mapping == DepthMapping::logarithmic) return std::log(z / n) / std::log(f / n);
    if (orthographic) return mapping == DepthMapping::reversed ? (f - z) / (f - n) : (z - n) / (f - n);
    if (mapping == DepthMapping::reversed) return n * (f - z) / ((f - n) * z);
    return f / (f - n) - f * n / ((f - n) * z);
}

/// Returns the change in window depth when z changes by a relative 2⁻²⁴, the precision of eye depth in float32.
Exact change_with_a_place_of_z(DepthMapping mapping, bool orthographic, Exact n, Exact f, Exact z) {
    const Exact place = std::exp2(Exact(-24));
    if (mapping == DepthMapping::logarithmic) return place / std::log(f / n);
    return orthographic ? place * z / (f - n) : place * f * n / ((f - n) * z);
}

class DepthCodes : public testing::GlTest {
protected:
    static PixelReport measure(const Params& params, double distance) {
        SceneObject quad = object("quad", quad_mesh(), {0, 0, 0});
        quad.world_from_model = world_from_model({0, 0, -distance}, {0, 90, 0}, glm::dvec3(distance + 20.0));
        const Scene scene = scene_of({quad});
        const Derived derived = derive_for(params, scene, codes_px);
        PixelProbe probe;
        const Status prepared = probe.prepare(renderer(), plan(params, derived), scene, derived, codes_px);
        EXPECT_TRUE(prepared);
        return probe.at(codes_px / 2, scene);
    }
};

Params at_origin() {
    return testing::params_with({"camera.position=[0,0,0]", "camera.yaw=0", "camera.pitch=0", "shadow.enabled=false",
                                 "reflection.enabled=false", "plane.equation=[0,1,0,1000000]", "plane.extent=0.001"});
}

/// Returns how far a code may be from the exact value: 1 at 16 bits and 4.5 at 24, since float32 arithmetic adds its
/// error to GL's rounding. Where the arithmetic error exceeds one code, as in a short logarithmic range, the test
/// multiplies this limit by that error. For fewer bits, the shader computes the codes and rounds to the nearest code.
Exact allowed_codes(int bits) {
    return bits < 16 ? 0.6L : bits == 16 ? 1.0L : 4.5L;
}

/// Returns the unit in the last place of a float's 24 bits at this depth.
Exact last_place(Exact depth) {
    return std::exp2(std::floor(std::log2(std::max(depth, std::exp2(Exact(-126))))) - 23);
}

std::string describe(const Params& params, double z) {
    const ProjectionParams& projection = params.projection;
    return "mapping " + std::to_string(static_cast<int>(params.depth.mapping)) + " format " +
           std::to_string(static_cast<int>(params.depth.format)) +
           (projection.type == ProjectionType::orthographic ? " orthographic" : " perspective") + " near " +
           std::to_string(projection.near) + " far " + std::to_string(projection.far) + " z " + std::to_string(z);
}

/// A state to measure, with the square's distance and its expected depth.
struct Sample {
    Params params;
    double distance = 1.0;
    Exact depth = 0.0;

    static Sample any(Random& random, DepthFormat format, DepthMapping mapping, bool orthographic) {
        Sample made{at_origin()};
        made.params.depth.format = format;
        made.params.depth.mapping = mapping;
        made.params.depth.func = CompareFunc::lequal;  // with few bits the cleared value is also the farthest code
        ProjectionParams& projection = made.params.projection;
        projection.type = orthographic ? ProjectionType::orthographic : ProjectionType::perspective;
        projection.near = std::exp(random.number(std::log(1e-3), std::log(10.0)));
        projection.far = projection.near * std::exp(random.number(std::log(1.5), std::log(1e5)));
        const double n = projection.near, f = projection.far;
        made.distance = std::exp(random.number(std::log(n * 1.01), std::log(f * 0.99)));
        made.depth = formula(mapping, orthographic, n, f, made.distance);
        return made;
    }

    bool orthographic() const { return params.projection.type == ProjectionType::orthographic; }

    /// Returns the error that float32 arithmetic may cause in this depth before it is stored: eye depth has 24 bits,
    /// and so does the sum that maps −1 … 1 to 0 … 1 in the standard mapping.
    Exact arithmetic() const {
        const DepthMapping mapping = params.depth.mapping;
        const Exact sum = mapping == DepthMapping::standard ? std::exp2(Exact(-24)) : 0.0L;
        const ProjectionParams& projection = params.projection;
        return sum + change_with_a_place_of_z(mapping, orthographic(), projection.near, projection.far, distance);
    }
};

/// The worst deviation for one kind of depth.
struct Worst {
    Exact off = 0.0;            ///< in codes, or in ulps of float32
    Exact by_arithmetic = 0.0;  ///< as a multiple of the arithmetic error, where that exceeds one ulp
    Exact places = 0.0;         ///< the same deviation in ulps
};

TEST_F(DepthCodes, MatchTheFormula) {
    Random random(seed);
    const int count = testing::trials(60);
    std::map<std::string, Worst> worst;
    for (int format = 0; format < 12; ++format) {
        for (const DepthMapping mapping : {DepthMapping::standard, DepthMapping::reversed, DepthMapping::logarithmic}) {
            for (int trial = 0; trial < count; ++trial) {
                const Sample sample = Sample::any(random, static_cast<DepthFormat>(format), mapping, trial % 4 == 3);
                const PixelReport report = measure(sample.params, sample.distance);
                const std::string what =
                    "seed " + std::to_string(seed) + " " + describe(sample.params, sample.distance);
                ASSERT_EQ(report.object, "quad") << what;
                const int bits = report.precision.bits;
                Worst& kind =
                    worst[std::to_string(bits) + " bits, mapping " + std::to_string(static_cast<int>(mapping))];
                if (!report.precision.is_float) {
                    EXPECT_EQ(bits, format < 9 ? 4 + format : format == 9 ? 16 : 24);
                    const Exact codes = std::abs(report.stored - sample.depth * (std::exp2(Exact(bits)) - 1.0L));
                    const Exact arithmetic_codes = sample.arithmetic() * std::exp2(Exact(bits));
                    EXPECT_LE(codes, allowed_codes(bits) * std::max(1.0L, arithmetic_codes)) << what;
                    kind.off = std::max(kind.off, codes);
                    continue;
                }
                const Exact off = std::abs(std::bit_cast<float>(report.stored) - sample.depth);
                const Exact place = last_place(sample.depth), arithmetic = sample.arithmetic();
                EXPECT_LE(off, 12.0L * std::max(place, arithmetic)) << what;
                if (arithmetic <= place) kind.off = std::max(kind.off, off / place);
                if (arithmetic <= place) continue;
                kind.by_arithmetic = std::max(kind.by_arithmetic, off / arithmetic);
                kind.places = std::max(kind.places, off / place);
            }
        }
    }
    for (const auto& [name, kind] : worst) {
        std::printf("%s: worst %Lg", name.c_str(), kind.off);
        if (kind.places > 0.0)
            std::printf("; %Lg times the arithmetic where that is coarser, which is %Lg places", kind.by_arithmetic,
                        kind.places);
        std::printf("\n");
    }
}

TEST_F(DepthCodes, ReproduceTheDistance) {
    // The status bar computes eye z from the code, so eye z is accurate to within the width of a few codes. The width
    // of one code follows from a formula.
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

TEST_F(DepthCodes, UseOnlyTheCodesOfTheirFormat) {
    // A slanted square crosses many codes; with b bits there are at most 2ᵇ, and neighbors differ by 1.
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

TEST_F(DepthCodes, EqualTheClearedValueOnTheBackground) {
    for (const char* const mapping : {"depth.mapping=standard", "depth.mapping=reversed"}) {
        const Params params = testing::params_with({mapping, "plane.extent=0.001", "plane.equation=[0,1,0,1000000]"});
        const Scene empty = scene_of({});
        const Derived derived = derive_for(params, empty, codes_px);
        PixelProbe probe;
        ASSERT_TRUE(probe.prepare(renderer(), plan(params, derived), empty, derived, codes_px));
        const PixelReport report = probe.at({3, 3}, empty);
        EXPECT_FALSE(report.written);
        EXPECT_EQ(report.object, "");
        EXPECT_EQ(report.window_depth, std::string(mapping) == "depth.mapping=reversed" ? 0.0 : 1.0);
        EXPECT_EQ(report.color, (Color{0x1b, 0x1f, 0x27}));
    }
}

TEST_F(DepthCodes, ProbeNamesTheSurface) {
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
    EXPECT_EQ(box.stencil, 0);  // the patch does not extend behind the box's top
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
