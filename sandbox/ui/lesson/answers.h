// How the questions of a lesson are answered in the window: choices, numbers, vectors, matrices, tiles.
#pragma once

#include "lesson/run.h"
#include "widgets/widgets.h"

namespace viewing {

/// Pixels below each other that draw_answers() takes; also outside a frame. `presents`: choices are larger.
float answers_height(const Ask& ask, float width, const widgets::Context& context, bool presents);

struct AnswerStyle {
    bool is_open = true;       ///< it can be answered still
    bool shows_right = false;  ///< the right answer is marked
    bool presents = false;     ///< in front of a room: larger, with bars of raised hands in place of a click
};

/// Edits the run's answer. True when it was given with this: a choice that was clicked. What is typed or put in order
/// is given by Check.
bool draw_answers(LessonRun& run, const AnswerStyle& style, float width);

/// Whether answers of that kind are given by a button of their own.
bool needs_check(AskKind kind);

}  // namespace viewing
