// Processes depths in small blocks, each in plain loops that a compiler vectorizes.
#include "frame/depth_counts.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>

namespace viewing {
namespace {

constexpr std::size_t bins = 128, block_length = 512;

/// Two fractions of the window depth range 0 … 1, which add up to 1: from near to the depth, and from the depth to far.
/// Each is exact where it is small.
struct Shares {
    std::array<float, block_length> from_near, to_far;
};

/// Clamps an invalid depth code to the nearest valid one. Signed arithmetic lets the compiler vectorize this.
std::int32_t within(std::uint32_t stored, std::int32_t last) {
    return std::max(std::min(static_cast<std::int32_t>(stored), last), 0);
}

void read_floats(std::span<const std::uint32_t> stored, std::span<float> same, std::span<float> rest) {
    for (std::size_t i = 0; i < stored.size(); ++i) {
        same[i] = std::bit_cast<float>(within(stored[i], std::bit_cast<std::int32_t>(1.0F)));
        rest[i] = 1.0F - same[i];
    }
}

void read_codes(std::span<const std::uint32_t> stored, const DepthPrecision& read_as, std::span<float> same,
                std::span<float> rest) {
    const auto last = static_cast<std::int32_t>(read_as.greatest_code());
    const float per_code = 1.0F / static_cast<float>(last);
    for (std::size_t i = 0; i < stored.size(); ++i) {
        const std::int32_t code = within(stored[i], last);
        same[i] = static_cast<float>(code) * per_code;
        rest[i] = static_cast<float>(last - code) * per_code;
    }
}

/// Replaces the fraction of the window depth range with the fraction of the range of eye distances from near to far.
void perspective_distances(Shares& shares, std::size_t count, const Lens& lens) {
    const auto near = static_cast<float>(lens.near), range = static_cast<float>(lens.shown_far() - lens.near);
    if (lens.is_infinite()) {
        for (std::size_t i = 0; i < count; ++i)
            shares.from_near[i] = std::min(near * shares.from_near[i] / (range * shares.to_far[i] + 1e-30F), 1.0F);
        return;
    }
    for (std::size_t i = 0; i < count; ++i)
        shares.from_near[i] = near * shares.from_near[i] / (near + range * shares.to_far[i]);
}

/// Inverts logarithmic depth with a table, linearly interpolated.
class ExponentialDistances {
public:
    explicit ExponentialDistances(const Lens& lens) {
        const double ratio = lens.logarithmic_far() / lens.logarithmic_near();
        for (std::size_t i = 0; i < shares_.size(); ++i)
            shares_[i] = static_cast<float>(std::expm1(std::log(ratio) * static_cast<double>(i) / steps) / (ratio - 1));
    }

    void apply(Shares& shares, std::size_t count) const {
        for (std::size_t i = 0; i < count; ++i) {
            const float place = shares.from_near[i] * steps;
            const auto before = static_cast<std::uint32_t>(static_cast<std::int32_t>(place));
            const float between = place - static_cast<float>(before);
            shares.from_near[i] = shares_[before] + between * (shares_[before + 1] - shares_[before]);
        }
    }

private:
    static constexpr std::size_t steps = 4096;
    std::array<float, steps + 2> shares_;
};

/// Converts depths, as they were read back, to fractions of the plan's scale.
class Scale {
public:
    Scale(const DepthPrecision& read_as, const FramePlan& plan)
        : read_as_(read_as),
          lens_(plan.lens),
          is_linear_(plan.depth_scale == DepthScale::linear),
          is_reversed_(plan.depth_mapping == DepthMapping::reversed),
          is_logarithmic_(plan.depth_mapping == DepthMapping::logarithmic),
          exponential_(plan.lens) {}

    void read(std::span<const std::uint32_t> block, Shares& shares) const {
        const bool counts_from_far = is_reversed_ && is_linear_;
        auto& same = counts_from_far ? shares.to_far : shares.from_near;
        auto& rest = counts_from_far ? shares.from_near : shares.to_far;
        if (read_as_.is_float)
            read_floats(block, same, rest);
        else
            read_codes(block, read_as_, same, rest);
        if (is_linear_ && is_logarithmic_)
            exponential_.apply(shares, block.size());
        else if (is_linear_ && !lens_.orthographic)
            perspective_distances(shares, block.size(), lens_);
    }

private:
    const DepthPrecision read_as_;
    const Lens lens_;
    const bool is_linear_, is_reversed_, is_logarithmic_;
    const ExponentialDistances exponential_;
};

class Histogram {
public:
    void add(std::span<const std::uint32_t> block, const Shares& shares, std::uint32_t cleared) {
        std::array<std::int32_t, block_length> found;
        for (std::size_t i = 0; i < block.size(); ++i) {
            const auto place = static_cast<std::int32_t>(shares.from_near[i] * static_cast<float>(bins));
            const std::int32_t written = place < last_bin ? place : last_bin;
            found[i] = block[i] == cleared ? unwritten : written;
        }
        for (std::size_t i = 0; i < block.size(); ++i) ++counts_[found[i]][i % turns];
    }

    DepthCounts sum() const {
        DepthCounts sum;
        for (std::size_t bin = 0; bin < bins; ++bin) sum.counts.push_back(sum_of(bin));
        sum.unwritten = sum_of(unwritten);
        return sum;
    }

private:
    static constexpr std::int32_t last_bin = bins - 1, unwritten = bins;
    static constexpr std::size_t turns = 4;  // separate counters, so that additions to a bin do not wait for each other

    std::uint32_t sum_of(std::size_t bin) const {
        return std::accumulate(counts_[bin].begin(), counts_[bin].end(), std::uint32_t{0});
    }

    std::array<std::array<std::uint32_t, turns>, bins + 1> counts_{};
};

std::uint32_t cleared_to(double depth, const DepthPrecision& read_as) {
    if (read_as.is_float) return std::bit_cast<std::uint32_t>(static_cast<float>(depth));
    return static_cast<std::uint32_t>(std::lround(depth * read_as.greatest_code()));
}

}  // namespace

DepthCounts count_depths(std::span<const std::uint32_t> stored, const DepthPrecision& read_as, const FramePlan& plan) {
    const Scale scale(read_as, plan);
    const std::uint32_t cleared = cleared_to(plan.clear_depth_value, read_as);
    Histogram histogram;
    Shares shares;
    for (std::size_t first = 0; first < stored.size(); first += block_length) {
        const auto block = stored.subspan(first, std::min(block_length, stored.size() - first));
        scale.read(block, shares);
        histogram.add(block, shares, cleared);
    }
    DepthCounts counts = histogram.sum();
    if (plan.depth_scale == DepthScale::linear) {
        counts.min = plan.lens.near;
        counts.max = plan.lens.shown_far();
    }
    return counts;
}

}  // namespace viewing
