// Convex polygons in world space: what the object-space methods sort and cut. Made from triangles; every piece keeps
// the plane and the number of the triangle it came from. Read viewpoint.h next.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "geometry/mesh.h"
#include "platform/progress.h"

namespace viewing {

/// Convex and planar, counter-clockwise seen from its front.
struct Polygon {
    std::vector<glm::dvec3> vertices;  ///< three or more, world space
    glm::dvec4 plane{0.0};             ///< unit, positive in front; a piece has that of the whole
    int object = 0;                    ///< index of the object it belongs to
    int source = 0;                    ///< number of the input triangle: what id images hold
};

/// Below this sine a direction counts as lying in a plane.
inline constexpr double parallel_sine = 1e-12;
/// Twice an area below this share of the longest edge squared is none.
inline constexpr double smallest_relative_area = 1e-12;

/// The polygon with these corners, or none when it has no area: fewer than three corners, twice the area at most 1e−12
/// of the longest edge squared, or a corner that is not finite. Corners that are slightly out of plane get the mean
/// plane: its normal is the area's, and it goes through the mean of the corners.
std::optional<Polygon> make_polygon(std::vector<glm::dvec3> corners_world, int object, int source);

/// A mesh in its place. The mesh outlives the call it is passed to.
struct MeshInstance {
    const Mesh* mesh = nullptr;
    glm::dmat4 world_from_model{1.0};
};

struct PolygonSet {
    std::vector<Polygon> polygons;
    int dropped = 0;  ///< triangles without area; their numbers stay unused
};

/// Every triangle of every mesh; `object` is the index in `instances`, `source` counts triangles over all of them.
/// The winding is the mesh's, also under a mirroring world_from_model, as GL sees it. Cancelled: the first of them.
PolygonSet polygons_of(std::span<const MeshInstance> instances, const WorkProgress* progress = nullptr);

/// How near to a plane counts as on it, unless a method is told otherwise: 1e−9 of the diagonal of the bounds. The same
/// fraction of 1 when there is no extent.
double default_epsilon(std::span<const Polygon> polygons);

Bounds bounds_of(std::span<const Polygon> polygons);
double area(const Polygon& polygon);
double total_area(std::span<const Polygon> polygons);
glm::dvec3 centroid(const Polygon& polygon);  ///< of the area

enum class PlaneSide { coplanar, front, back, spanning };

/// Where a polygon lies as to a unit plane. Corners within `epsilon` lie on it and go with either side.
PlaneSide side_of_plane(const Polygon& polygon, const glm::dvec4& plane, double epsilon);

/// The pieces in front of and behind a unit plane that the polygon spans. The cut's ends are the same in both pieces,
/// and the same for any polygon that shares the edge, so no crack opens between them. Corners within `epsilon` are not
/// moved: they belong to both pieces.
std::pair<Polygon, Polygon> split(const Polygon& polygon, const glm::dvec4& plane, double epsilon);

}  // namespace viewing
