#include "topics/planes/numbers/lecture_code.h"

#include "geometry/plane.h"

namespace viewing {
namespace {

std::string element(const char* name, int index) {
    return name + ("[" + std::to_string(index) + "]");
}

/// Returns the slide's expression for an entry of R.
std::string mirror_expression(int row, int column) {
    if (row == 3) return column == 3 ? "1.0" : "0.0";
    return (row == column ? "1 - 2 * " : "- 2 * ") + element("plane", row) + " * " + element("plane", column);
}

}  // namespace

CodeLines shadow_code(const glm::dvec4& plane, const glm::dvec4& light) {
    const glm::dmat4 shadow = shadow_matrix(plane, light);
    CodeLines lines;
    for (int index = 0; index < 16; ++index) {
        const int row = index % 4, column = index / 4;
        const std::string product = element("lightpos", row) + " * " + element("plane", column);
        lines[index] = {index, (row == column ? "dot - " : "0.f - ") + product, row, column, shadow[column][row]};
    }
    return lines;
}

glm::dmat4 mirror_matrix_as_typed(const glm::dvec4& plane, bool plus_2ab) {
    glm::dmat4 mirror = mirror_matrix(plane);
    if (plus_2ab) mirror[0][1] = -mirror[0][1];
    return mirror;
}

CodeLines mirror_code(const glm::dvec4& plane, bool printed_by_rows, bool plus_2ab) {
    const glm::dmat4 mirror = mirror_matrix_as_typed(plane, plus_2ab);
    CodeLines lines;
    for (int index = 0; index < 16; ++index) {
        const int row = index % 4, column = index / 4;
        const int mirror_row = printed_by_rows ? column : row, mirror_column = printed_by_rows ? row : column;
        std::string expression = mirror_expression(mirror_row, mirror_column);
        if (plus_2ab && mirror_row == 1 && mirror_column == 0) expression.erase(0, 2);  // drop the minus
        lines[index] = {index, expression, row, column, mirror[mirror_column][mirror_row]};
    }
    return lines;
}

}  // namespace viewing
