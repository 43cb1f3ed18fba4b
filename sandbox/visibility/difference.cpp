// Comparing pictures of ids.
#include "visibility/difference.h"

#include <algorithm>
#include <cassert>

namespace viewing {
namespace {

bool is_within_a_pixel(const IdImage& image, int x, int y, int id) {
    for (int ny = std::max(y - 1, 0); ny <= std::min(y + 1, image.height - 1); ++ny)
        for (int nx = std::max(x - 1, 0); nx <= std::min(x + 1, image.width - 1); ++nx)
            if (image.id(nx, ny) == id) return true;
    return false;
}

}  // namespace

IdDifference difference(const IdImage& reference, const IdImage& image) {
    assert(reference.width == image.width && reference.height == image.height);
    IdDifference result;
    result.differs.assign(reference.ids.size(), 0);
    result.compared = static_cast<std::int64_t>(reference.ids.size());
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const std::size_t pixel = image.index(x, y);
            if (image.ids[pixel] == reference.ids[pixel]) continue;
            const bool is_near = is_within_a_pixel(reference, x, y, image.ids[pixel]);
            ++(is_near ? result.different_at_edges : result.different);
            result.differs[pixel] = is_near ? 0 : 1;
        }
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
