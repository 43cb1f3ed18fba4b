// A guided lesson as its file has it: steps that each ask before they show. A step's state is complete by itself, so it
// can be gone back to, skipped to and tested alone. Read reader.cpp for the file, judge.h for answers, run.h for the
// way through.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "state/person/language.h"
#include "state/presets.h"

namespace viewing {

/// English, and the other languages that the file has.
struct LessonText {
    std::array<std::string, language_count> by_language;
    bool empty() const { return in_english().empty(); }
    const std::string& in_english() const { return by_language.front(); }
    /// English where the file has none in that language.
    const std::string& in(Language language) const {
        const std::string& text = by_language[static_cast<std::size_t>(language)];
        return text.empty() ? in_english() : text;
    }
    /// In the language that is spoken now.
    const std::string& shown() const { return in(spoken_language()); }
    bool operator==(const LessonText&) const = default;
};

enum class AskKind { choice, number, vector, matrix, sequence, order, product, subset, goal };

/// Whether numbers are typed.
constexpr bool is_typed(AskKind kind) {
    return kind == AskKind::number || kind == AskKind::vector || kind == AskKind::matrix;
}

/// Whether items are chosen, or put in order.
constexpr bool has_items(AskKind kind) {
    return kind == AskKind::sequence || kind == AskKind::order || kind == AskKind::product || kind == AskKind::subset;
}

/// One of the answers that a choice offers.
struct LessonChoice {
    LessonText say;
    bool right = false;
    LessonText why;   ///< it is wrong
    std::string tag;  ///< the misconception that it shows
};

/// What somebody answered: numbers row by row, or the places of choices or items in their lists, from 0 on.
struct Answer {
    std::vector<double> numbers;
    std::vector<int> items;
    bool empty() const { return numbers.empty() && items.empty(); }
    bool operator==(const Answer&) const = default;
};

/// An answer that people are known to give wrongly.
struct WrongAnswer {
    std::string when;  ///< an expression that recognises it; "" where the answer is compared with `sample`
    LessonText say;
    std::string tag;
    Answer sample;                      ///< one that must be recognised
    std::vector<std::string> settings;  ///< of a goal: a change that must be
    int points = 0;                     ///< of an exercise: what it is worth all the same
};

struct Ask {
    AskKind kind = AskKind::choice;
    LessonText question;
    std::vector<LessonText> hints;
    std::vector<LessonChoice> choices;
    std::vector<LessonText> items;                 ///< of sequence, order, product and subset
    int rows = 1, columns = 1;                     ///< of what is typed
    std::string expect;                            ///< an expression: what is to be typed
    std::vector<std::vector<int>> expected_items;  ///< one or more right lists of items, from 0 on
    double tolerance = 0.0;                        ///< absolute, of each entry
    double relative_tolerance = 0.0;               ///< of the largest entry, where it is not 0
    bool up_to_factor = false;
    std::string shows_as;            ///< the field that shows what a typed matrix does; "": none
    std::string until;               ///< of a goal
    std::vector<std::string> allow;  ///< what may be changed: fields or groups; empty: all
    std::vector<std::string> model;  ///< settings that reach the goal
    std::vector<WrongAnswer> wrong;
    std::string constants;  ///< names of the step's own for its expressions: a JSON object, or ""
};

struct Reveal {
    LessonText say;
    std::vector<std::string> settings;  ///< what changes
    double over_s = 0.0;                ///< how long numbers take to; the others change at once
    std::vector<std::string> highlight;
};

/// A point of the world that is marked in the pictures.
struct LessonTarget {
    glm::dvec3 point_world{0.0};
    LessonText label;
};

struct LessonStep {
    std::string id;
    LoadedState start;  ///< before the answer, layout included
    Params revealed;    ///< after it: with a goal's model, and what the reveal changes
    std::optional<LessonTarget> target;
    LessonText say;
    std::vector<std::string> cover, highlight;
    Ask ask;
    Reveal reveal;
    std::vector<std::string> claims_before, claims;
    LessonText note;
};

/// The exercises of one student, where the steps are such: an entry for each.
struct Sheet {
    std::string course, student;
    struct Item {
        std::string exercise;
        LessonText title;
        std::size_t variant = 0;
        int points = 1;
    };
    std::vector<Item> items;
};

struct Lesson {
    std::string id;
    LessonText title;
    std::vector<int> slides;
    int minutes = 0;
    std::vector<std::string> needs;                        ///< lessons that come before
    std::vector<std::pair<std::string, LessonText>> tags;  ///< misconceptions by their short names
    std::vector<LessonStep> steps;                         ///< at least one
    std::optional<LoadedState> picture;                    ///< on its card, in place of the first step
    std::filesystem::path file;
    std::optional<Sheet> sheet = {};
};

/// A lesson as far as a list shows it.
struct LessonFile {
    std::string id;
    LessonText title;
    std::vector<int> slides;
    int minutes = 0;
    int steps = 0;
    std::filesystem::path path;
};

/// The lessons of the assets directory in the order of the lecture: by their file names, which begin with a number. One
/// that cannot be read stands there by its file name; loading it says why.
std::vector<LessonFile> lessons();

/// The lesson of that id, or the file at that path. The error is one sentence with file, step and field.
Result<Lesson> load_lesson(const std::string& argument);

/// The same of a text; `source` opens every message ("mine.json"), `folder` is what its scenes' files are relative to.
Result<Lesson> parse_lesson(std::string_view json, const std::string& source, const std::filesystem::path& folder);

}  // namespace viewing
