#include "topics/planes/numbers/outline.h"

#include <algorithm>
#include <cmath>

namespace viewing {
namespace {

constexpr std::size_t most_vertices = 20'000;
constexpr double touching = 1e-6;      ///< objects on the plane may reach this far behind it
constexpr double farthest = 1e3;       ///< largest ratio of a shadow's distance from the light to its vertex's distance
constexpr double straight_on = 1e-12;  ///< smaller turns, relative to the shadow's squared size, count as straight

/// A shadow in the plane's own coordinates, with the vertex that casts it.
struct Candidate {
    glm::dvec2 place;
    OutlineVertex vertex;
};

/// Returns twice the signed area of the triangle a b c, positive for a left turn.
double turn(const Candidate& a, const Candidate& b, const Candidate& c) {
    const glm::dvec2 ab = b.place - a.place, ac = c.place - a.place;
    return ab.x * ac.y - ab.y * ac.x;
}

/// Returns the shadows of the vertices that cast one.
std::vector<Candidate> candidates(const SceneObject& object, const glm::dvec4& plane, const glm::dvec4& light) {
    const double plane_dot_light = glm::dot(plane, light);
    const glm::dmat4 shadowed_world_from_world = shadow_matrix(plane, light);
    const PlanePatch patch = plane_patch(plane, 1.0);
    const std::vector<glm::vec3>& positions = object.mesh->positions;
    const std::size_t step = positions.size() / (most_vertices + 1) + 1;
    std::vector<Candidate> found;
    for (std::size_t i = 0; i < positions.size(); i += step) {
        const glm::dvec4 vertex = object.world_from_model * glm::dvec4(positions[i], 1.0);
        const glm::dvec4 shadow = shadowed_world_from_world * vertex;
        const double side = plane_dot_light < 0.0 ? -1.0 : 1.0;
        if (side * glm::dot(plane, vertex) < -touching || side * shadow.w * farthest < std::abs(plane_dot_light))
            continue;
        const glm::dvec3 there = glm::dvec3(shadow) / shadow.w;
        const glm::dvec3 from_center = there - patch.center;
        found.push_back(
            {{glm::dot(from_center, patch.u), glm::dot(from_center, patch.v)}, {glm::dvec3(vertex), there}});
    }
    return found;
}

/// Adds one half of the hull, from the first point to the last, which is left out.
template <typename Iterator>
void add_chain(Iterator begin, Iterator end, double least_turn, std::vector<OutlineVertex>& hull) {
    std::vector<const Candidate*> chain;
    for (Iterator point = begin; point != end; ++point) {
        while (chain.size() >= 2 && turn(*chain[chain.size() - 2], *chain.back(), *point) <= least_turn)
            chain.pop_back();
        chain.push_back(&*point);
    }
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) hull.push_back(chain[i]->vertex);
}

}  // namespace

std::vector<OutlineVertex> shadow_outline(const SceneObject& object, const glm::dvec4& unit_plane,
                                          const glm::dvec4& light_world) {
    if (lies_in_plane(unit_plane, light_world) || !object.mesh) return {};
    std::vector<Candidate> points = candidates(object, unit_plane, light_world);
    if (points.empty()) return {};
    std::sort(points.begin(), points.end(), [](const Candidate& a, const Candidate& b) {
        return a.place.x != b.place.x ? a.place.x < b.place.x : a.place.y < b.place.y;
    });
    glm::dvec2 low = points.front().place, high = low;
    for (const Candidate& point : points) {
        low = glm::min(low, point.place);
        high = glm::max(high, point.place);
    }
    const double size = glm::length(high - low);
    std::vector<OutlineVertex> hull;
    add_chain(points.begin(), points.end(), straight_on * size * size, hull);
    add_chain(points.rbegin(), points.rend(), straight_on * size * size, hull);
    if (hull.empty()) hull.push_back(points.front().vertex);
    return hull;
}

std::vector<OutlineVertex> thinned(const std::vector<OutlineVertex>& outline, std::size_t at_most) {
    if (outline.size() <= at_most) return outline;
    std::vector<OutlineVertex> chosen;
    for (std::size_t i = 0; i < at_most; ++i) chosen.push_back(outline[i * outline.size() / at_most]);
    return chosen;
}

}  // namespace viewing
