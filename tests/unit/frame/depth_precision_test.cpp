// Compares the steps and codes between near and far with worked examples and with counts.
#include "topics/depth/numbers/depth_precision.h"

#include <algorithm>
#include <bit>

#include "text/numbers.h"
#include "unit/frame/frame_test.h"

namespace viewing {
namespace {

using testing::params_with;

PrecisionCurves curves_of(const Params& params) {
    const Scene scene;
    return precision_curves(params, derive(params, scene, {}));
}

/// Interpolates between the two neighboring points.
double value_at(const StepPoints& points, double z) {
    for (std::size_t i = 1; i < points.size(); ++i)
        if (points[i].x >= z)
            return glm::mix(points[i - 1].y, points[i].y, (z - points[i - 1].x) / (points[i].x - points[i - 1].x));
    ADD_FAILURE() << "no point beyond " << z;
    return 0.0;
}

TEST(PrecisionCurves, MatchWorkedSteps) {
    // near, far, z and the step at 16 bits
    const double rows[][4] = {{20, 100, 60, 2.197e-3}, {1, 100, 10, 1.511e-3}, {0.1, 100, 10, 1.524e-2}};
    for (const auto& [near, far, z, step] : rows) {
        Params params = params_with({"depth.format=d16"});
        params.projection.near = near;
        params.projection.far = far;
        const PrecisionCurves curves = curves_of(params);
        EXPECT_NEAR(value_at(curves.quantization, z), step, 0.02 * step);
        EXPECT_NEAR(value_at(curves.current.points, z), step, 0.05 * step) << "arithmetic adds little to 16 bits";
    }
}

TEST(PrecisionCurves, AddUpAndStayBetweenNearAndFar) {
    for (const char* format : {"d4", "d16", "d24", "d32f"}) {
        for (const char* mapping : {"standard", "reversed", "logarithmic"}) {
            SCOPED_TRACE(std::string(format) + " " + mapping);
            const Params params =
                params_with({std::string("depth.format=") + format, std::string("depth.mapping=") + mapping});
            const PrecisionCurves curves = curves_of(params);
            const StepPoints& whole = curves.current.points;
            ASSERT_GT(whole.size(), 100U);
            ASSERT_EQ(whole.size(), curves.quantization.size());
            ASSERT_EQ(whole.size(), curves.arithmetic.size());
            for (std::size_t i = 0; i < whole.size(); ++i) {
                EXPECT_GT(whole[i].y, 0.0);
                EXPECT_EQ(whole[i].y, curves.quantization[i].y + curves.arithmetic[i].y);
            }
            EXPECT_GE(whole.front().x, params.projection.near);
            EXPECT_NEAR(whole.back().x, params.projection.far, 1e-9);
            const bool is_among_nine = std::string(format) != "d4";
            EXPECT_EQ(curves.others.size(), is_among_nine ? 8U : 9U);
        }
    }
}

TEST(PrecisionCurves, FloatArithmeticLimitsReversedDepthFarAway) {
    const PrecisionCurves curves = curves_of(
        params_with({"depth.format=d32f", "depth.mapping=reversed", "projection.near=0.1", "projection.far=100"}));
    EXPECT_GT(curves.arithmetic.back().y, 100.0 * curves.quantization.back().y);
}

TEST(DepthCodes, AreAllListedForFewBits) {
    const Lens lens{.near = 1.0, .far = 100.0};
    const DepthCodes codes = depth_codes(lens, DepthMapping::standard, {4, false}, 64);
    ASSERT_EQ(codes.codes.size(), 16U);
    EXPECT_EQ(codes.codes_per_tick, 1);
    for (std::uint32_t code = 0; code < 16; ++code) {
        EXPECT_EQ(codes.codes[code], code);
        EXPECT_NEAR(codes.eye_distances[code], 100.0 / (100.0 - 99.0 * code / 15.0), 1e-9);
    }
}

TEST(DepthCodes, RunFromNearToFarInEveryFormat) {
    const Lens lens{.near = 0.1, .far = 1000.0};
    for (const DepthPrecision precision :
         {DepthPrecision{7, false}, DepthPrecision{16, false}, DepthPrecision{24, false}, DepthPrecision{32, true}}) {
        for (const DepthMapping mapping : {DepthMapping::standard, DepthMapping::reversed, DepthMapping::logarithmic}) {
            SCOPED_TRACE(std::to_string(precision.bits) + " " + std::to_string(static_cast<int>(mapping)));
            const DepthCodes codes = depth_codes(lens, mapping, precision, 40);
            ASSERT_EQ(codes.codes.size(), 33U);
            EXPECT_TRUE(std::ranges::is_sorted(codes.eye_distances));
            EXPECT_NEAR(codes.eye_distances.front(), 0.1, 1e-9);
            EXPECT_NEAR(codes.eye_distances.back(), 1000.0, 1e-3);
            const std::uint32_t last = precision.is_float ? std::bit_cast<std::uint32_t>(1.0F)
                                                          : (1U << static_cast<unsigned>(precision.bits)) - 1;
            EXPECT_EQ(std::max(codes.codes.front(), codes.codes.back()), last);
            EXPECT_EQ(std::min(codes.codes.front(), codes.codes.back()), 0U);
            EXPECT_EQ(codes.codes.front() > codes.codes.back(), mapping == DepthMapping::reversed);
            for (std::size_t i = 1; i < codes.codes.size(); ++i)
                EXPECT_NEAR(std::abs(static_cast<double>(codes.codes[i]) - codes.codes[i - 1]),
                            static_cast<double>(codes.codes_per_tick), 1.0 + 1e-9);
        }
    }
    EXPECT_EQ(depth_codes(lens, DepthMapping::standard, {24, false}, 64).codes_per_tick, 262'144);
    EXPECT_EQ(depth_codes(lens, DepthMapping::standard, {24, false}, 0).codes.size(), 3U);
}

TEST(DepthCodes, SentenceSaysWhereHalfOfThemAre) {
    const Lens lens{.near = 1.0, .far = 3.0};
    EXPECT_EQ(say(codes_sentence(lens, DepthMapping::standard, {24, false})),
              "Half of all codes lie between near and z = 1.5.");  // 2nf/(n+f)
    EXPECT_EQ(say(codes_sentence(lens, DepthMapping::reversed, {16, false})),
              "Half of all codes lie between near and z = 1.5.");
    EXPECT_EQ(say(codes_sentence({.near = 1.0, .far = 100.0}, DepthMapping::logarithmic, {24, false})),
              "Half of all codes lie between near and z = 10.");
    // At z = 2, the standard depth is 0.75. Half of the floats from 0.5 to 1, that is 2²², are beyond it.
    EXPECT_EQ(
        say(codes_sentence(lens, DepthMapping::standard, {32, true})),
        "Of the 1,065,353,216 floats from 0 to 1, 4,194,304 lie in the farther half of the distance, beyond z = 2.");
    // The reversed depth there is 0.25. Of the 127 ranges with 2²³ floats each, 125 lie below it.
    EXPECT_EQ(say(codes_sentence(lens, DepthMapping::reversed, {32, true})),
              "Of the 1,065,353,216 floats from 0 to 1, 1,048,576,000 lie in the farther half of the distance, beyond "
              "z = 2.");
}

TEST(Figures, MatchTheSentence) {
    EXPECT_EQ(figures(0.25), "0.25");
    EXPECT_EQ(figures(3456.0), "3500");
    EXPECT_EQ(figures(0.996), "1");
    EXPECT_EQ(figures(9.96), "10");
    EXPECT_EQ(figures(80.0), "80");
    EXPECT_EQ(figures(1.23456, 3), "1.23");
    EXPECT_EQ(figures(1.2e-7), "1.2·10⁻⁷");
    EXPECT_EQ(figures(3e12), "3·10¹²");
    EXPECT_EQ(figures(0.0), "0");
}

}  // namespace
}  // namespace viewing
