// Makes a coarser substitute for a mesh that is slow to draw, for use during motion.
#pragma once

#include "geometry/mesh.h"

namespace viewing {

/// Divides the mesh's bounds into cubic cells, and returns the mesh with all vertices of each cell merged at their
/// mean, without the triangles that collapse or become duplicates. `cells` (at least 1) is the number of cells along
/// the longest side of the bounds. No vertex moves by more than a cell's diagonal; windings are kept, and normals are
/// averaged. Takes time proportional to the size of the mesh. Source: Rossignac and Borrel, Multi-resolution 3D
/// approximations for rendering complex scenes, 1993.
Mesh simplified(const Mesh& mesh, int cells);

/// Simplifies with fewer and fewer cells until at most `most_triangles` are left.
Mesh simplified_to(const Mesh& mesh, std::size_t most_triangles);

}  // namespace viewing
