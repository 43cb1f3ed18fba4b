#include "image/portable.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iterator>

namespace viewing {

namespace {

constexpr int channels = 4;

/// The fraction of an edge's step by which a value may be outside the range of its neighbors in the other picture. A
/// line one pixel wide that is resolved with 16 samples keeps at least half of its contrast.
constexpr double fading = 0.5;
/// An edge displaced by at least this many pixels counts as moved. A different set of samples displaces an edge by up
/// to half a pixel (one sample at the center instead of the true coverage) plus an eighth (coverage from four samples).
/// For an edge that has moved by one pixel, the measurement gives 1.
constexpr double moved_px = 0.8;
/// The smallest step, in levels, whose displacement counts. For a smaller step, the rounding of the neighboring pixels
/// matters too much.
constexpr int least_step = 24;
/// How many pixels to search on each side for an edge: a multisampled edge is two pixels wide.
constexpr int edge_reach = 3;
/// How many pixels to search on each side for both edges of a line: the lines of the floor's grid are up to five pixels
/// wide.
constexpr int line_reach = 5;
/// Where a profile reverses by more than a quarter of its range, another edge begins.
constexpr double turning = 0.25;
/// An axis with a larger displacement, in pixels, is ignored: the edge runs along that axis and only seems to have
/// moved far.
constexpr double along_px = 3.0;

struct ChannelRange {
    int low = 255, high = 0;
    void add(int value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    int size() const { return high - low; }
    int beyond(int value) const { return std::max({low - value, value - high, 0}); }
};

/// Returns the range of each channel in the 3 x 3 pixels around a pixel, within the area that both pictures have.
std::array<ChannelRange, channels> ranges_around(const Image& image, int x, int y, int width, int height) {
    std::array<ChannelRange, channels> ranges;
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, height - 1); ++v)
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, width - 1); ++u)
            for (std::size_t c = 0; c < channels; ++c) ranges[c].add(image.row(v)[4 * u + static_cast<int>(c)]);
    return ranges;
}

/// One channel of both pictures along a row or column through a pixel.
struct Profile {
    const std::uint8_t *a, *b;          ///< the value at the pixel
    std::ptrdiff_t stride_a, stride_b;  ///< distance to the next pixel
    int before, after;                  ///< number of pixels on each side

    int a_at(int i) const { return a[i * stride_a]; }
    int b_at(int i) const { return b[i * stride_b]; }
    int sum_at(int i) const { return a_at(i) + b_at(i); }
    int difference_at(int i) const { return a_at(i) - b_at(i); }
    int first(int reach) const { return -std::min(reach, before); }
    int last(int reach) const { return std::min(reach, after); }
};

struct Displacement {
    double px = 0.0;      ///< how far the edge moved; never negative
    double net_px = 0.0;  ///< absolute value of the sum of a line's signed displacements: 0 if both sides shrank alike
    int step = 0;         ///< height of the edge, in levels
    int least_range = 0;  ///< range of the profile in A or in B, whichever is smaller
};

/// Returns the displacement of an edge at the pixel, within edge_reach. The edge is the flank where the profile rises
/// (or falls, if `sign` is −1).
Displacement displacement_of_flank(const Profile& profile, int sign, double turn) {
    const int first = profile.first(edge_reach), last = profile.last(edge_reach);
    int low = 0, high = 0;
    while (low > first && sign * (profile.sum_at(low) - profile.sum_at(low - 1)) >= -turn) --low;
    while (high < last && sign * (profile.sum_at(high + 1) - profile.sum_at(high)) >= -turn) ++high;
    ChannelRange range;
    double sum = 0.0, least = 0.0, most = 0.0;
    for (int i = low; i <= high; ++i) {
        range.add(profile.a_at(i));
        range.add(profile.b_at(i));
        // The top of a line belongs to both of its flanks, so count half of it.
        const bool turns = (i == low && low > first) || (i == high && high < last);
        sum += (turns ? 0.5 : 1.0) * profile.difference_at(i);
        least = std::min(least, sum);
        most = std::max(most, sum);
    }
    return {.px = (most - least) / std::max(range.size(), 1), .net_px = 0.0, .step = range.size(), .least_range = 0};
}

/// Returns the absolute value of the sum of the differences, with the sign of each reversed where the slope at its
/// pixel is negative. The two edges of a line have opposite slopes.
double net_difference(const Profile& profile, int worst) {
    double net = 0.0;
    for (int i = profile.first(line_reach); i <= profile.last(line_reach); ++i) {
        const int slope =
            profile.sum_at(std::min(i + 1, profile.after)) - profile.sum_at(std::max(i - 1, -profile.before));
        if (std::abs(slope) > 2 * worst) net += slope > 0 ? profile.difference_at(i) : -profile.difference_at(i);
    }
    return std::abs(net);
}

