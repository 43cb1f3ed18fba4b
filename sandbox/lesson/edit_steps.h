// Edits the text of a custom lesson: replaces parts that its author types in the window, and moves, duplicates or
// removes steps or changes their state. Every edit returns the whole new text of the file, which has been checked by
// reading it as a lesson, or one sentence that begins with the source's name. File names in the lesson's scenes are
// relative to the source's folder.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "lesson/lesson.h"

namespace viewing {

/// The file of a lesson before an edit.
struct LessonSource {
    std::string text;
    std::string name;              ///< begins every message: "mine.json"
    std::filesystem::path folder;  ///< of the file
};

/// A part of a step that its author can type.
struct StepPart {
    enum class Kind {
        say,
        question,
        choice,
        why,
        right,
        answer,
        item,
        hint,
        wrong_when,
        wrong_say,
        reveal,
        note,
        other
    };
    Kind kind = Kind::other;
    std::size_t number = 0;  ///< of the choice, item, hint or wrong answer, from 0
    std::string place;       ///< within the step: "/ask/choices/0/say"
    std::string text;        ///< in the requested language; true or false for `right`; an answer as in the file
};

/// Returns the parts of a step in the order in which the screen shows them: its text, question, choices, answer, hints,
/// wrong answers, the sentence of the reveal, and the lecturer's note, whose text is empty if there is none. Returns no
/// parts if the source is not a lesson.
std::vector<StepPart> step_parts(const LessonSource& source, std::size_t step, Language language);

/// Replaces a part. Marking a choice as right unmarks the previous right choice, which gets the marked choice's "why".
/// If a plain string gets a text in another language, the string stays as the English text.
Result<std::string> with_part(const LessonSource& source, std::size_t step, const StepPart& part, Language language);

/// Moves a step; `to` is clamped to the list.
Result<std::string> with_moved_step(const LessonSource& source, std::size_t from, std::ptrdiff_t to);
/// Inserts a copy of a step after it, with a different id.
Result<std::string> with_doubled_step(const LessonSource& source, std::size_t step);
Result<std::string> with_removed_step(const LessonSource& source, std::size_t step);
/// Adds a choice to a question with choices, with texts for the author to replace.
Result<std::string> with_choice(const LessonSource& source, std::size_t step);
/// Uses a state and its layout as the start of a step; `preset` is the preset that the state is based on, "" for the
/// opening state.
Result<std::string> with_start(const LessonSource& source, std::size_t step, const Params& params,
                               const std::string& preset);
/// Makes `revealed` the state that the reveal shows: the reveal changes the fields that differ from `start`, except ui.
Result<std::string> with_revealed(const LessonSource& source, std::size_t step, const Params& start,
                                  const Params& revealed);

}  // namespace viewing
