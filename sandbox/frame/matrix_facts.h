// Measures matrices: residuals, differences and rank.
#pragma once

#include <glm/glm.hpp>

namespace viewing {

/// Returns the largest absolute entry; for a difference of matrices, that is the residual.
double largest_entry(const glm::dmat4& matrix);

/// Return the residuals of S² = (Π·L) S for a shadow matrix and of R² = I for a mirror matrix, as largest absolute
/// entries.
double shadow_residual(const glm::dmat4& shadowed_world_from_world, double plane_dot_light);
double mirror_residual(const glm::dmat4& mirrored_world_from_world);

/// Returns the largest absolute entry of the difference between two homogeneous matrices that represent the same map up
/// to a factor: `matrix` is first scaled to best match `reference`. A zero matrix stays zero.
double largest_difference_up_to_scale(const glm::dmat4& matrix, const glm::dmat4& reference);

/// Returns the rank by Gaussian elimination with full pivoting. Entries below 1e-9 times the largest entry count as
/// zero.
int rank_of(glm::dmat4 matrix);

}  // namespace viewing
