// What is measured of a matrix.
#pragma once

#include <glm/glm.hpp>

namespace viewing {

/// The largest absolute entry: of a difference it is the residual.
double largest_entry(const glm::dmat4& matrix);

/// Rank by Gaussian elimination with full pivoting; entries below 1e-9 of the largest count as zero.
int rank_of(glm::dmat4 matrix);

}  // namespace viewing
