// A step of a lesson as a link: #lesson=ID&step=N (state/file/link.h). Links can name only the program's own lessons: a
// link never opens a file.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lesson/lesson.h"
#include "state/file/link.h"

namespace viewing {

struct LinkedStep {
    Lesson lesson;
    std::size_t step = 0;  ///< from 0
};

/// Returns the link if the text is a link to a lesson; otherwise none.
std::optional<Link> lesson_link(std::string_view text);

/// Loads the lesson that such a link names. The error says in one sentence that there is no such lesson or no such
/// step.
Result<LinkedStep> load_linked_step(const Link& link);

/// Returns the text to append to an address; `step` counts from 0. Returns none if the lesson is not one of the
/// program's.
std::optional<std::string> link_to(const Lesson& lesson, std::size_t step);

}  // namespace viewing
