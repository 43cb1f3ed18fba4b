// A lesson for printing: one HTML file with a page and a picture for each step.
#pragma once

#include <string>

#include "cli/headless.h"
#include "lesson/lesson.h"

namespace viewing {

/// Returns the page. `with_answers` adds the right answer and the reveal below each question. Throws Failure if GL
/// fails.
std::string handout(Headless& headless, const Lesson& lesson, bool with_answers);

/// Draws the pictures on `device`, and writes the page to the file `output`, or to standard output for "-".
void write_handout(const Lesson& lesson, const std::string& output, bool with_answers, const std::string& device,
                   Language language);

}  // namespace viewing
