// The matrix in an answer: entered numbers, or the product of the factors on its tiles. Also the states that show the
// effect of that matrix, and of the right one, on the picture.
#pragma once

#include <glm/mat4x4.hpp>
#include <string>
#include <vector>

#include "lesson/formulas/expression.h"
#include "lesson/lesson.h"
#include "lesson/tree.h"

namespace viewing {

/// Refuses a list of factors without exactly one for each tile, and a `shows_as` that names an unknown field.
void check_shown_matrix(const Ask& ask, const Where& where);

/// Returns the matrix with these 16 numbers, given row by row.
glm::dmat4 matrix_of_rows(const std::vector<double>& numbers);

/// Returns the running products of these items' factors, as written from left to right: the product of the first one,
/// of the first two, and so on. Fails if a factor is not a 4×4 matrix.
Result<std::vector<glm::dmat4>> products_of(const Ask& ask, const std::vector<int>& items,
                                            const Surroundings& surroundings);

/// Returns the start of a step, but with a shadow that is also visible beyond the edge of the plane.
LoadedState with_right_matrix(const LessonStep& step);

/// Returns with_right_matrix() with this matrix in the field that shows the answer (Ask::shows_as), or the step's start
/// with the camera whose C or V is this matrix. If the question allows any factor, chooses the sign for which points
/// near the origin get w > 0 and so stay in front of the eye. Fails if the field refuses the numbers, or if no camera
/// has the matrix.
Result<LoadedState> with_typed_matrix(const LessonStep& step, const glm::dmat4& matrix);

}  // namespace viewing
