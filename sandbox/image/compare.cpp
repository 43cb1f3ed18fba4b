// Rows that are the same bytes cost one memcmp; only the others are looked at by pixel, and only runs of pixels beyond
// the threshold reach the box finder.
#include "image/compare.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <span>

#include "text/numbers.h"

namespace viewing {

namespace {

constexpr std::size_t most_boxes = 16;

/// The largest channel difference of each pixel, a row of the part that both pictures have at a time. Two plain loops
/// over bytes, which compilers turn into vector instructions; one over pixels and channels they do not. Only pixels
/// beyond the threshold look for a like in their neighbourhood.
class Differences {
public:
    Differences(const Image& a, const Image& b, const CompareOptions& options)
        : a_(a),
          b_(b),
          options_(options),
          width(std::min(a.width, b.width)),
          height(std::min(a.height, b.height)),
          channels_(4 * static_cast<std::size_t>(width)),
          pixels_(static_cast<std::size_t>(width)) {}

    bool are_none(int y) const { return std::memcmp(a_.row(y), b_.row(y), channels_.size()) == 0; }

    std::span<const std::uint8_t> row(int y) {
        const std::uint8_t *a = a_.row(y), *b = b_.row(y);
        std::uint8_t* channel = channels_.data();
        for (std::size_t i = 0; i < channels_.size(); ++i)
            channel[i] = static_cast<std::uint8_t>(std::max(a[i], b[i]) - std::min(a[i], b[i]));
        std::uint8_t* pixel = pixels_.data();
        for (std::size_t x = 0; x < pixels_.size(); ++x, channel += 4)
            pixel[x] = std::max(std::max(channel[0], channel[1]), std::max(channel[2], channel[3]));
        if (options_.reach_px > 0)
            for (int x = 0; x < width; ++x)
                if (pixel[x] > options_.worst && has_like(a_, x, y, b_) && has_like(b_, x, y, a_))
                    pixel[x] = static_cast<std::uint8_t>(options_.worst);
        return pixels_;
    }

private:
    bool has_like(const Image& from, int x, int y, const Image& other) const {
        const std::uint8_t* pixel = from.row(y) + 4 * static_cast<std::size_t>(x);
        const int reach = options_.reach_px;
        for (int v = std::max(y - reach, 0); v <= std::min(y + reach, height - 1); ++v)
            for (int u = std::max(x - reach, 0); u <= std::min(x + reach, width - 1); ++u) {
                const std::uint8_t* near = other.row(v) + 4 * static_cast<std::size_t>(u);
                int worst = 0;
                for (int channel = 0; channel < 4; ++channel)
                    worst = std::max(worst, std::abs(pixel[channel] - near[channel]));
                if (worst <= options_.worst) return true;
            }
        return false;
    }

    const Image &a_, &b_;
    const CompareOptions options_;

public:
    const int width, height;  ///< of the part that both have

private:
    std::vector<std::uint8_t> channels_;
    std::vector<std::uint8_t> pixels_;
};

bool near(const PixelBox& a, const PixelBox& b, int gap) {
    return a.x <= b.x + b.width + gap && b.x <= a.x + a.width + gap && a.y <= b.y + b.height + gap &&
           b.y <= a.y + a.height + gap;
}

PixelBox around(const PixelBox& a, const PixelBox& b) {
    const int x = std::min(a.x, b.x);
    const int y = std::min(a.y, b.y);
    return {x, y, std::max(a.x + a.width, b.x + b.width) - x, std::max(a.y + a.height, b.y + b.height) - y,
            a.pixels + b.pixels};
}

/// Adds a box to boxes no two of which are near, and joins until that is so again.
void add_box(std::vector<PixelBox>& boxes, PixelBox box, int gap) {
    for (bool joined = true; joined;) {
        joined = false;
        for (std::size_t i = boxes.size(); i-- > 0;) {
            if (!near(boxes[i], box, gap)) continue;
            box = around(boxes[i], box);
            boxes[i] = boxes.back();
            boxes.pop_back();
            joined = true;
        }
    }
    boxes.push_back(box);
}

/// Collects runs of pixels, top row first, into boxes. Boxes that end too far above the current row to meet a run wait
/// in `closed_`, which keeps the search short.
class BoxFinder {
public:
    BoxFinder(int width, int height) : gap_(std::max(16, std::max(width, height) / 80)) {}

