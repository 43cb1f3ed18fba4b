// A lesson's own tests: checks the lesson's claims, model answers and listed wrong answers against the program.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "grading/measurer.h"
#include "lesson/lesson.h"

namespace viewing {

/// The problems of a step; each sentence names the lesson, the step and the values.
using LessonFindings = std::vector<std::string>;

/// Returns the findings; empty if there are none. The claims before and after the answer must hold. The model answer
/// must be right, and a goal must not be reached at the start. Each listed wrong answer must be recognized and
/// distinguished from the others, and every tag must be one of the lesson's. A goal's model may change only what the
/// step allows to be changed.
LessonFindings check_step(const Lesson& lesson, const LessonStep& step, const Measurer& measurer);

}  // namespace viewing
