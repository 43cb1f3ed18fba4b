// Two ways to distinguish front faces from back faces. Read painter.cpp next.
#include "topics/hidden/methods/culling.h"

#include <algorithm>
#include <cmath>

namespace viewing {
namespace {

Facing facing_of(double signed_measure, double tolerance, FrontFace front) {
    if (std::abs(signed_measure) <= tolerance) return Facing::neither;
    return (signed_measure > 0.0) == (front == FrontFace::ccw) ? Facing::towards : Facing::away;
}

/// Returns the corners of the part beyond the near plane, in normalized device coordinates.
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

/// A polygon's area, positive if it is counterclockwise, and its `size`: the longest distance from its first corner.
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

/// Decides based on which side of a polygon's plane the eye is on.
class PlaneFacing {
public:
    PlaneFacing(std::span<const Polygon> polygons, const Viewpoint& viewpoint, FrontFace front)
        : eye_world_(viewpoint.eye_world()),
          tolerance_(eye_world_.w != 0.0 ? default_epsilon(polygons) : parallel_sine),
          front_(front) {}
    Facing of(const Polygon& polygon) const {
        return facing_of(glm::dot(polygon.plane, eye_world_), tolerance_, front_);
    }

private:
    const glm::dvec4 eye_world_;
    const double tolerance_;
    const FrontFace front_;
};

/// Decides by the sign of the screen area of the part beyond the near plane. The result is `neither` if all of the
/// polygon is clipped, or if twice its screen area is at most 1e−12 times the square of its size on the screen. A
/// mirrored view swaps clockwise and counterclockwise on the screen, so pass the other winding for it, as for GL.
class ScreenFacing {
public:
    ScreenFacing(const Viewpoint& viewpoint, FrontFace front)
        : clip_from_world_(viewpoint.clip_from_world()), front_(front) {}
    Facing of(const Polygon& polygon) const {
        const auto [twice_area, size] = screen_area(clipped_and_projected(polygon, clip_from_world_));
        return facing_of(twice_area, smallest_relative_area * size * size, front_);
    }

private:
    const glm::dmat4 clip_from_world_;
    const FrontFace front_;
};

}  // namespace

std::vector<Facing> facing_by_plane(std::span<const Polygon> polygons, const Viewpoint& viewpoint, FrontFace front) {
    const PlaneFacing facing(polygons, viewpoint, front);
    std::vector<Facing> result;
    result.reserve(polygons.size());
    for (const Polygon& polygon : polygons) result.push_back(facing.of(polygon));
    return result;
}

CullCounts count_facing(std::span<const Polygon> polygons, const Viewpoint& viewpoint, FrontFace front,
                        const WorkProgress* progress) {
    const PlaneFacing plane(polygons, viewpoint, front);
    const ScreenFacing screen(viewpoint, front);
    CullCounts counts;
    for (const Polygon& polygon : polygons) {
        if (is_time_to_look(static_cast<std::size_t>(counts.input)) && is_canceled(progress)) break;
        const Facing by_plane = plane.of(polygon), on_screen = screen.of(polygon);
        ++counts.input;
        ++(by_plane == Facing::neither   ? counts.edge_on
           : by_plane == Facing::towards ? counts.facing_towards
                                         : counts.facing_away);
        ++(on_screen == Facing::neither   ? counts.gl_none
           : on_screen == Facing::towards ? counts.gl_front
                                          : counts.gl_back);
        const bool both_tell = by_plane != Facing::neither && on_screen != Facing::neither;
        counts.disagree += both_tell && by_plane != on_screen;
    }
    return counts;
}

std::vector<Polygon> culled(std::span<const Polygon> polygons, const Viewpoint& viewpoint, CullFace faces,
                            FrontFace front, const WorkProgress* progress) {
    std::vector<Polygon> left;
    if (faces == CullFace::front_and_back) return left;
    const Facing goes = faces == CullFace::front ? Facing::towards : Facing::away;
    const PlaneFacing facing(polygons, viewpoint, front);
    for (std::size_t i = 0; i < polygons.size() && !is_cut_short(i, progress); ++i)
        if (facing.of(polygons[i]) != goes) left.push_back(polygons[i]);
    return left;
}

}  // namespace viewing
