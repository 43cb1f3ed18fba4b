#include "frame/matrix_facts.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace viewing {

double largest_entry(const glm::dmat4& matrix) {
    double largest = 0.0;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) largest = std::max(largest, std::abs(matrix[column][row]));
    return largest;
}

double shadow_residual(const glm::dmat4& shadowed_world_from_world, double plane_dot_light) {
    return largest_entry(shadowed_world_from_world * shadowed_world_from_world -
                         plane_dot_light * shadowed_world_from_world);
}

double mirror_residual(const glm::dmat4& mirrored_world_from_world) {
    return largest_entry(mirrored_world_from_world * mirrored_world_from_world - glm::dmat4(1.0));
}

double largest_difference_up_to_scale(const glm::dmat4& matrix, const glm::dmat4& reference) {
    double product = 0.0, square = 0.0;
    for (int column = 0; column < 4; ++column) {
        product += glm::dot(matrix[column], reference[column]);
        square += glm::dot(matrix[column], matrix[column]);
    }
    return largest_entry(reference - (square > 0.0 ? product / square : 0.0) * matrix);
}

int rank_of(glm::dmat4 matrix) {
    const double threshold = largest_entry(matrix) * 1e-9;
    int rank = 0;
    for (int step = 0; step < 4; ++step) {
        int pivot_column = step, pivot_row = step;
        for (int column = step; column < 4; ++column)
            for (int row = step; row < 4; ++row)
                if (std::abs(matrix[column][row]) > std::abs(matrix[pivot_column][pivot_row])) {
                    pivot_column = column;
                    pivot_row = row;
                }
        if (std::abs(matrix[pivot_column][pivot_row]) <= threshold) break;
        std::swap(matrix[step], matrix[pivot_column]);
        for (int column = 0; column < 4; ++column) std::swap(matrix[column][step], matrix[column][pivot_row]);
        for (int column = step + 1; column < 4; ++column)
            matrix[column] -= matrix[step] * (matrix[column][step] / matrix[step][step]);
        ++rank;
    }
    return rank;
}

}  // namespace viewing
