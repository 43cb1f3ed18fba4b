#include "image/difference_boxes.h"

#include <algorithm>

namespace viewing {

namespace {

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

/// Adds a box to a set in which no two boxes are near each other. Merges the new box with all boxes near it.
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

}  // namespace

BoxFinder::BoxFinder(int width, int height) : gap_(std::max(16, std::max(width, height) / 80)) {}

void BoxFinder::add_row(int y, std::span<const std::uint8_t> difference, int worst) {
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

std::vector<PixelBox> BoxFinder::finish() {
    std::vector<PixelBox> boxes;
    for (const PixelBox& box : open_) add_box(boxes, box, gap_);
    for (const PixelBox& box : closed_) add_box(boxes, box, gap_);
    std::sort(boxes.begin(), boxes.end(), [](const PixelBox& a, const PixelBox& b) {
        if (a.pixels != b.pixels) return a.pixels > b.pixels;
        return a.y != b.y ? a.y < b.y : a.x < b.x;
    });
    return boxes;
}

void BoxFinder::close_boxes_above(int y) {
    const auto closed = std::partition(open_.begin(), open_.end(),
                                       [this, y](const PixelBox& box) { return box.y + box.height + gap_ >= y; });
    closed_.insert(closed_.end(), closed, open_.end());
    open_.erase(closed, open_.end());
}

}  // namespace viewing
