// Rows that are the same bytes cost one memcmp; only the others are looked at by pixel, and only runs of pixels beyond
// the threshold reach the box finder.
#include "image/compare.h"

#include <algorithm>
#include <cassert>

#include "image/difference_boxes.h"
#include "image/differences.h"

namespace viewing {

namespace {

constexpr std::size_t most_boxes = 16;

/// How many pixels of the part that both pictures have are left out.
std::int64_t left_out_of(const Mask& mask, int width, int height) {
    if (mask.width() <= width && mask.height() <= height) return mask.pixels();
    std::int64_t count = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) count += mask.leaves_out(x, y);
    return count;
}

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
    report.different = report.beyond = report.pixels - static_cast<std::int64_t>(rows.width) * rows.height;
    report.left_out = left_out_of(mask, rows.width, rows.height);

    BoxFinder boxes(rows.width, rows.height);
    for (int y = 0; y < rows.height; ++y) {
        if (rows.are_none(y)) continue;
        const std::span<const std::uint8_t> difference = rows.row(y);
        int largest = 0;
        for (const std::uint8_t d : difference) {
            largest = std::max<int>(largest, d);
            report.different += d > 0;
            report.beyond += d > options.worst;
        }
        if (largest > report.worst_found) {
            report.worst_found = largest;
            report.worst_at = {
                static_cast<int>(std::find(difference.begin(), difference.end(), largest) - difference.begin()), y};
        }
        if (largest > options.worst) boxes.add_row(y, difference, options.worst);
    }

    report.boxes = boxes.finish();
    if (report.boxes.size() > most_boxes) {
        report.boxes_left_out = static_cast<std::int64_t>(report.boxes.size() - most_boxes);
        report.boxes.resize(most_boxes);
    }
    report.equal = !report.sizes_differ && report.beyond_share() <= options.share;
    return report;
}

}  // namespace viewing
