// Finds an answer that can be read off the screen before the question is answered. Pure; app/step_on_screen.h collects
// the texts of a step's window.
#pragma once

#include <string>
#include <vector>

#include "lesson/lesson.h"

namespace viewing {

/// A text on one line of the window.
struct SeenText {
    std::string text;
    std::string place;  ///< the part of the window that contains it
    float left_px = 0.0F, right_px = 0.0F, baseline_px = 0.0F;
    float em_px = 0.0F;  ///< font size
};

/// Returns a sentence for each part of the answer that the texts give away. `right` is the model answer; the texts are
/// all in English. A finding is:
/// - a number that equals the right one in all digits shown, if it has at least three significant digits;
/// - a row or a column of numbers that equals a vector or a row of a matrix, if it has two different entries other than
///   0, 1 and −1;
/// - the right choice as a whole line or a whole number, if no wrong choice is visible;
/// - a row or a column of texts that equals the right order of three or more items.
/// Texts in the step's own sentences, question and hints do not count as findings, nor do those in its own controls
/// (layout.controls), which the question takes as given.
std::vector<std::string> seen_answers(const LessonStep& step, const Answer& right, const std::vector<SeenText>& texts);

}  // namespace viewing
