// Makes, measures and cuts polygons. Read viewpoint.cpp next.
#include "topics/hidden/methods/polygons.h"

#include <algorithm>
#include <cmath>

namespace viewing {
namespace {

constexpr double relative_epsilon = 1e-9;

/// Returns the normal whose length is twice the area. Differences from one corner keep it accurate for distant objects.
glm::dvec3 twice_area_normal(const std::vector<glm::dvec3>& corners) {
    glm::dvec3 sum(0.0);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        sum += glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
    }
    return sum;
}

double distance_from_plane(const glm::dvec4& plane, const glm::dvec3& point) {
    return plane.x * point.x + plane.y * point.y + plane.z * point.z + plane.w;
}

}  // namespace

std::optional<Polygon> make_polygon(std::vector<glm::dvec3> corners_world, int object, int source) {
    if (corners_world.size() < 3) return std::nullopt;
    double longest_squared = 0.0;
    glm::dvec3 mean(0.0);
    for (std::size_t i = 0; i < corners_world.size(); ++i) {
        const glm::dvec3 edge = corners_world[(i + 1) % corners_world.size()] - corners_world[i];
        longest_squared = std::max(longest_squared, glm::dot(edge, edge));
        mean += corners_world[i];
    }
    mean /= static_cast<double>(corners_world.size());
    const glm::dvec3 normal = twice_area_normal(corners_world);
    const double twice_area = glm::length(normal);
    if (!std::isfinite(twice_area) || !std::isfinite(mean.x + mean.y + mean.z)) return std::nullopt;
    if (twice_area <= smallest_relative_area * longest_squared) return std::nullopt;
    const glm::dvec3 unit = normal / twice_area;
    return Polygon{std::move(corners_world), glm::dvec4(unit, -glm::dot(unit, mean)), object, source};
}

PolygonSet polygons_of(std::span<const MeshInstance> instances, const WorkProgress* progress) {
    PolygonSet set;
    int source = 0, object = 0;
    std::size_t count = 0;
    for (const MeshInstance& instance : instances) count += instance.mesh->triangle_count();
    set.polygons.reserve(count);
    for (const MeshInstance& instance : instances) {
        const Mesh& mesh = *instance.mesh;
        const auto corner = [&](std::size_t index) {
            const glm::dvec3 position = mesh.positions[mesh.indices[index]];
            return glm::dvec3(instance.world_from_model * glm::dvec4(position, 1.0));
        };
        for (std::size_t i = 0; i < mesh.triangle_count(); ++i, ++source) {
            if (is_time_to_look(static_cast<std::size_t>(source)) && is_canceled(progress)) return set;
            auto polygon = make_polygon({corner(3 * i), corner(3 * i + 1), corner(3 * i + 2)}, object, source);
            if (polygon) {
                set.polygons.push_back(std::move(*polygon));
            } else {
                ++set.dropped;
            }
        }
        ++object;
    }
    return set;
}

double default_epsilon(std::span<const Polygon> polygons) {
    const Bounds bounds = bounds_of(polygons);
    const double diagonal = bounds.empty() ? 0.0 : glm::length(bounds.size());
    return relative_epsilon * (diagonal > 0.0 ? diagonal : 1.0);
}

Bounds bounds_of(std::span<const Polygon> polygons) {
    Bounds bounds;
    for (const Polygon& polygon : polygons) {
        for (const glm::dvec3& vertex : polygon.vertices) bounds.add(vertex);
    }
    return bounds;
}

double area(const Polygon& polygon) {
    return 0.5 * glm::length(twice_area_normal(polygon.vertices));
}

double total_area(std::span<const Polygon> polygons) {
    double sum = 0.0;
    for (const Polygon& polygon : polygons) sum += area(polygon);
    return sum;
}

glm::dvec3 centroid(const Polygon& polygon) {
    const std::vector<glm::dvec3>& v = polygon.vertices;
    const glm::dvec3 normal(polygon.plane);
    glm::dvec3 weighted(0.0);
    double weights = 0.0;
    for (std::size_t i = 1; i + 1 < v.size(); ++i) {
        const double weight = glm::dot(glm::cross(v[i] - v[0], v[i + 1] - v[0]), normal);
        weighted += weight * ((v[i] - v[0]) + (v[i + 1] - v[0])) / 3.0;
        weights += weight;
    }
    return weights > 0.0 ? v[0] + weighted / weights : v[0];
}

PlaneSide side_of_plane(const Polygon& polygon, const glm::dvec4& plane, double epsilon) {
    bool is_in_front = false, is_behind = false;
    for (const glm::dvec3& vertex : polygon.vertices) {
        const double distance = distance_from_plane(plane, vertex);
        is_in_front |= distance > epsilon;
        is_behind |= distance < -epsilon;
    }
    if (is_in_front) return is_behind ? PlaneSide::spanning : PlaneSide::front;
    return is_behind ? PlaneSide::back : PlaneSide::coplanar;
}

std::pair<Polygon, Polygon> split(const Polygon& polygon, const glm::dvec4& plane, double epsilon) {
    Polygon front{{}, polygon.plane, polygon.object, polygon.source};
    Polygon back = front;
    const std::size_t count = polygon.vertices.size();
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec3& here = polygon.vertices[i];
        const glm::dvec3& next = polygon.vertices[(i + 1) % count];
        const double here_distance = distance_from_plane(plane, here);
        const double next_distance = distance_from_plane(plane, next);
        if (here_distance >= -epsilon) front.vertices.push_back(here);
        if (here_distance <= epsilon) back.vertices.push_back(here);
        const bool leaves = here_distance > epsilon && next_distance < -epsilon;
        const bool enters = here_distance < -epsilon && next_distance > epsilon;
        if (leaves || enters) {
            // Always compute the cut from the front end to the back end, since a neighbor traverses this edge in the
            // opposite direction.
            const glm::dvec3& from = leaves ? here : next;
            const glm::dvec3& to = leaves ? next : here;
            const double from_distance = leaves ? here_distance : next_distance;
            const double to_distance = leaves ? next_distance : here_distance;
            const glm::dvec3 cut = from + (from_distance / (from_distance - to_distance)) * (to - from);
            front.vertices.push_back(cut);
            back.vertices.push_back(cut);
        }
    }
    return {std::move(front), std::move(back)};
}

}  // namespace viewing
