// Rays for picking and dragging: makes the ray through a pixel, and intersects rays with planes, lines, triangles and
// whole meshes. Read navigation.h next.
#pragma once

#include <array>
#include <cstddef>
#include <glm/glm.hpp>
#include <optional>

#include "geometry/mesh.h"

namespace viewing {

/// origin + t · direction, t ≥ 0. t is in units of the length of `direction`, which need not be 1.
struct Ray {
    glm::dvec3 origin, direction;

    glm::dvec3 at(double t) const { return origin + t * direction; }
};

/// Returns the ray through a point of the window, `ndc` in −1 … 1 with y up. The ray starts on the near plane, has a
/// unit direction, and is in the space that `clip_from_world` maps from. The matrix must be invertible and have a clip
/// range of −1 … 1.
Ray ray_through_pixel(const glm::dmat4& clip_from_world, const glm::dvec2& ndc);

/// Returns the t at which the ray meets the plane a x + b y + c z + d = 0; none if the ray is parallel to the plane or
/// the plane is behind the ray's origin.
std::optional<double> intersect_plane(const Ray& ray, const glm::dvec4& plane);

/// Returns the s at which origin + s · direction is nearest to the ray, for dragging along an axis. Returns none if the
/// two are parallel, or if the nearest point is behind the ray's origin.
std::optional<double> closest_point_parameter_on_line(const Ray& ray, const glm::dvec3& origin,
                                                      const glm::dvec3& direction);

/// A point of a triangle a b c: barycentric.x · a + barycentric.y · b + barycentric.z · c.
struct TriangleHit {
    double t;
    glm::dvec3 barycentric;
};

/// Returns the hit of a ray on a triangle, from either side; the edges count as inside. Returns none for a triangle
/// that has no area or is seen edge-on. Source: Möller and Trumbore 1997.
std::optional<TriangleHit> intersect_triangle(const Ray& ray, const std::array<glm::dvec3, 3>& triangle);

/// Returns whether the part 0 ≤ t < `limit` of a ray meets a box.
bool meets_box(const Ray& ray, const Bounds& box, double limit);

struct MeshHit {
    std::size_t triangle;  ///< its indices begin at mesh.indices[3 · triangle]
    double t;
    glm::dvec3 barycentric;
};

/// Returns the nearest hit, after testing every triangle; the ray is in model space.
std::optional<MeshHit> intersect_mesh(const Ray& ray_in_model, const Mesh& mesh);

}  // namespace viewing
