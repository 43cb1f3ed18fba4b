// States that show the effect of an entered matrix, and that of the right one, on the picture.
#pragma once

#include <vector>

#include "lesson/lesson.h"

namespace viewing {

/// Returns the start of a step, but with a shadow that is also visible beyond the edge of the plane.
LoadedState with_right_matrix(const LessonStep& step);

/// Returns the same start with 16 entered numbers, row by row, as the matrix that the step asks for (Ask::shows_as). If
/// the question allows any factor, chooses the sign for which points near the origin get w > 0 and so stay in front of
/// the eye. Fails if the field refuses the numbers.
Result<LoadedState> with_typed_matrix(const LessonStep& step, const std::vector<double>& numbers);

}  // namespace viewing
