// Judges a pair by the screen area that both cover: finds the part of B within A's outline as the eye sees it, and
// tests that part against A's plane. Read newell.cpp next.
#include "topics/hidden/methods/hiding.h"

#include <algorithm>
#include <queue>

#include "topics/hidden/methods/projected.h"

namespace viewing {
namespace {

/// The part of a polygon that is in front of the eye and beyond the near plane.
struct Seen {
    int index;
    Polygon polygon;
    Projected projected;
};

std::optional<Polygon> in_front(Polygon polygon, const glm::dvec4& plane, double epsilon) {
    switch (side_of_plane(polygon, plane, epsilon)) {
        case PlaneSide::front:
            return polygon;
        case PlaneSide::spanning:
            return split(polygon, plane, epsilon).first;
        default:
            return std::nullopt;
    }
}

std::vector<Seen> seen_polygons(std::span<const Polygon> polygons, const Viewpoint& viewpoint, double epsilon) {
    const glm::dmat4 clip_from_world = viewpoint.clip_from_world();
    const std::optional<glm::dvec4> eye_plane = viewpoint.eye_plane_world();
    std::vector<Seen> seen;
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        std::optional<Polygon> part = in_front(polygons[i], viewpoint.near_plane_world(), epsilon);
        if (part && eye_plane) part = in_front(*std::move(part), *eye_plane, epsilon);
        if (!part) continue;
        Projected projected = project(*part, viewpoint, clip_from_world);
        seen.push_back({static_cast<int>(i), *std::move(part), std::move(projected)});
    }
    return seen;
}

/// Returns the part of a polygon within another polygon's outline, as the eye sees it.
std::optional<Polygon> behind_outline(Polygon polygon, const Polygon& outline, const glm::dvec4& eye, double epsilon) {
    std::optional<Polygon> part = std::move(polygon);
    const glm::dvec3 inside = centroid(outline);
    for (std::size_t i = 0; part && i < outline.vertices.size(); ++i) {
        const glm::dvec3 &a = outline.vertices[i], &b = outline.vertices[(i + 1) % outline.vertices.size()];
        const glm::dvec3 to_eye = glm::dvec3(eye) - eye.w * a;
        const glm::dvec3 normal = glm::cross(b - a, to_eye);
        const double length = glm::length(normal);
        if (!(length > 1e-12 * glm::length(b - a) * glm::length(to_eye))) continue;
        const glm::dvec4 side = glm::dvec4(normal, -glm::dot(normal, a)) / length;
        part = in_front(*std::move(part), glm::dot(side, glm::dvec4(inside, 1.0)) < 0.0 ? -side : side, epsilon);
    }
    return part;
}

void judge(const Seen& a, const Seen& b, const glm::dvec4& eye, double epsilon, std::vector<HidingPair>& pairs) {
    if (apart_on(0, a.projected, b.projected) || apart_on(1, a.projected, b.projected) ||
        are_disjoint(a.projected, b.projected))
        return;
    const std::optional<Polygon> common = behind_outline(b.polygon, a.polygon, eye, epsilon);
    if (!common) return;
    const glm::dvec4& plane = a.polygon.plane;
    const PlaneSide side = side_of_plane(*common, glm::dot(plane, eye) < 0.0 ? -plane : plane, epsilon);
    const bool is_lower = a.polygon.source < b.polygon.source;
    if (side == PlaneSide::front || side == PlaneSide::spanning || (side == PlaneSide::coplanar && !is_lower))
        pairs.push_back({a.index, b.index});
    if (side == PlaneSide::back || side == PlaneSide::spanning || (side == PlaneSide::coplanar && is_lower))
        pairs.push_back({b.index, a.index});
}

/// Returns the shortest cycle through an item, along the items that must come later; empty if there is none.
std::vector<int> way_back(int start, const std::vector<std::vector<int>>& later) {
    std::vector<int> from(later.size(), -1);
    std::queue<int> reached({start});
    while (!reached.empty()) {
        const int here = reached.front();
        reached.pop();
        for (const int next : later[here]) {
            if (next == start) {
                std::vector<int> way{here};
                while (way.back() != start) way.push_back(from[way.back()]);
                std::reverse(way.begin(), way.end());
                return way;
            }
            if (from[next] >= 0) continue;
            from[next] = here;
            reached.push(next);
        }
    }
    return {};
}

}  // namespace

std::vector<HidingPair> hiding_pairs(std::span<const Polygon> polygons, const Viewpoint& viewpoint,
                                     std::optional<double> epsilon, std::size_t most) {
    const double near_enough = epsilon.value_or(default_epsilon(polygons));
    const glm::dvec4 eye = viewpoint.eye_world();
    const std::vector<Seen> seen = seen_polygons(polygons, viewpoint, near_enough);
    std::vector<HidingPair> pairs;
    for (std::size_t a = 0; a < seen.size() && pairs.size() <= most; ++a)
        for (std::size_t b = a + 1; b < seen.size(); ++b) judge(seen[a], seen[b], eye, near_enough, pairs);
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

std::vector<HidingPair> grouped(std::span<const HidingPair> pairs, std::span<const int> group_of) {
    std::vector<HidingPair> groups;
    for (const auto& [before, after] : pairs) {
        const HidingPair pair{group_of[before], group_of[after]};
        if (pair.before != pair.after) groups.push_back(pair);
    }
    std::sort(groups.begin(), groups.end());
    groups.erase(std::unique(groups.begin(), groups.end()), groups.end());
    return groups;
}

WholeOrder whole_order(int count, std::span<const HidingPair> pairs) {
    std::vector<std::vector<int>> later(static_cast<std::size_t>(count));
    std::vector<int> earlier(static_cast<std::size_t>(count), 0);  // how many items must still come before each one
    for (const auto& [before, after] : pairs) {
        later[before].push_back(after);
        ++earlier[after];
    }
    std::priority_queue<int, std::vector<int>, std::greater<>> free;
    for (int i = 0; i < count; ++i)
        if (earlier[i] == 0) free.push(i);
    WholeOrder found;
    while (!free.empty()) {
        found.order.push_back(free.top());
        free.pop();
        for (const int next : later[found.order.back()])
            if (--earlier[next] == 0) free.push(next);
    }
    if (std::ssize(found.order) == count) return found;

    // Each remaining item is in a cycle or comes after one: use the shortest of the first few cycles found.
    constexpr int tried = 64;
    found.order.clear();
    int tries = 0;
    for (int start = 0; start < count && tries < tried; ++start) {
        if (earlier[start] == 0) continue;
        const std::vector<int> cycle = way_back(start, later);
        if (cycle.empty()) continue;
        ++tries;
        if (found.cycle.empty() || cycle.size() < found.cycle.size()) found.cycle = cycle;
    }
    return found;
}

int wrong_pairs(std::span<const HidingPair> pairs, std::span<const int> order) {
    std::vector<std::size_t> place(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) place[order[i]] = i;
    return static_cast<int>(std::count_if(
        pairs.begin(), pairs.end(), [&](const HidingPair& pair) { return place[pair.before] > place[pair.after]; }));
}

}  // namespace viewing
