// Finds separating axes on the screen. Read newell.cpp next.
#include "topics/hidden/methods/projected.h"

#include <algorithm>
#include <utility>

namespace viewing {
namespace {

/// An overlap of at most this, in normalized device coordinates, counts as mere touching, as between mesh neighbors.
constexpr double touching = 2e-8;

std::pair<double, double> extent_along(const glm::dvec2& axis, const std::vector<glm::dvec2>& corners) {
    std::pair extent(1e300, -1e300);
    for (const glm::dvec2& corner : corners) {
        const double position = glm::dot(axis, corner);
        extent.first = std::min(extent.first, position);
        extent.second = std::max(extent.second, position);
    }
    return extent;
}

/// Returns whether a line parallel to some edge of `a` separates `a` from `b`. Also returns true if `a` has no width
/// across an edge, or no edges.
bool an_edge_separates(const std::vector<glm::dvec2>& a, const std::vector<glm::dvec2>& b) {
    bool is_a_point = true;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const glm::dvec2 edge = a[(i + 1) % a.size()] - a[i];
        const double length = glm::length(edge);
        if (length <= touching) continue;  // no direction
        is_a_point = false;
        const glm::dvec2 axis = glm::dvec2(-edge.y, edge.x) / length;
        const auto [a_min, a_max] = extent_along(axis, a);
        const auto [b_min, b_max] = extent_along(axis, b);
        if (a_max - a_min <= touching || a_max <= b_min + touching || b_max <= a_min + touching) return true;
    }
    return is_a_point;
}

}  // namespace

Projected project(const Polygon& polygon, const Viewpoint& viewpoint, const glm::dmat4& clip_from_world) {
    Projected result{1e300, -1e300, glm::dvec2(1e300), glm::dvec2(-1e300), {}};
    for (const glm::dvec3& vertex : polygon.vertices) {
        const double distance = viewpoint.distance(vertex);
        result.nearest = std::min(result.nearest, distance);
        result.farthest = std::max(result.farthest, distance);
        const glm::dvec4 clip = clip_from_world * glm::dvec4(vertex, 1.0);
        const glm::dvec2 corner = glm::dvec2(clip) / clip.w;
        result.min = glm::min(result.min, corner);
        result.max = glm::max(result.max, corner);
        result.corners.push_back(corner);
    }
    return result;
}

bool apart_on(int axis, const Projected& a, const Projected& b) {
    return a.max[axis] <= b.min[axis] + touching || b.max[axis] <= a.min[axis] + touching;
}

bool are_disjoint(const Projected& a, const Projected& b) {
    return an_edge_separates(a.corners, b.corners) || an_edge_separates(b.corners, a.corners);
}

}  // namespace viewing
