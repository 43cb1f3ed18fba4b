#include "geometry/normals.h"

#include <algorithm>
#include <cmath>

namespace viewing {

glm::dmat3 normal_matrix(const glm::dmat3& matrix) {
    const glm::dmat3 cofactors(glm::cross(matrix[1], matrix[2]), glm::cross(matrix[2], matrix[0]),
                               glm::cross(matrix[0], matrix[1]));
    double largest = 0.0;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) largest = std::max(largest, std::abs(cofactors[column][row]));
    return largest > 0.0 ? cofactors / largest : cofactors;
}

glm::dvec3 direction_of(const glm::dvec3& vector) {
    const double largest = std::max({std::abs(vector.x), std::abs(vector.y), std::abs(vector.z)});
    const bool is_finite = std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
    return is_finite && largest > 0.0 ? glm::normalize(vector / largest) : glm::dvec3(0.0);
}

}  // namespace viewing
