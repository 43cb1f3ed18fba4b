// Two ways to tell a front from a back. Read painter.cpp next.
#include "visibility/culling.h"

#include <algorithm>
#include <cmath>

namespace viewing {
namespace {

Facing facing_of(double signed_measure, double tolerance, FrontFace front) {
    if (std::abs(signed_measure) <= tolerance) return Facing::neither;
    return (signed_measure > 0.0) == (front == FrontFace::ccw) ? Facing::towards : Facing::away;
}

/// What is in front of the near plane, divided by w: corners in normalised device coordinates.
std::vector<glm::dvec2> clipped_and_projected(const Polygon& polygon, const glm::dmat4& clip_from_world) {
    std::vector<glm::dvec2> corners;
    const std::size_t count = polygon.vertices.size();
    const auto clip_point = [&](std::size_t i) {
        return clip_from_world * glm::dvec4(polygon.vertices[i % count], 1.0);
    };
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec4 here = clip_point(i), next = clip_point(i + 1);
        const double here_distance = here.z + here.w, next_distance = next.z + next.w;
        if (here_distance >= 0.0) corners.push_back(glm::dvec2(here) / here.w);
        if ((here_distance >= 0.0) == (next_distance >= 0.0)) continue;
        const glm::dvec4 cut = here + here_distance / (here_distance - next_distance) * (next - here);
        corners.push_back(glm::dvec2(cut) / cut.w);
    }
    return corners;
}

/// Positive for counter-clockwise; `size` is the longest distance from the first corner.
struct ScreenArea {
    double twice_area = 0.0, size = 0.0;
};

ScreenArea screen_area(const std::vector<glm::dvec2>& corners) {
    ScreenArea result;
    for (std::size_t i = 1; i < corners.size(); ++i) {
        const glm::dvec2 a = corners[i - 1] - corners[0], b = corners[i] - corners[0];
        result.twice_area += a.x * b.y - a.y * b.x;
        result.size = std::max(result.size, glm::length(b));
    }
    return result;
}

}  // namespace

std::vector<Facing> facing_by_plane(std::span<const Polygon> polygons, const Viewpoint& viewpoint, FrontFace front) {
    const glm::dvec4 eye_world = viewpoint.eye_world();
    const double tolerance = eye_world.w != 0.0 ? default_epsilon(polygons) : parallel_sine;
    std::vector<Facing> result;
    result.reserve(polygons.size());
    for (const Polygon& polygon : polygons) {
        result.push_back(facing_of(glm::dot(polygon.plane, eye_world), tolerance, front));
    }
    return result;
}

std::vector<Facing> facing_on_screen(std::span<const Polygon> polygons, const Viewpoint& viewpoint, FrontFace front) {
    const glm::dmat4 clip_from_world = viewpoint.clip_from_world();
    std::vector<Facing> result;
    result.reserve(polygons.size());
    for (const Polygon& polygon : polygons) {
        const auto [twice_area, size] = screen_area(clipped_and_projected(polygon, clip_from_world));
        result.push_back(facing_of(twice_area, smallest_relative_area * size * size, front));
    }
    return result;
}

CullCounts count_facing(std::span<const Polygon> polygons, const Viewpoint& viewpoint, FrontFace front) {
    const std::vector<Facing> by_plane = facing_by_plane(polygons, viewpoint, front);
    const std::vector<Facing> on_screen = facing_on_screen(polygons, viewpoint, front);
    const auto count = [](const std::vector<Facing>& facing, Facing wanted) {
        return static_cast<int>(std::count(facing.begin(), facing.end(), wanted));
    };
    CullCounts counts{.input = static_cast<int>(polygons.size()),
                      .facing_towards = count(by_plane, Facing::towards),
                      .facing_away = count(by_plane, Facing::away),
                      .edge_on = count(by_plane, Facing::neither),
                      .gl_front = count(on_screen, Facing::towards),
                      .gl_back = count(on_screen, Facing::away),
                      .gl_none = count(on_screen, Facing::neither)};
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        const bool both_tell = by_plane[i] != Facing::neither && on_screen[i] != Facing::neither;
        counts.disagree += both_tell && by_plane[i] != on_screen[i];
    }
    return counts;
}

std::vector<Polygon> culled(std::span<const Polygon> polygons, const Viewpoint& viewpoint, CullFace faces,
                            FrontFace front) {
    std::vector<Polygon> left;
    if (faces == CullFace::front_and_back) return left;
    const Facing goes = faces == CullFace::front ? Facing::towards : Facing::away;
    const std::vector<Facing> facing = facing_by_plane(polygons, viewpoint, front);
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        if (facing[i] != goes) left.push_back(polygons[i]);
    }
    return left;
}

}  // namespace viewing
