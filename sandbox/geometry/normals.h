// Normals as vectors, and their transformation by a matrix. Read plane.h next.
#pragma once

#include <glm/glm.hpp>

namespace viewing {

/// Returns the matrix for normals, up to their length and sign: the cofactors of `matrix`, which exist even if it is
/// singular (a mirror entered by hand), divided by the largest so that they fit into floats. If all cofactors are zero,
/// so are all entries.
glm::dmat3 normal_matrix(const glm::dmat3& matrix);

/// Returns the unit vector in the direction of a vector of any length; 0 if it has no direction.
glm::dvec3 direction_of(const glm::dvec3& vector);

}  // namespace viewing