Displacement displacement(const Profile& profile, int worst) {
    ChannelRange near;
    for (int i = profile.first(edge_reach); i <= profile.last(edge_reach); ++i) {
        near.add(profile.a_at(i));
        near.add(profile.b_at(i));
    }
    const double turn = 2.0 * std::max<double>(worst, turning * near.size());
    const Displacement rising = displacement_of_flank(profile, 1, turn);
    const Displacement falling = displacement_of_flank(profile, -1, turn);
    Displacement found =
        falling.step > rising.step || (falling.step == rising.step && falling.px > rising.px) ? falling : rising;
    found.net_px = net_difference(profile, worst) / std::max(found.step, 1);
    ChannelRange range_a, range_b;
    for (int i = profile.first(line_reach); i <= profile.last(line_reach); ++i) {
        range_a.add(profile.a_at(i));
        range_b.add(profile.b_at(i));
    }
    found.least_range = std::min(range_a.size(), range_b.size());
    return found;
}

/// Whether the edge has moved along both axes; if the edge runs along one axis, only the other axis counts.
bool has_moved(const Displacement& one, const Displacement& other, int worst) {
    const auto moved = [](const Displacement& axis) { return axis.px >= moved_px && axis.net_px >= moved_px; };
    const bool one_is_across = one.px < other.px;
    const Displacement& across = one_is_across ? one : other;
    const Displacement& second = one_is_across ? other : one;
    const bool second_tells =
        second.px <= along_px && second.least_range > worst && 4 * second.least_range >= across.least_range;
    const int step = second_tells ? std::max(across.step, second.step) : across.step;
    return moved(across) && (!second_tells || moved(second)) && step >= least_step;
}

}  // namespace

bool is_resampled_edge(const Image& a, const Image& b, int x, int y, int worst) {
    const int width = std::min(a.width, b.width), height = std::min(a.height, b.height);
    const auto in_a = ranges_around(a, x, y, width, height), in_b = ranges_around(b, x, y, width, height);
    const auto is_edge = [worst](const ChannelRange& range) { return range.size() > worst; };
    if (std::none_of(in_a.begin(), in_a.end(), is_edge) || std::none_of(in_b.begin(), in_b.end(), is_edge))
        return false;
    const std::uint8_t* pixel_a = a.pixel(x, y);
    const std::uint8_t* pixel_b = b.pixel(x, y);
    for (std::size_t c = 0; c < channels; ++c) {
        if (std::abs(pixel_a[c] - pixel_b[c]) <= worst) continue;
        const int beyond = std::max(in_a[c].beyond(pixel_b[c]), in_b[c].beyond(pixel_a[c]));
        if (beyond > std::max<double>(worst, fading * std::max(in_a[c].size(), in_b[c].size()))) return false;
        const Profile row{pixel_a + c, pixel_b + c, channels, channels, x, width - 1 - x};
        const Profile column{pixel_a + c, pixel_b + c,   std::ssize(a.rgba) / a.height, std::ssize(b.rgba) / b.height,
                             y,           height - 1 - y};
        if (has_moved(displacement(column, worst), displacement(row, worst), worst)) return false;
    }
    return true;
}

LocalShift::LocalShift(int width, int height)
    : width_(width),
      side_x_(std::min(16, width)),
      side_y_(std::min(16, height)),
      rows_(static_cast<std::size_t>(channels) * static_cast<std::size_t>(width) * static_cast<std::size_t>(side_y_)),
      columns_(static_cast<std::size_t>(channels) * static_cast<std::size_t>(width)) {}

void LocalShift::add_row(int y, std::span<const std::int16_t> difference) {
    std::int16_t* oldest = rows_.data() + columns_.size() * static_cast<std::size_t>(y % side_y_);
    for (std::size_t i = 0; i < columns_.size(); ++i) {
        columns_[i] += difference[i] - oldest[i];
        oldest[i] = difference[i];
    }
    if (y + 1 < side_y_) return;
    std::array<std::int32_t, channels> sum{}, most{};
    for (int x = 0; x < width_; ++x)
        for (std::size_t c = 0; c < channels; ++c) {
            sum[c] += columns_[4 * static_cast<std::size_t>(x) + c];
            if (x >= side_x_) sum[c] -= columns_[4 * static_cast<std::size_t>(x - side_x_) + c];
            if (x + 1 >= side_x_ && std::abs(sum[c]) > std::abs(most[c])) most[c] = sum[c];
        }
    for (std::size_t c = 0; c < channels; ++c) {
        const double shift = static_cast<double>(most[c]) / (side_x_ * side_y_);
        if (std::abs(shift) > std::abs(largest_[c])) largest_[c] = shift;
    }
}

}  // namespace viewing
