// Rectangles around the pixels beyond a threshold.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "image/compare.h"

namespace viewing {

/// Collects runs of pixels, top row first, into boxes; two that are near each other become one. Boxes that end too far
/// above the current row to meet a run wait in `closed_`, which keeps the search short.
class BoxFinder {
public:
    /// Of the picture, pixels.
    BoxFinder(int width, int height);

    /// Levels of a row of which those above `worst` are to lie in a box.
    void add_row(int y, std::span<const std::uint8_t> difference, int worst);

    /// All boxes, most pixels first, then from the top, then from the left.
    std::vector<PixelBox> finish();

private:
    void close_boxes_above(int y);

    int gap_;
    std::vector<PixelBox> open_;
    std::vector<PixelBox> closed_;
};

}  // namespace viewing
