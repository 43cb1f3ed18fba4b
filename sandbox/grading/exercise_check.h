// An exercise's own tests. Checks each deployed variant like a step of a lesson, and then checks its answers again
// through a hand-in.
#pragma once

#include "grading/lesson_check.h"
#include "lesson/exercise.h"

namespace viewing {

struct VariantCheck {
    Result<LessonStep> step;
    LessonFindings findings;
    int wrong_answers = 0;  ///< number of wrong answers that were recognized
};

/// Returns the findings of check_step() for the variant. In addition, the model answer and each wrong one are written
/// to a hand-in, read back and judged as in `grade`, and must get the same verdict as in the window.
VariantCheck check_variant(const Exercise& exercise, std::size_t variant, const Measurer& measurer);

}  // namespace viewing
