// An exercise's own tests: each deployed variant as a lesson's step, and its answers once more by way of a hand-in.
#pragma once

#include "lesson/exercise.h"
#include "report/lesson_check.h"

namespace viewing {

struct VariantCheck {
    Result<LessonStep> step;
    LessonFindings findings;
    int wrong_answers = 0;  ///< that were told apart
};

/// What check_step says of the variant; and the model answer and each wrong one, written as a hand-in, read and judged
/// as `grade` does, must be told the same as in the window.
VariantCheck check_variant(const Exercise& exercise, std::size_t variant, Renderer& renderer);

}  // namespace viewing
