// A lesson on paper: a page for each step with its picture, as one HTML file that any browser prints.
#pragma once

#include <string>

#include "cli/headless.h"
#include "lesson/lesson.h"

namespace viewing {

/// `with_answers`: the right answer and what is shown then, below each question. Throws Failure where GL does not draw.
std::string handout(Headless& headless, const Lesson& lesson, bool with_answers);

}  // namespace viewing
