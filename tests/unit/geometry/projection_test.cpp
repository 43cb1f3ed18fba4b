// Projections, checked by the images of near and far; depth precision, checked against an independently computed table.
#include "geometry/projection.h"

#include <gtest/gtest.h>

#include <limits>

#include "unit/geometry/random.h"

namespace viewing {
namespace {

constexpr DepthMapping mappings[] = {DepthMapping::standard, DepthMapping::reversed, DepthMapping::logarithmic};

double ndc_z(const glm::dmat4& clip, double distance) {
    const glm::dvec4 p = clip * glm::dvec4(0.1, 0.2, -distance, 1);
    return p.z / p.w;
}

TEST(Projection, NearAndFarMapToTheEndsOfTheClipRange) {
    for (const bool orthographic : {false, true}) {
        const Lens lens{.orthographic = orthographic, .near = 0.5, .far = 40};
        EXPECT_NEAR(ndc_z(clip_from_view(lens, 1.5), 0.5), -1, 1e-14);
        EXPECT_NEAR(ndc_z(clip_from_view(lens, 1.5), 40), 1, 1e-14);
        EXPECT_NEAR(ndc_z(clip_from_view_reversed(lens, 1.5), 0.5), 1, 1e-14);
        EXPECT_NEAR(ndc_z(clip_from_view_reversed(lens, 1.5), 40), 0, 1e-14);
    }
}

TEST(Projection, FieldOfViewAndHeightAreFullVertical) {
    // With 90°, the frustum is 14 high at distance 7 and, with aspect 2, 28 wide.
    for (const glm::dmat4& clip : {clip_from_view({.fovy_deg = 90, .near = 1, .far = 10}, 2.0),
                                   clip_from_view_reversed({.fovy_deg = 90, .near = 1, .far = 10}, 2.0)}) {
        const glm::dvec4 corner = clip * glm::dvec4(14, 7, -7, 1);
        EXPECT_NEAR(corner.x / corner.w, 1, 1e-14);
        EXPECT_NEAR(corner.y / corner.w, 1, 1e-14);
        EXPECT_EQ(corner.w, 7.0);
    }
    for (const glm::dmat4& clip :
         {clip_from_view({.orthographic = true, .height = 6, .near = 1, .far = 10}, 2.0),
          clip_from_view_reversed({.orthographic = true, .height = 6, .near = 1, .far = 10}, 2.0)}) {
        const glm::dvec4 corner = clip * glm::dvec4(6, 3, -7, 1);
        EXPECT_NEAR(corner.x, 1, 1e-14);
        EXPECT_NEAR(corner.y, 1, 1e-14);
        EXPECT_EQ(corner.w, 1.0);
    }
}

// The corners of the cube −1 … 1 are the images of the frustum's corners, written down by hand from the window.
TEST(Projection, AWindowsEdgesAreThePicturesEdges) {
    SCOPED_TRACE(seed);
    Random random(seed);
    for (int i = 0; i < 200; ++i) {
        const bool orthographic = i % 2 == 0;
        const double l = random.number(-3, 2), b = random.number(-3, 2);
        const double r = l + random.number(0.1, 4), t = b + random.number(0.1, 4);
        const double n = orthographic && i % 4 == 0 ? random.number(-5, 0) : random.number(0.1, 2), f = 2.0 + 9.0 * i;
        const Lens lens{.orthographic = orthographic, .near = n, .far = f, .window = Edges{l, r, b, t}};
        for (int corner = 0; corner < 8; ++corner) {
            const bool is_far = (corner & 4) != 0;
            const double z = is_far ? f : n, scale = orthographic ? 1.0 : z / n;
            const glm::dvec4 point(scale * (corner & 1 ? r : l), scale * (corner & 2 ? t : b), -z, 1.0);
            const glm::dvec4 clip = clip_from_view(lens, 7.0) * point,
                             swapped = clip_from_view_reversed(lens, 7.0) * point;
            const double x = corner & 1 ? 1.0 : -1.0, y = corner & 2 ? 1.0 : -1.0;
            EXPECT_LT(glm::distance(glm::dvec3(clip) / clip.w, glm::dvec3(x, y, is_far ? 1.0 : -1.0)), 1e-9) << i;
            EXPECT_LT(glm::distance(glm::dvec3(swapped) / swapped.w, glm::dvec3(x, y, is_far ? 0.0 : 1.0)), 1e-9) << i;
            EXPECT_LT(glm::distance(lens.edges_at(z, 7.0).at({x, y}), glm::dvec2(point)), 1e-9 * f) << i;
        }
    }
}

// A centered projection window gives the same P as the corresponding angle or height.
TEST(Projection, ACenteredWindowIsAnAngleOrAHeight) {
    for (const bool orthographic : {false, true}) {
        Lens lens{.orthographic = orthographic, .fovy_deg = 90.0, .height = 6.0, .near = 0.5, .far = 40.0};
        const glm::dmat4 without = clip_from_view(lens, 2.0), reversed = clip_from_view_reversed(lens, 2.0);
        lens.window = orthographic ? Edges{-6.0, 6.0, -3.0, 3.0} : Edges{-1.0, 1.0, -0.5, 0.5};  // tan 45° = 1
        for (int column = 0; column < 4; ++column) {
            EXPECT_LT(glm::distance(clip_from_view(lens, 1.0)[column], without[column]), 1e-12);
            EXPECT_LT(glm::distance(clip_from_view_reversed(lens, 1.0)[column], reversed[column]), 1e-12);
        }
    }
}

TEST(WindowDepth, AgreesWithTheMatrices) {
    SCOPED_TRACE(seed);
    Random random(seed);
    for (const bool orthographic : {false, true}) {
        const Lens lens{.orthographic = orthographic, .near = 0.3, .far = 70};
        for (int i = 0; i < 50; ++i) {
            const double z = random.number(0.3, 70);
            EXPECT_NEAR(window_depth(lens, DepthMapping::standard, z), ndc_z(clip_from_view(lens, 1), z) / 2 + 0.5,
                        1e-13);
            EXPECT_NEAR(window_depth(lens, DepthMapping::reversed, z), ndc_z(clip_from_view_reversed(lens, 1), z),
                        1e-13);
        }
    }
}

TEST(WindowDepth, WorkedValues) {
    // With n = 1, f = 101 and z = 2, d = f/(f−n) − f n/((f−n) z) = 1.01 − 0.505.
    EXPECT_NEAR(window_depth({.near = 1, .far = 101}, DepthMapping::standard, 2), 0.505, 1e-15);
    EXPECT_NEAR(window_depth({.near = 1, .far = 101}, DepthMapping::reversed, 2), 0.495, 1e-15);
    EXPECT_NEAR(window_depth({.near = 1, .far = 100}, DepthMapping::logarithmic, 10), 0.5, 1e-15);
    EXPECT_NEAR(window_depth({.orthographic = true, .near = 1, .far = 11}, DepthMapping::standard, 2), 0.1, 1e-15);
    EXPECT_NEAR(window_depth({.orthographic = true, .near = 1, .far = 11}, DepthMapping::reversed, 2), 0.9, 1e-15);
}

constexpr double infinity = std::numeric_limits<double>::infinity();

// An infinite far is the limit of ever larger far values, and its far plane consists of all directions (w = 0).
TEST(Projection, AnInfiniteFarIsTheLimit) {
    for (const bool has_window : {false, true}) {
        Lens lens{.near = 0.25, .far = infinity};
        if (has_window) lens.window = Edges{-0.1, 0.4, -0.3, 0.2};
        Lens finite = lens;
        finite.far = 1e12;
        for (const bool reversed : {false, true}) {
            const auto p = [&](const Lens& of) {
                return reversed ? clip_from_view_reversed(of, 1.5) : clip_from_view(of, 1.5);
            };
            for (int column = 0; column < 4; ++column)
                EXPECT_LT(glm::distance(p(lens)[column], p(finite)[column]), 1e-11) << column;
            EXPECT_NEAR(ndc_z(p(lens), 0.25), reversed ? 1.0 : -1.0, 1e-14);
            const glm::dvec4 direction = p(lens) * glm::dvec4(0.3, -0.2, -1.0, 0.0);
            EXPECT_EQ(direction.z / direction.w, reversed ? 0.0 : 1.0);
            EXPECT_GT(std::abs(glm::determinant(p(lens))), 1e-3) << "P keeps an inverse";
        }
    }
}

TEST(WindowDepth, OfAnInfiniteFar) {
    const Lens lens{.near = 1, .far = infinity};
    EXPECT_EQ(window_depth(lens, DepthMapping::standard, 1), 0.0);
    EXPECT_EQ(window_depth(lens, DepthMapping::standard, 4), 0.75);
    EXPECT_EQ(window_depth(lens, DepthMapping::reversed, 4), 0.25);
    EXPECT_EQ(window_depth(lens, DepthMapping::standard, infinity), 1.0);
    EXPECT_EQ(window_depth(lens, DepthMapping::reversed, infinity), 0.0);
    EXPECT_EQ(distance_of_window_depth(lens, DepthMapping::standard, 1.0), infinity);
    // One code of 24 bits at z = 10 is z²/(n (2²⁴ − 1)) wide. With far = 100, it is 1 % narrower, so an infinite far
    // costs little.
    EXPECT_NEAR(depth_step(lens, DepthMapping::standard, {24, false}, 10) * 16777215.0, 100.0, 1e-9);
    EXPECT_NEAR(depth_step({.near = 1, .far = 100}, DepthMapping::standard, {24, false}, 10) * 16777215.0, 99.0, 1e-9);
    for (const DepthMapping mapping : mappings) {
        const double depth = window_depth(lens, mapping, 10), step = depth_step(lens, mapping, {24, false}, 10);
        EXPECT_NEAR(distance_of_window_depth(lens, mapping, depth), 10.0, 1e-9);
        EXPECT_TRUE(std::isfinite(step) && step > 0.0);
        const double farther = window_depth(lens, mapping, 10 + 1e-4) - depth;
        EXPECT_NEAR(std::abs(farther) / 1e-4, 1.0 / 16777215.0 / step, 1e-6);
    }
}

TEST(WindowDepth, OutsideTheRangeIsOutsideZeroToOne) {
    for (const bool orthographic : {false, true}) {
        const Lens lens{.orthographic = orthographic, .near = 1, .far = 10};
        for (const DepthMapping mapping : mappings) {
            const bool reversed = mapping == DepthMapping::reversed;
            for (const double z : {-3.0, 0.0, 0.5}) {
                const double depth = window_depth(lens, mapping, z);
                EXPECT_TRUE(reversed ? depth > 1 : depth < 0) << depth;
            }
            const double beyond = window_depth(lens, mapping, 20);
            EXPECT_TRUE(reversed ? beyond < 0 : beyond > 1) << beyond;
        }
    }
}

TEST(WindowDepth, RoundTrip) {
    for (const bool orthographic : {false, true}) {
        const Lens lens{.orthographic = orthographic, .near = 0.1, .far = 100};
        for (const DepthMapping mapping : mappings) {
            for (const double z : {0.1, 0.5, 3.0, 42.0, 100.0}) {
                EXPECT_NEAR(distance_of_window_depth(lens, mapping, window_depth(lens, mapping, z)), z, 1e-10 * z);
            }
        }
    }
}

TEST(DepthStep, MatchesTheTable) {
    struct Row {
        double near, far, z, bits16, bits24, float_standard, float_reversed;  // 0 if storage does not limit the step
    };
    const Row rows[] = {
        {20, 100, 60, 2.197e-3, 8.583e-6, 8.583e-6, 2.146e-6}, {1, 100, 10, 1.511e-3, 5.901e-6, 5.901e-6, 7.376e-7},
        {1, 100, 100, 1.511e-1, 5.901e-4, 5.901e-4, 0},        {0.1, 100, 10, 1.524e-2, 5.955e-5, 5.955e-5, 9.304e-7},
        {0.1, 100, 100, 1.524, 5.955e-3, 5.955e-3, 0},         {0.01, 100, 10, 1.526e-1, 5.960e-4, 5.960e-4, 5.820e-7},
        {0.001, 100, 100, 152.6, 5.960e-1, 5.960e-1, 0},       {0.01, 10000, 500, 381.5, 1.490, 1.490, 4.547e-5},
    };
    for (const Row& row : rows) {
        SCOPED_TRACE(::testing::Message() << row.near << " " << row.far << " " << row.z);
        const Lens lens{.near = row.near, .far = row.far};
        const auto step = [&](DepthMapping mapping, int bits, bool is_float) {
            return depth_step(lens, mapping, {bits, is_float}, row.z);
        };
        EXPECT_NEAR(step(DepthMapping::standard, 16, false), row.bits16, 1e-2 * row.bits16);
        EXPECT_NEAR(step(DepthMapping::standard, 24, false), row.bits24, 1e-2 * row.bits24);
        EXPECT_NEAR(step(DepthMapping::standard, 32, true), row.float_standard, 1e-2 * row.float_standard);
        if (row.float_reversed > 0) {
            EXPECT_NEAR(step(DepthMapping::reversed, 32, true), row.float_reversed, 1e-2 * row.float_reversed);
        }
        EXPECT_GT(step(DepthMapping::reversed, 32, true), 0.0);
    }
}

TEST(DepthStep, FloatsAreLimitedByTheEyeDepth) {
    const auto step = [](double z, DepthMapping mapping, DepthPrecision precision) {
        return resolvable_depth_step({.near = 0.1, .far = 100}, mapping, precision, z);
    };
    // Floats between 64 and 128 are 2⁻¹⁷ apart, and a step is at least half of that at such an eye depth, although the
    // stored floats near a window depth of 0 are far finer.
    EXPECT_DOUBLE_EQ(step(100, DepthMapping::reversed, {32, true}), std::exp2(-18));
    EXPECT_DOUBLE_EQ(step(0.1, DepthMapping::standard, {32, true}), std::exp2(-28));
    EXPECT_NEAR(step(10, DepthMapping::reversed, {32, true}), 9.304e-7, 1e-2 * 9.304e-7) << "storage is the limit";
    EXPECT_NEAR(step(100, DepthMapping::standard, {32, true}), 5.955e-3, 1e-2 * 5.955e-3);
    EXPECT_NEAR(step(100, DepthMapping::standard, {24, false}), 5.955e-3, 1e-2 * 5.955e-3);
}

TEST(DepthStep, IsTheWidthOfOneCode) {
    // Brute force: divide the distance between 50 codes nearer and 50 codes farther by one hundred.
    for (const bool orthographic : {false, true}) {
        const Lens lens{.orthographic = orthographic, .near = 0.5, .far = 40};
        for (const DepthMapping mapping : mappings) {
            const double z = 8, codes = 65535, at_z = window_depth(lens, mapping, z);
            const double lo = distance_of_window_depth(lens, mapping, at_z - 50 / codes);
            const double hi = distance_of_window_depth(lens, mapping, at_z + 50 / codes);
            EXPECT_NEAR(depth_step(lens, mapping, {16, false}, z), std::abs(hi - lo) / 100,
                        1e-3 * std::abs(hi - lo) / 100);
        }
    }
}

TEST(DepthStep, WorkedValuesOfTheOtherMappings) {
    const Lens lens{.orthographic = true, .near = 1, .far = 101};
    EXPECT_NEAR(depth_step(lens, DepthMapping::standard, {8, false}, 50), 100 / 255.0, 1e-12);
    EXPECT_NEAR(depth_step(lens, DepthMapping::reversed, {8, false}, 3), 100 / 255.0, 1e-12);
    EXPECT_NEAR(depth_step({.near = 1, .far = 100}, DepthMapping::logarithmic, {16, false}, 10),
                10 * std::log(100.0) / 65535, 1e-12);
}

TEST(DepthStep, IsPositiveAndFiniteForAnyTarget) {
    for (const bool orthographic : {false, true}) {
        const Lens lens{.orthographic = orthographic, .near = 1e-6, .far = 1e9};
        for (const DepthMapping mapping : mappings) {
            for (const DepthPrecision precision :
                 {DepthPrecision{4, false}, DepthPrecision{24, false}, DepthPrecision{32, true}}) {
                for (const double z : {-5.0, 0.0, 1e-9, 1e-6, 1.0, 1e9, 1e12}) {
                    const double step = depth_step(lens, mapping, precision, z);
                    EXPECT_TRUE(step > 0 && std::isfinite(step)) << step << " at " << z;
                }
            }
        }
    }
}

TEST(Projection, AnOrthographicNearMayBeZeroOrNegative) {
    for (const double near : {0.0, -1.0, -50.0}) {
        const Lens lens{.orthographic = true, .height = 4.0, .near = near, .far = 20.0};
        // glOrtho(−4, 4, −2, 2, near, 20), as on its manual page.
        const glm::dmat4 p = clip_from_view(lens, 2.0);
        EXPECT_DOUBLE_EQ(p[2][2], -2.0 / (20.0 - near));
        EXPECT_DOUBLE_EQ(p[3][2], -(20.0 + near) / (20.0 - near));
        EXPECT_DOUBLE_EQ(p[0][0], 0.25);
        const DepthPrecision bits{16, false};
        for (const DepthMapping mapping : {DepthMapping::standard, DepthMapping::reversed}) {
            for (const double z : {near, 0.5 * near, 0.0, 7.0, 20.0}) {
                const double depth = window_depth(lens, mapping, z);
                const double linear = (z - near) / (20.0 - near);
                EXPECT_NEAR(depth, mapping == DepthMapping::reversed ? 1.0 - linear : linear, 1e-15);
                EXPECT_NEAR(distance_of_window_depth(lens, mapping, depth), z, 1e-13);
                EXPECT_NEAR(depth_step(lens, mapping, bits, z), (20.0 - near) / 65535.0, 1e-15);
            }
        }
        EXPECT_TRUE(std::isfinite(window_depth(lens, DepthMapping::logarithmic, 3.0)));
    }
}

}  // namespace
}  // namespace viewing
