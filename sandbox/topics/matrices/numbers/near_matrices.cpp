#include "topics/matrices/numbers/near_matrices.h"

#include <algorithm>
#include <cmath>

#include "frame/matrix_facts.h"

namespace viewing {

bool is_near(double a, double b, double tolerance) {
    return std::abs(a - b) <= tolerance + 2e-6 * std::max(std::abs(a), std::abs(b));
}

bool is_same(const glm::dmat4& a, const glm::dmat4& b, double tolerance) {
    for (int i = 0; i < 16; ++i)
        if (!is_near(a[i / 4][i % 4], b[i / 4][i % 4], tolerance)) return false;
    return true;
}

bool is_same_map(const glm::dmat4& a, const glm::dmat4& b, double tolerance) {
    const double size = largest_entry(b), own = largest_entry(a);
    double product = 0.0;
    for (int column = 0; column < 4; ++column) product += glm::dot(a[column], b[column]);
    return product > 0.0 &&
           largest_difference_up_to_scale(a, b) <= 2e-6 * size + tolerance * std::max(1.0, 2.0 * size / own);
}

bool is_same_direction(const glm::dvec4& a, const glm::dvec4& b, double tolerance) {
    const glm::dvec4 unit_a = glm::normalize(a), unit_b = glm::normalize(b);
    return std::min(glm::length(unit_a - unit_b), glm::length(unit_a + unit_b)) <= 1e-5 + 4.0 * tolerance;
}

bool has_row(const glm::dmat4& m, int row, const glm::dvec4& values, double tolerance) {
    for (int column = 0; column < 4; ++column)
        if (!is_near(entry(m, row, column), values[column], tolerance)) return false;
    return true;
}

bool has_affine_row(const glm::dmat4& m, double tolerance) {
    return has_row(m, 3, {0, 0, 0, 1}, tolerance);
}

}  // namespace viewing