    void add_row(int y, std::span<const std::uint8_t> difference, int worst) {
        const auto is_beyond = [worst](std::uint8_t d) { return d > worst; };
        close_boxes_above(y);
        auto begin = std::find_if(difference.begin(), difference.end(), is_beyond);
        while (begin != difference.end()) {
            PixelBox run{static_cast<int>(begin - difference.begin()), y, 1, 1, 1};
            auto next = begin + 1;
            for (; next != difference.end() && next - difference.begin() <= run.x + run.width + gap_; ++next) {
                if (!is_beyond(*next)) continue;
                run.width = static_cast<int>(next - difference.begin()) - run.x + 1;
                ++run.pixels;
            }
            add_box(open_, run, gap_);
            begin = std::find_if(next, difference.end(), is_beyond);
        }
    }

    /// All boxes, most pixels first, then from the top, then from the left.
    std::vector<PixelBox> finish() {
        std::vector<PixelBox> boxes;
        for (const PixelBox& box : open_) add_box(boxes, box, gap_);
        for (const PixelBox& box : closed_) add_box(boxes, box, gap_);
        std::sort(boxes.begin(), boxes.end(), [](const PixelBox& a, const PixelBox& b) {
            if (a.pixels != b.pixels) return a.pixels > b.pixels;
            return a.y != b.y ? a.y < b.y : a.x < b.x;
        });
        return boxes;
    }

private:
    void close_boxes_above(int y) {
        const auto closed = std::partition(open_.begin(), open_.end(),
                                           [this, y](const PixelBox& box) { return box.y + box.height + gap_ >= y; });
        closed_.insert(closed_.end(), closed, open_.end());
        open_.erase(closed, open_.end());
    }

