// The lecture's two functions, ShadowMatrix and ReflectionMatrix, line by line: the array element that a line fills,
// its expression, the matrix entry that GL reads it as, and its current value. Source: lecture, Projection Shadow
// Matrix and Planar Reflection Matrix.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <string>

namespace viewing {

/// One line of an array fill: name[index] = expression;
struct CodeLine {
    int index = 0;           ///< in the array
    std::string expression;  ///< in C, in terms of plane[0 … 3], lightpos[0 … 3] and dot
    int row = 0;             ///< of the matrix entry that it becomes, since GL reads by columns
    int column = 0;
    double value = 0.0;
};

/// All lines in the order of their indices.
using CodeLines = std::array<CodeLine, 16>;

/// Returns the lines of ShadowMatrix, which fills its array by columns, for a plane and a light. Their values equal the
/// displayed S only if the normal is a unit vector.
CodeLines shadow_code(const glm::dvec4& plane, const glm::dvec4& light);

/// Returns R for a plane, correct only for a unit normal; with `plus_2ab`, its second row has the slide's +2ab.
glm::dmat4 mirror_matrix_as_typed(const glm::dvec4& plane, bool plus_2ab);

/// Returns the lines of ReflectionMatrix for a plane, correct only for a unit normal. `printed_by_rows`: the array is
/// filled by rows as on the slide, so GL gets the transpose; otherwise it is filled by columns, which is correct.
/// `plus_2ab`: as in mirror_matrix_as_typed().
CodeLines mirror_code(const glm::dvec4& plane, bool printed_by_rows, bool plus_2ab = false);

}  // namespace viewing
