// Comparing pictures of ids.
#include "visibility/difference.h"

#include <algorithm>
#include <cassert>

namespace viewing {

std::vector<std::uint8_t> edge_pixels(const IdImage& image) {
    std::vector<std::uint8_t> edges(image.ids.size(), 0);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            for (int ny = std::max(y - 1, 0); ny <= std::min(y + 1, image.height - 1); ++ny) {
                for (int nx = std::max(x - 1, 0); nx <= std::min(x + 1, image.width - 1); ++nx) {
                    if (image.id(nx, ny) != image.id(x, y)) edges[image.index(x, y)] = 1;
                }
            }
        }
    }
    return edges;
}

IdDifference difference(const IdImage& reference, const IdImage& image) {
    assert(reference.width == image.width && reference.height == image.height);
    IdDifference result;
    result.differs.assign(reference.ids.size(), 0);
    const std::vector<std::uint8_t> edges = edge_pixels(reference);
    for (std::size_t i = 0; i < reference.ids.size(); ++i) {
        const bool differs = reference.ids[i] != image.ids[i];
        if (edges[i] != 0) {
            result.different_at_edges += differs;
            continue;
        }
        ++result.compared;
        result.different += differs;
        result.differs[i] = differs;
    }
    return result;
}

IdImage with_ids(IdImage image, std::span<const int> new_id) {
    for (int& id : image.ids) {
        if (id != IdImage::background) id = new_id[static_cast<std::size_t>(id)];
    }
    return image;
}

}  // namespace viewing
