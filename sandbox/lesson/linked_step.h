// A step of a lesson as a link: #lesson=ID&step=N (state/file/link.h). Only the program's own lessons can be named: a
// link opens no files.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lesson/lesson.h"
#include "state/file/link.h"

namespace viewing {

struct LinkedStep {
    Lesson lesson;
    std::size_t step = 0;  ///< from 0 on
};

/// None where the text is anything else than a lesson's link.
std::optional<Link> lesson_link(std::string_view text);

/// Reads the lesson that such a link names. The error is one sentence: there is none of that name, or no such step.
Result<LinkedStep> load_linked_step(const Link& link);

/// What to put behind an address; `step` counts from 0 on. None where the lesson is not one of the program's.
std::optional<std::string> link_to(const Lesson& lesson, std::size_t step);

}  // namespace viewing
