// The page that the lecturer sees while the audience sees the step. It shows the step's note, the right answer, the
// next step, and the time.
#pragma once

#include <string>
#include <vector>

#include "lesson/lesson_run.h"
#include "lesson/questions/judge.h"

namespace viewing {

/// Returns the right answer in words: "B: the farthest", "−10", "1 → 3 → 2"; for a goal, the settings that reach it. An
/// answer that cannot be computed appears as its expression.
std::string answer_in_words(const Ask& ask, const Surroundings& surroundings);

/// The phase of a step; the second line of the notes shows it.
enum class StepPhase { asks, shows, answered, ended };

/// The lecturer's page in the current language.
struct Notes {
    std::string title;
    /// "3 / 8 · asking · 12 of 15 min, 3 left"; in a lecture, "part 2 / 9, 8 min · …, 2 behind"
    std::string place;
    struct Part {
        std::string label, text;
    };
    std::vector<Part> parts;  ///< say, ask, answer, reveal, note, and what comes next
    bool is_late = false;     ///< more than two minutes behind, assuming steps of equal length in a part
};

/// Returns the page for the current step. `presented_s` counts from the start of the lesson.
Notes notes_of(const LessonRun& run, StepPhase phase, const Surroundings& surroundings, double presented_s);

/// Returns the notes as plain text, in lines of up to 78 characters, with a newline at the end.
std::string notes_page(const Notes& notes);

}  // namespace viewing