    int gap_;
    std::vector<PixelBox> open_;
    std::vector<PixelBox> closed_;
};

std::string share_text(double share) {
    return figures(100.0 * share, 4) + " %";
}

std::string size_text(const std::array<int, 2>& size) {
    return std::to_string(size[0]) + " × " + std::to_string(size[1]);
}

/// "; where: x 3 … 9, y 4 … 8 and 2 more places", or nothing.
std::string places(const CompareReport& report) {
    if (report.boxes.empty()) return "";
    const PixelBox& box = report.boxes.front();
    std::string text = "; where: x " + std::to_string(box.x) + " … " + std::to_string(box.x + box.width - 1) + ", y " +
                       std::to_string(box.y) + " … " + std::to_string(box.y + box.height - 1);
    const std::int64_t others = static_cast<std::int64_t>(report.boxes.size()) - 1 + report.boxes_left_out;
    if (others > 0) text += " and " + std::to_string(others) + (others == 1 ? " more place" : " more places");
    return text;
}

/// `amount` 0 … 1 of `tint` over a colour.
void blend(std::uint8_t* pixel, const std::array<std::uint8_t, 3>& tint, double amount) {
    for (std::size_t c = 0; c < 3; ++c)
        pixel[c] = static_cast<std::uint8_t>(std::lround(pixel[c] * (1.0 - amount) + tint[c] * amount));
}

/// A picture's pixel as grey, drawn faint so that marks stand out (luma of Rec. 709 on the stored values).
void faint_grey(const std::uint8_t* from, std::uint8_t* to) {
    const double luma = 0.2126 * from[0] + 0.7152 * from[1] + 0.0722 * from[2];
    const auto grey = static_cast<std::uint8_t>(24.0 + 0.6 * luma);
    to[0] = to[1] = to[2] = grey;
    to[3] = 255;
}

}  // namespace

double CompareReport::beyond_share() const {
    return pixels == 0 ? 0.0 : static_cast<double>(beyond) / static_cast<double>(pixels);
}

std::vector<std::uint8_t> pixel_differences(const Image& a, const Image& b, const CompareOptions& options) {
    Differences rows(a, b, options);
    std::vector<std::uint8_t> levels;
    levels.reserve(static_cast<std::size_t>(rows.width) * static_cast<std::size_t>(rows.height));
    for (int y = 0; y < rows.height; ++y) {
        const std::span<const std::uint8_t> row = rows.row(y);
        levels.insert(levels.end(), row.begin(), row.end());
    }
    return levels;
}

CompareReport compare_images(const Image& a, const Image& b, const CompareOptions& options) {
    assert(options.worst >= 0 && options.worst <= 255 && options.share >= 0.0 && options.share <= 1.0);
    assert(options.reach_px >= 0);
    CompareReport report;
    report.options = options;
    report.size_a = {a.width, a.height};
    report.size_b = {b.width, b.height};
    report.sizes_differ = report.size_a != report.size_b;
    Differences rows(a, b, options);
    report.pixels = static_cast<std::int64_t>(std::max(a.width, b.width)) * std::max(a.height, b.height);
    report.different = report.beyond = report.pixels - static_cast<std::int64_t>(rows.width) * rows.height;

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

std::string sentence(const CompareReport& report) {
    const std::string found = std::to_string(report.different) + " of " + std::to_string(report.pixels) +
                              " pixels differ, at worst by " + std::to_string(report.worst_found) + " of 255 at (" +
                              std::to_string(report.worst_at[0]) + ", " + std::to_string(report.worst_at[1]) + "); " +
                              std::to_string(report.beyond) + " (" + share_text(report.beyond_share()) +
                              ") by more than " + std::to_string(report.options.worst) + ", allowed are " +
                              share_text(report.options.share);
    if (report.sizes_differ)
        return "different: the sizes differ, A is " + size_text(report.size_a) + " and B is " +
               size_text(report.size_b) + "; of the part that both have, a channel differs by at most " +
               std::to_string(report.worst_found) + " of 255" + places(report);
    if (report.different == 0) return "equal: every one of " + size_text(report.size_a) + " pixels is the same";
    return (report.equal ? "equal within the thresholds: " : "different: ") + found + places(report);
}

std::string as_json(const CompareReport& report) {
    auto boxes = nlohmann::ordered_json::array();
    for (const PixelBox& box : report.boxes)
        boxes.push_back(
            {{"x", box.x}, {"y", box.y}, {"width", box.width}, {"height", box.height}, {"pixels", box.pixels}});
    const nlohmann::ordered_json json = {
        {"equal", report.equal},
        {"sizes_differ", report.sizes_differ},
        {"size_a", report.size_a},
        {"size_b", report.size_b},
        {"pixels", report.pixels},
        {"different", report.different},
        {"beyond", report.beyond},
        {"share", report.beyond_share()},
        {"worst", report.worst_found},
        {"worst_at", report.worst_at},
        {"boxes", boxes},
        {"boxes_left_out", report.boxes_left_out},
        {"thresholds", {{"worst", report.options.worst}, {"share", report.options.share}}},
        {"sentence", sentence(report)},
    };
    return json.dump(2) + "\n";
}

Image diff_picture(const Image& a, const Image& b, const CompareOptions& options) {
    constexpr std::array<std::uint8_t, 3> beyond_color{0xE4, 0x57, 0x2E};
    constexpr std::array<std::uint8_t, 3> within_color{0x56, 0xB4, 0xE9};
    constexpr std::array<std::uint8_t, 3> uncovered_color{0xCC, 0x79, 0xA7};
    Image out{std::max(a.width, b.width), std::max(a.height, b.height), {}};
    out.rgba.resize(out.row_bytes() * static_cast<std::size_t>(out.height));
    const auto has = [](const Image& image, int x, int y) { return x < image.width && y < image.height; };
    Differences rows(a, b, options);
    std::span<const std::uint8_t> difference;
    for (int y = 0; y < out.height; ++y) {
        if (y < rows.height) difference = rows.row(y);
        for (int x = 0; x < out.width; ++x) {
            constexpr std::array<std::uint8_t, 4> nothing{};
            const std::size_t offset = 4 * static_cast<std::size_t>(x);
            std::uint8_t* pixel = out.row(y) + offset;
            faint_grey(has(a, x, y) ? a.row(y) + offset : has(b, x, y) ? b.row(y) + offset : nothing.data(), pixel);
            if (!has(a, x, y) || !has(b, x, y)) {
                blend(pixel, uncovered_color, 0.4);
            } else if (const int d = difference[static_cast<std::size_t>(x)]; d > options.worst) {
                blend(pixel, beyond_color, 1.0);
            } else if (d > 0) {
                blend(pixel, within_color, 0.4);
            }
        }
    }
    return out;
}

}  // namespace viewing
