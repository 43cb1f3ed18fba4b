// A coarser stand-in for a mesh that is slow to draw, for as long as it moves.
#pragma once

#include "geometry/mesh.h"

namespace viewing {

/// The mesh with all vertices of a cell put into their middle, and without the triangles that vanish by it or become
/// the same; `cells` (at least 1) is how many there are along the longest side of its bounds. No vertex is moved by
/// more than a cell's diagonal; windings stay, normals are averaged. Takes time in proportion to the mesh.
/// Source: Rossignac and Borrel, Multi-resolution 3D approximations for rendering complex scenes, 1993.
Mesh simplified(const Mesh& mesh, int cells);

/// With as many cells as leave it at most so many triangles.
Mesh simplified_to(const Mesh& mesh, std::size_t most_triangles);

}  // namespace viewing
