// The part of a convex polygon on one side of a plane. Source: Sutherland and Hodgman 1974.
#pragma once

#include <glm/common.hpp>
#include <utility>
#include <vector>

namespace viewing {

/// Keeps the part of a convex polygon where `distance`, a linear function of a point, is not negative; if there is no
/// such part, no corners are left. `kept` is scratch memory, so that many cuts need no new memory.
template <typename Point, typename Distance>
void keep_part(std::vector<Point>& polygon, std::vector<Point>& kept, const Distance& distance) {
    kept.clear();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
        const double at_from = distance(from), at_to = distance(to);
        if (at_from >= 0.0) kept.push_back(from);
        if ((at_from < 0.0) != (at_to < 0.0)) kept.push_back(glm::mix(from, to, at_from / (at_from - at_to)));
    }
    std::swap(polygon, kept);
}

}  // namespace viewing
