// Compares the histogram of a depth buffer with depths that are converted to distances one by one, in double precision
// and by formulas written out here.
#include "frame/depth_counts.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <numeric>

#include "unit/geometry/random.h"

namespace viewing {
namespace {

constexpr std::size_t bins = 128;

/// Returns the position of a window depth on the plan's scale: 0 at the start, 1 at the end.
double place_of(double depth, const FramePlan& plan) {
    if (plan.depth_scale == DepthScale::window) return depth;
    const double n = plan.lens.near, f = plan.lens.far;
    if (plan.depth_mapping == DepthMapping::logarithmic) return (n * std::pow(f / n, depth) - n) / (f - n);
    const double standard = plan.depth_mapping == DepthMapping::reversed ? 1.0 - depth : depth;
    if (plan.lens.orthographic) return standard;
    return (n * f / (f - standard * (f - n)) - n) / (f - n);
}

struct CountCase {
    FramePlan plan;
    DepthPrecision read_as;
    std::string name;
};

std::vector<CountCase> count_cases() {
    std::vector<CountCase> all;
    for (const bool linear : {true, false})
        for (const bool orthographic : {false, true})
            for (const int mapping : {0, 1, 2})
                for (const DepthPrecision read_as : {DepthPrecision{16, false}, {24, false}, {24, true}})
                    for (const glm::dvec2 range : {glm::dvec2(0.5, 40), glm::dvec2(0.001, 10000), glm::dvec2(20, 21)}) {
                        CountCase made;
                        made.plan.depth_scale = linear ? DepthScale::linear : DepthScale::window;
                        made.plan.depth_mapping = static_cast<DepthMapping>(mapping);
                        made.plan.clear_depth_value = mapping == 1 ? 0.0 : 1.0;
                        made.plan.lens.orthographic = orthographic;
                        made.plan.lens.near = range.x;
                        made.plan.lens.far = range.y;
                        made.read_as = read_as;
                        made.name = std::string(linear ? "linear" : "window") + (orthographic ? " orthographic" : "") +
                                    " mapping " + std::to_string(mapping) + " bits " + std::to_string(read_as.bits) +
                                    (read_as.is_float ? " float" : "") + " near " + std::to_string(range.x);
                        all.push_back(made);
                    }
    return all;
}

TEST(DepthCounts, MatchEveryDepthByItself) {
    Random random(seed);
    for (const CountCase& each : count_cases()) {
        const double levels = std::exp2(each.read_as.bits) - 1.0;
        std::vector<std::uint32_t> stored;
        std::uint64_t unwritten = 0;
        // The number of depths that are certainly in each bin, and the number that may be in it because they are within
        // float32's precision of an edge.
        std::vector<std::uint32_t> least(bins, 0), most(bins, 0);
        for (int i = 0; i < 5000; ++i) {
            double depth = random.number(0.0, 1.0);
            if (i % 3 == 1) depth = 1.0 - std::pow(10.0, -8.0 * depth);  // concentrated near 1 and near 0
            if (i % 3 == 2) depth = std::pow(10.0, -8.0 * depth);
            const std::uint32_t code = each.read_as.is_float ? std::bit_cast<std::uint32_t>(static_cast<float>(depth))
                                                             : static_cast<std::uint32_t>(std::lround(depth * levels));
            depth = each.read_as.is_float ? std::bit_cast<float>(code) : code / levels;
            stored.push_back(code);
            if (depth == each.plan.clear_depth_value) {
                ++unwritten;
                continue;
            }
            const auto bin_of = [](double place) {
                return static_cast<std::size_t>(std::clamp(std::floor(place * bins), 0.0, bins - 1.0));
            };
            const double place = place_of(depth, each.plan), off = 1e-5;
            const std::size_t first = bin_of(place - off), last = bin_of(place + off);
            if (first == last) ++least[first];
            for (std::size_t bin = first; bin <= last; ++bin) ++most[bin];
        }
        const DepthCounts counts = count_depths(stored, each.read_as, each.plan);
        ASSERT_EQ(counts.counts.size(), bins);
        EXPECT_EQ(counts.unwritten, unwritten) << each.name;
        EXPECT_EQ(std::accumulate(counts.counts.begin(), counts.counts.end(), counts.unwritten), stored.size());
        for (std::size_t bin = 0; bin < bins; ++bin) {
            EXPECT_GE(counts.counts[bin], least[bin]) << each.name << " bin " << bin;
            EXPECT_LE(counts.counts[bin], most[bin]) << each.name << " bin " << bin;
        }
        const bool linear = each.plan.depth_scale == DepthScale::linear;
        EXPECT_EQ(counts.min, linear ? each.plan.lens.near : 0.0);
        EXPECT_EQ(counts.max, linear ? each.plan.lens.far : 1.0);
    }
}

TEST(DepthCounts, EndsBelongToTheFirstAndTheLastBin) {
    FramePlan plan;
    plan.depth_mapping = DepthMapping::reversed;
    plan.clear_depth_value = 0.5;
    const std::vector<std::uint32_t> stored = {0, 65535, 65535};
    const DepthCounts counts = count_depths(stored, {16, false}, plan);
    EXPECT_EQ(counts.counts.front(), 2U);
    EXPECT_EQ(counts.counts.back(), 1U);
}

TEST(DepthCounts, CountInvalidDepthsAtAnEnd) {
    FramePlan plan;
    for (const DepthMapping mapping : {DepthMapping::standard, DepthMapping::reversed, DepthMapping::logarithmic})
        for (const DepthScale scale : {DepthScale::linear, DepthScale::window}) {
            plan.depth_mapping = mapping;
            plan.depth_scale = scale;
            const float none = std::numeric_limits<float>::quiet_NaN(), beyond = 7.0F, before = -1e30F;
            const std::vector<std::uint32_t> stored = {std::bit_cast<std::uint32_t>(none),
                                                       std::bit_cast<std::uint32_t>(beyond),
                                                       std::bit_cast<std::uint32_t>(before), 0xFFFFFFFFU};
            for (const DepthPrecision& read_as : {DepthPrecision{24, true}, {16, false}}) {
                const DepthCounts counts = count_depths(stored, read_as, plan);
                EXPECT_EQ(std::accumulate(counts.counts.begin(), counts.counts.end(), counts.unwritten), 4U);
            }
        }
}

TEST(DepthCounts, AreEmptyWithoutDepths) {
    const DepthCounts counts = count_depths({}, {24, false}, FramePlan{});
    EXPECT_EQ(counts.counts, std::vector<std::uint32_t>(bins, 0));
    EXPECT_EQ(counts.unwritten, 0U);
}

}  // namespace
}  // namespace viewing
