// The shapes of the scene format, made from formulas. They are wound counterclockwise as seen from outside and have
// unit normals; all except the triangle are centered on their origin.
#pragma once

#include <array>

#include "geometry/mesh.h"

namespace viewing {

Mesh box_mesh();                                                ///< side 2, flat normals (24 vertices)
Mesh sphere_mesh(int slices = 48, int stacks = 24);             ///< radius 1, poles on the y axis
Mesh torus_mesh(int slices = 64, int sides = 32);               ///< radii 0.9 and 0.34, axis y
Mesh cylinder_mesh(int slices = 48);                            ///< radius 1, height 2, axis y, closed
Mesh cone_mesh(int slices = 48);                                ///< radius 1, height 2, axis y, tip up, closed
Mesh quad_mesh();                                               ///< side 2 in the plane y = 0, front face up
Mesh triangle_mesh(const std::array<glm::dvec3, 3>& vertices);  ///< one flat triangle, front face counterclockwise

/// Returns Newell's teapot: 32 bicubic Bézier patches, each cut into resolution × resolution × 2 triangles. Its axis is
/// y; it is centered, and scaled so that its longest side is 2. Leaves out degenerate triangles at the poles.
/// `resolution` is clamped to 1 … 64.
Mesh teapot_mesh(int resolution = 10);

/// Centers the mesh on its bounds and scales it uniformly to a longest side of 2. A mesh without extent is only
/// centered.
void center_and_fit(Mesh& mesh);

}  // namespace viewing
