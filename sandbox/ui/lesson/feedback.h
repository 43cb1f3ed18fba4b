// Feedback on an answer, below the question: what the known mistake is, what is right so far, or the revealed answer.
#pragma once

#include "ui/lesson/strip.h"

namespace viewing {

/// Height of the tallest possible feedback at this width, in pixels. Also works outside a frame.
float feedback_height(const LessonRun& run, float width, const widgets::Context& context, bool presents);

void draw_feedback(const LessonRun& run, const StripLook& look, float width);

}  // namespace viewing
