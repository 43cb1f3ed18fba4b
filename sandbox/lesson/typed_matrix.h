// What a matrix that somebody typed does to the picture, beside what the right one does.
#pragma once

#include <vector>

#include "lesson/lesson.h"

namespace viewing {

/// The beginning of a step as it is, but that a shadow which falls beside the plane can be seen.
LoadedState with_right_matrix(const LessonStep& step);

/// The same with 16 numbers, row by row, in place of the matrix that the step asks for (Ask::shows_as). A matrix counts
/// up to its factor where the question says so: of its two signs it has the one that leaves what is near the origin in
/// front of the eye, w > 0. The error: the field refuses the numbers.
Result<LoadedState> with_typed_matrix(const LessonStep& step, const std::vector<double>& numbers);

}  // namespace viewing
