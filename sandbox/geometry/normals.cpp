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

}  // namespace viewing
