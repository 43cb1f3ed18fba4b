// Rectangles around the pixels beyond a threshold.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "image/compare.h"

namespace viewing {

/// Collects runs of pixels into boxes, from the top row down, and merges boxes that are near each other. Boxes that end
/// too far above the current row to be near any later run move to `closed_`, which keeps the search short.
class BoxFinder {
public:
    /// Takes the size of the picture in pixels.
    BoxFinder(int width, int height);

    /// Adds the differences in a row; those above `worst` go into a box.
    void add_row(int y, std::span<const std::uint8_t> difference, int worst);

    /// Returns all boxes, the one with the most pixels first; boxes with equal counts are ordered from top to bottom,
    /// then from left to right.
    std::vector<PixelBox> finish();

private:
    void close_boxes_above(int y);

    int gap_;
    std::vector<PixelBox> open_;
    std::vector<PixelBox> closed_;
};

}  // namespace viewing
