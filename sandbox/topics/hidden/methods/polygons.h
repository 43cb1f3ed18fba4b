// Convex polygons in world space, which the object-space methods sort and cut. They are made from triangles, and every
// piece keeps its triangle's plane and number. Read viewpoint.h next.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "geometry/mesh.h"
#include "platform/progress.h"

namespace viewing {

/// A convex and planar polygon, counterclockwise when seen from its front.
struct Polygon {
    std::vector<glm::dvec3> vertices;  ///< three or more, world space
    glm::dvec4 plane{0.0};             ///< unit, positive in front; a piece has the plane of the whole
    int object = 0;                    ///< index of the object it belongs to
    int source = 0;                    ///< number of the input triangle, as in ID images
};

/// A direction counts as parallel to a plane if the sine of its angle with the plane is at most this.
inline constexpr double parallel_sine = 1e-12;
/// An area counts as zero if twice the area, divided by the square of the longest edge, is at most this.
inline constexpr double smallest_relative_area = 1e-12;

/// Returns the polygon with these corners, or none if it has no area: fewer than three corners, twice the area at most
/// 1e−12 times the square of the longest edge, or a corner that is not finite. If the corners are slightly out of
/// plane, the polygon gets their mean plane, which has the normal of the area and passes through the mean of the
/// corners.
std::optional<Polygon> make_polygon(std::vector<glm::dvec3> corners_world, int object, int source);

/// A placed mesh. The mesh must outlive the call that it is passed to.
struct MeshInstance {
    const Mesh* mesh = nullptr;
    glm::dmat4 world_from_model{1.0};
};

struct PolygonSet {
    std::vector<Polygon> polygons;
    int dropped = 0;  ///< triangles without area; their numbers stay unused
};

/// Returns every triangle of every mesh as a polygon. Its `object` is the index in `instances`, and `source` numbers
/// the triangles of all meshes consecutively. The winding is the mesh's, even if world_from_model mirrors, as in GL. If
/// canceled, returns only the first triangles.
PolygonSet polygons_of(std::span<const MeshInstance> instances, const WorkProgress* progress = nullptr);

/// Returns the default tolerance for points on a plane: 1e−9 of the bounds' diagonal, or 1e−9 if the diagonal is 0.
double default_epsilon(std::span<const Polygon> polygons);

Bounds bounds_of(std::span<const Polygon> polygons);
double area(const Polygon& polygon);
double total_area(std::span<const Polygon> polygons);
glm::dvec3 centroid(const Polygon& polygon);  ///< of the area

enum class PlaneSide { coplanar, front, back, spanning };

/// Returns a polygon's position relative to a unit plane. Corners within `epsilon` count as on the plane and do not
/// affect the side.
PlaneSide side_of_plane(const Polygon& polygon, const glm::dvec4& plane, double epsilon);

/// Returns the pieces in front of and behind a unit plane that the polygon spans. The ends of the cut are the same in
/// both pieces, and in any polygon that shares the edge, so no crack opens between them. Corners within `epsilon` do
/// not move: they belong to both pieces.
std::pair<Polygon, Polygon> split(const Polygon& polygon, const glm::dvec4& plane, double epsilon);

}  // namespace viewing
