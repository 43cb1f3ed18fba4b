// An image of polygon IDs. Every hidden-surface method draws one, so that methods can be compared pixel by pixel. Read
// topics/hidden/methods/difference.h next.
#pragma once

#include <limits>
#include <vector>

namespace viewing {

/// Rows are stored from the top; pixel (0, 0) is at the top left. `ids` holds Polygon::source. `depths` holds window
/// depths: 0 on the near plane and 1 on the far plane (standard mapping), infinite on the background.
struct IdImage {
    static constexpr int background = -1;

    IdImage() = default;
    IdImage(int image_width, int image_height)
        : width(image_width),
          height(image_height),
          ids(static_cast<std::size_t>(image_width) * image_height, background),
          depths(ids.size(), std::numeric_limits<double>::infinity()) {}

    std::size_t index(int x, int y) const { return static_cast<std::size_t>(y) * width + x; }
    int id(int x, int y) const { return ids[index(x, y)]; }

    int width = 0, height = 0;
    std::vector<int> ids;
    std::vector<double> depths;
};

}  // namespace viewing
