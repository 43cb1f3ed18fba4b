// What the lecturer reads while the room sees the step: its note, the right answer, what comes next, the time.
#pragma once

#include <string>

#include "lesson/judge.h"
#include "lesson/run.h"

namespace viewing {

/// The right answer in words: "B: the farthest", "−10", "1 3 2", of a goal the settings that reach it. What cannot be
/// computed stands as its expression.
std::string answer_in_words(const Ask& ask, const Surroundings& surroundings);

/// Where a step is: what the second line of the notes says.
enum class StepPhase { asks, shows, answered };

/// A page of plain text, lines up to 78 characters, ended by a newline. `presented_s`: since the lesson began.
std::string notes_page(const LessonRun& run, StepPhase phase, const Surroundings& surroundings, double presented_s);

}  // namespace viewing
