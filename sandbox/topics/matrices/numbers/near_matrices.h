// Comparisons of matrices that were typed or rounded to float32. Part of explain_matrix.h.
#pragma once

#include <glm/glm.hpp>

namespace viewing {

inline double entry(const glm::dmat4& m, int row, int column) {
    return m[column][row];
}

/// Returns whether two numbers differ by at most `tolerance` plus 2e-6 of the larger magnitude, which allows for
/// float32 rounding.
bool is_near(double a, double b, double tolerance);
bool is_same(const glm::dmat4& a, const glm::dmat4& b, double tolerance);
/// Compares two matrices up to a positive factor: a negative one changes the sign of w.
bool is_same_map(const glm::dmat4& a, const glm::dmat4& b, double tolerance);
bool is_same_direction(const glm::dvec4& a, const glm::dvec4& b, double tolerance);
bool has_row(const glm::dmat4& m, int row, const glm::dvec4& values, double tolerance);
/// Returns whether the last row is (0, 0, 0, 1).
bool has_affine_row(const glm::dmat4& m, double tolerance);

}  // namespace viewing
