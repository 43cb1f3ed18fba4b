// Compares ID images.
#include "topics/hidden/methods/difference.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <utility>

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

std::optional<WrongPair> worst_pair(const IdImage& reference, const IdImage& image) {
    const IdDifference found = difference(reference, image);
    std::map<std::pair<int, int>, WrongPair> pairs;
    std::int64_t all = 0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const std::size_t pixel = image.index(x, y);
            const int seen = reference.ids[pixel], drawn = image.ids[pixel];
            if (found.differs[pixel] == 0 || seen == IdImage::background || drawn == IdImage::background) continue;
            WrongPair& pair = pairs[{seen, drawn}];
            pair.seen = seen;
            pair.drawn = drawn;
            pair.x += x + 0.5;
            pair.y += y + 0.5;
            ++pair.pixels;
            ++all;
        }
    }
    if (pairs.empty()) return std::nullopt;
    WrongPair worst = std::max_element(pairs.begin(), pairs.end(), [](const auto& a, const auto& b) {
                          return a.second.pixels < b.second.pixels;
                      })->second;
    worst.all_pixels = all;
    worst.compared = found.compared;
    worst.x /= static_cast<double>(worst.pixels * image.width);
    worst.y /= static_cast<double>(worst.pixels * image.height);
    return worst;
}

IdImage with_ids(IdImage image, std::span<const int> new_id) {
    for (int& id : image.ids) {
        if (id != IdImage::background) id = new_id[id];
    }
    return image;
}

}  // namespace viewing
