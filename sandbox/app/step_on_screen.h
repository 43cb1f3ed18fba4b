// Checks whether the answer to a lesson's step is already visible in the window before it is revealed.
#pragma once

#include "grading/lesson_check.h"

namespace viewing {

/// Returns a finding for each part of the answer that is visible in the window, outside the strip with the question
/// (seen_answers). Needs a renderer and its current context. The window is in English.
LessonFindings check_screen(const std::string& lesson_id, const LessonStep& step, const Measurer& measurer);

}  // namespace viewing
