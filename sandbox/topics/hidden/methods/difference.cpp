// Compares ID images.
#include "topics/hidden/methods/difference.h"

#include <algorithm>
#include <cassert>
#include <glm/glm.hpp>
#include <map>
#include <set>
#include <utility>

namespace viewing {
namespace {

bool is_within_a_pixel(const IdImage& image, int x, int y, int id) {
    for (int ny = std::max(y - 1, 0); ny <= std::min(y + 1, image.height - 1); ++ny)
        for (int nx = std::max(x - 1, 0); nx <= std::min(x + 1, image.width - 1); ++nx)
            if (image.id(nx, ny) == id) return true;
    return false;
}

using Edge = std::pair<glm::dvec2, glm::dvec2>;  ///< its ends, in pixels from the top left

double distance_to(const Edge& edge, const glm::dvec2& point) {
    const glm::dvec2 along = edge.second - edge.first, from = point - edge.first;
    const double length_squared = glm::dot(along, along);
    const double at = length_squared > 0.0 ? std::clamp(glm::dot(from, along) / length_squared, 0.0, 1.0) : 0.0;
    return glm::length(from - at * along);
}

/// Returns the edges of the polygons with these sources, where they are in front of the eye.
std::map<int, std::vector<Edge>> edges_of(const std::set<int>& sources, std::span<const Polygon> polygons,
                                          const glm::dmat4& clip_from_world, const glm::dvec2& size_px) {
    std::map<int, std::vector<Edge>> edges;
    for (const Polygon& polygon : polygons) {
        if (!sources.contains(polygon.source)) continue;
        std::vector<glm::dvec2> corners;
        for (const glm::dvec3& vertex : polygon.vertices) {
            const glm::dvec4 clip = clip_from_world * glm::dvec4(vertex, 1.0);
            if (!(clip.w > 0.0)) break;
            corners.push_back((glm::dvec2(clip.x, -clip.y) / clip.w * 0.5 + 0.5) * size_px);
        }
        if (corners.size() < polygon.vertices.size()) continue;
        for (std::size_t i = 0; i < corners.size(); ++i)
            edges[polygon.source].emplace_back(corners[i], corners[(i + 1) % corners.size()]);
    }
    return edges;
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

IdDifference difference(const IdImage& reference, const IdImage& image, std::span<const Polygon> drawn,
                        const glm::dmat4& clip_from_world) {
    constexpr double rounding_px = 1.0 / 64.0;
    IdDifference found = difference(reference, image);
    std::set<int> sources;
    for (std::size_t pixel = 0; pixel < found.differs.size(); ++pixel)
        if (found.differs[pixel] != 0) sources.insert({reference.ids[pixel], image.ids[pixel]});
    const std::map<int, std::vector<Edge>> edges =
        edges_of(sources, drawn, clip_from_world, {image.width, image.height});
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const std::size_t pixel = image.index(x, y);
            if (found.differs[pixel] == 0) continue;
            const auto is_at_edge_of = [&](int source) {
                const auto of = edges.find(source);
                return of != edges.end() && std::any_of(of->second.begin(), of->second.end(), [&](const Edge& edge) {
                           return distance_to(edge, {x + 0.5, y + 0.5}) < rounding_px;
                       });
            };
            if (!is_at_edge_of(reference.ids[pixel]) && !is_at_edge_of(image.ids[pixel])) continue;
            found.differs[pixel] = 0;
            --found.different;
            ++found.different_at_edges;
        }
    }
    return found;
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
