// A lesson's own tests: its claims, its model answers, and the wrong ones that it lists, against the program.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lesson/lesson.h"
#include "render/renderer.h"

namespace viewing {

/// What is wrong with a step, in one sentence that names lesson, step and the values.
using LessonFindings = std::vector<std::string>;

/// Empty where all is well: claims hold before and after, the model answer is right and nothing is right before it,
/// each wrong one that is listed is recognised and told apart from the others, every tag is one of the lesson's, and a
/// goal's model changes nothing that may not be changed.
LessonFindings check_step(const Lesson& lesson, const LessonStep& step, Renderer& renderer);

}  // namespace viewing
