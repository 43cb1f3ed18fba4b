// What the lecturer reads while the room sees the step: its note, the right answer, what comes next, the time.
#pragma once

#include <string>
#include <vector>

#include "lesson/judge.h"
#include "lesson/run.h"

namespace viewing {

/// The right answer in words: "B: the farthest", "−10", "1 3 2", of a goal the settings that reach it. What cannot be
/// computed stands as its expression.
std::string answer_in_words(const Ask& ask, const Surroundings& surroundings);

/// Where a step is: what the second line of the notes says.
enum class StepPhase { asks, shows, answered };

/// The page in the language that is spoken now.
struct Notes {
    std::string title;
    std::string place;  ///< "3 / 8 · asks · 12 min of 15, 3 min left"
    struct Part {
        std::string label, text;
    };
    std::vector<Part> parts;  ///< what is said, asked, right, shown, to be thought of, and what comes next
    bool is_late = false;     ///< by more than two minutes for the steps that are left
};

/// `presented_s`: since the lesson began.
Notes notes_of(const LessonRun& run, StepPhase phase, const Surroundings& surroundings, double presented_s);

/// As plain text, lines up to 78 characters, ended by a newline.
std::string notes_page(const Notes& notes);

}  // namespace viewing
