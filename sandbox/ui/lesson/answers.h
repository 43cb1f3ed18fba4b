// The inputs for the answers to a lesson's questions: choices, numbers, vectors, matrices, tiles.
#pragma once

#include "lesson/lesson_run.h"
#include "widgets/widgets.h"

namespace viewing {

/// Returns the height in pixels that draw_answers() takes up; also works outside a frame. `presents`: whether the
/// answers are for an audience, with larger choices.
float answers_height(const Ask& ask, float width, const widgets::Context& context, bool presents);

struct AnswerStyle {
    bool is_open = true;       ///< still accepts an answer
    bool shows_right = false;  ///< marks the right answer
    bool presents = false;     ///< for an audience: larger
};

/// Draws the input and edits the run's answer. Returns true when a click on a choice, or Enter in the last number
/// field, has submitted the answer. Tiles are submitted with the Check button.
bool draw_answers(LessonRun& run, const AnswerStyle& style, float width);

}  // namespace viewing
