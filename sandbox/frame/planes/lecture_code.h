// The lecture's two functions, ShadowMatrix and ReflectionMatrix, line by line: which element of the array a line
// fills, by which expression, which entry of the matrix that is once GL has read the array, and its value now. Source:
// lecture, Projection Shadow Matrix and Planar Reflection Matrix.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <string>

namespace viewing {

/// One line of an array fill: name[index] = expression;
struct CodeLine {
    int index = 0;           ///< of the array
    std::string expression;  ///< as C, of plane[0 … 3], lightpos[0 … 3] and dot
    int row = 0;             ///< of the entry that GL, which reads columns, makes of it
    int column = 0;
    double value = 0.0;
};

/// All lines in the order of their indices.
using CodeLines = std::array<CodeLine, 16>;

/// ShadowMatrix for a plane, of unit normal to give the S on show, and a light: it is filled by columns.
CodeLines shadow_code(const glm::dvec4& plane, const glm::dvec4& light);

/// R of a plane, of unit normal to be right; with the slide's +2ab in its second line, if so.
glm::dmat4 mirror_matrix_as_typed(const glm::dvec4& plane, bool plus_2ab);

/// ReflectionMatrix for a plane, of unit normal to be right. `printed_by_rows`: as on the slide, where the array is
/// filled by rows, so that GL gets the transpose; else by columns, which is right. `plus_2ab`: with the slip of that
/// name.
CodeLines mirror_code(const glm::dvec4& plane, bool printed_by_rows, bool plus_2ab = false);

}  // namespace viewing
