// What is measured of a matrix.
#pragma once

#include <glm/glm.hpp>

namespace viewing {

/// The largest absolute entry: of a difference it is the residual.
double largest_entry(const glm::dmat4& matrix);

/// How far a shadow matrix is from S² = (Π·L) S, and a mirror matrix from R² = I: largest absolute entries.
double shadow_residual(const glm::dmat4& shadowed_world_from_world, double plane_dot_light);
double mirror_residual(const glm::dmat4& mirrored_world_from_world);

/// The largest absolute entry of the difference between two homogeneous matrices, which are the same map up to a
/// factor: `matrix` is multiplied by the one that brings it nearest to `reference`. A zero matrix is as far away as it
/// is.
double largest_difference_up_to_scale(const glm::dmat4& matrix, const glm::dmat4& reference);

/// Rank by Gaussian elimination with full pivoting; entries below 1e-9 of the largest count as zero.
int rank_of(glm::dmat4 matrix);

}  // namespace viewing
