// What normals are as vectors, and how they follow a matrix. Read plane.h next.
#pragma once

#include <glm/glm.hpp>

namespace viewing {

/// The matrix for normals up to their length and sign: the cofactors of `matrix`, which one that flattens has too (a
/// mirror by hand), divided by the largest of them so that they fit into floats. All zero where they all are.
glm::dmat3 normal_matrix(const glm::dmat3& matrix);

/// Towards where a vector points, of length 1, whatever its length is; 0 where it points nowhere.
glm::dvec3 direction_of(const glm::dvec3& vector);

}  // namespace viewing
