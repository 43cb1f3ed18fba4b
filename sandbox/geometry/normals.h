// Normals as vectors, and their transformation by a matrix. Read plane.h next.
#pragma once

#include <glm/glm.hpp>

namespace viewing {

/// Returns the matrix that transforms normals, up to their length and sign. Its entries are the cofactors of `matrix`,
/// which exist even if `matrix` is singular (as a mirror entered by hand may be), divided by the largest magnitude so
/// that they fit into floats. If all cofactors are zero, the result is zero.
glm::dmat3 normal_matrix(const glm::dmat3& matrix);

/// Returns the unit vector in the direction of a vector of any length; 0 if the vector is zero or not finite.
glm::dvec3 direction_of(const glm::dvec3& vector);

}  // namespace viewing
