// A row that is identical in both pictures costs only one memcmp. The other rows are compared pixel by pixel, and the
// box finder reads only rows that have pixels beyond the threshold.
#include "image/compare.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>

#include "image/blocks.h"
#include "image/difference_boxes.h"
#include "image/differences.h"
#include "image/portable.h"

namespace viewing {

namespace {

constexpr std::size_t most_boxes = 16;

/// Returns how many pixels the mask leaves out, within the area that both pictures have.
std::int64_t left_out_of(const Mask& mask, int width, int height) {
    if (mask.width() <= width && mask.height() <= height) return mask.pixels();
    std::int64_t count = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) count += mask.leaves_out(x, y);
    return count;
}

bool has_beyond(std::span<const std::uint8_t> difference, int worst) {
    return std::any_of(difference.begin(), difference.end(), [worst](std::uint8_t level) { return level > worst; });
}

/// Counts the pixels of a row. On resampled edges, `found` has the true differences and `difference` has the reduced
/// ones.
void count_row(std::span<const std::uint8_t> found, std::span<const std::uint8_t> difference, int y,
               CompareReport& report) {
    const int worst = report.options.worst;
    int largest = 0;
    for (std::size_t x = 0; x < found.size(); ++x) {
        largest = std::max<int>(largest, found[x]);
        report.different += found[x] > 0;
        report.beyond += difference[x] > worst;
        report.resampled += found[x] > worst && difference[x] <= worst;
    }
    if (largest <= report.worst_found) return;
    report.worst_found = largest;
    report.worst_at = {static_cast<int>(std::find(found.begin(), found.end(), largest) - found.begin()), y};
}

bool is_within(const std::array<double, 4>& shift, double limit) {
    return std::all_of(shift.begin(), shift.end(), [limit](double level) { return std::abs(level) <= limit; });
}

/// Mean differences of the channels over the area that both pictures have.
class Shifts {
public:
    Shifts(const Image& a, const Image& b, int width, int height)
        : a_(a), b_(b), difference_(4 * static_cast<std::size_t>(width)), local_(width, height) {}

    void add_row(int y, const Mask& mask) {
        const std::uint8_t *a = a_.row(y), *b = b_.row(y);
        for (std::size_t i = 0; i < difference_.size(); ++i) difference_[i] = static_cast<std::int16_t>(a[i] - b[i]);
        if (y < mask.height())
            for (std::size_t i = 0; i < difference_.size(); ++i)
                if (mask.leaves_out(static_cast<int>(i / 4), y)) difference_[i] = 0;
        for (std::size_t i = 0; i < difference_.size(); ++i) {
            sums_[i % 4] += difference_[i];
            sum_of_sizes_ += std::abs(difference_[i]);
        }
    }

    /// Adds the last row to the local shift. `found` has the differences of its pixels; those beyond `worst` are
    /// ignored, since they say nothing about a shift.
    void add_local_row(int y, std::span<const std::uint8_t> found, int worst) {
        for (std::size_t i = 0; i < difference_.size(); ++i)
            if (found[i / 4] > worst) difference_[i] = 0;
        local_.add_row(y, difference_);
    }

    void add_equal_row(int y) {
        std::fill(difference_.begin(), difference_.end(), std::int16_t{0});
        local_.add_row(y, difference_);
    }

    void tell(std::int64_t compared, CompareReport& report) const {
        if (compared == 0) return;
        report.mean = static_cast<double>(sum_of_sizes_) / (4.0 * static_cast<double>(compared));
        for (std::size_t c = 0; c < 4; ++c)
            report.shift[c] = static_cast<double>(sums_[c]) / static_cast<double>(compared);
        report.local_shift = local_.largest();
    }

private:
    const Image &a_, &b_;
    std::vector<std::int16_t> difference_;  ///< A − B for the last row
    LocalShift local_;
    std::array<std::int64_t, 4> sums_{};
    std::int64_t sum_of_sizes_ = 0;
};

}  // namespace

double CompareReport::beyond_share() const {
    const std::int64_t compared = pixels - left_out;
    return compared == 0 ? 0.0 : static_cast<double>(beyond) / static_cast<double>(compared);
}

std::vector<std::uint8_t> pixel_differences(const Image& a, const Image& b, const CompareOptions& options) {
    const Mask nothing;
    Differences rows(a, b, options, nothing);
    std::vector<std::uint8_t> levels;
    levels.reserve(static_cast<std::size_t>(rows.width) * static_cast<std::size_t>(rows.height));
    for (int y = 0; y < rows.height; ++y) {
        const std::span<const std::uint8_t> row = rows.row(y);
        levels.insert(levels.end(), row.begin(), row.end());
    }
    return levels;
}

CompareReport compare_images(const Image& a, const Image& b, const CompareOptions& options, const Mask& mask) {
    assert(options.worst >= 0 && options.worst <= 255 && options.share >= 0.0 && options.share <= 1.0);
    assert(options.reach_px >= 0);
    CompareReport report;
    report.options = options;
    report.size_a = {a.width, a.height};
    report.size_b = {b.width, b.height};
    report.sizes_differ = report.size_a != report.size_b;
    Differences rows(a, b, options, mask);
    report.pixels = static_cast<std::int64_t>(std::max(a.width, b.width)) * std::max(a.height, b.height);
    const std::int64_t common = static_cast<std::int64_t>(rows.width) * rows.height;
    report.different = report.beyond = report.pixels - common;
    report.left_out = left_out_of(mask, rows.width, rows.height);

    const bool is_portable = options.profile == CompareProfile::portable;
    BoxFinder boxes(rows.width, rows.height);
    BlockFinder blocks;
    Shifts shifts(a, b, rows.width, rows.height);
    for (int y = 0; y < rows.height; ++y) {
        if (rows.are_none(y)) {
            if (is_portable) shifts.add_equal_row(y);
            continue;
        }
        const std::span<const std::uint8_t> difference = rows.row(y);
        count_row(rows.as_found(), difference, y, report);
        if (has_beyond(difference, options.worst)) {
            boxes.add_row(y, difference, options.worst);
            blocks.add_row(y, difference, options.worst);
        }
        shifts.add_row(y, mask);
        if (is_portable) shifts.add_local_row(y, rows.as_found(), options.worst);
    }

    report.boxes = boxes.finish();
    if (report.boxes.size() > most_boxes) {
        report.boxes_left_out = static_cast<std::int64_t>(report.boxes.size() - most_boxes);
        report.boxes.resize(most_boxes);
    }
    report.blocks = blocks.blocks();
    report.largest_block = blocks.largest();
    shifts.tell(common - report.left_out, report);
    report.equal =
        !report.sizes_differ && report.beyond_share() <= options.share &&
        (!is_portable || (report.largest_block <= options.block_px && is_within(report.local_shift, options.shift)));
    return report;
}

}  // namespace viewing
