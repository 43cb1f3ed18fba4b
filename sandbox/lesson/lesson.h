// A guided lesson, as its file describes it, or a lecture made of lessons, steps and presets. Each step asks a question
// before it shows the answer. Each step's state is complete, so a step can be revisited, reached directly and tested
// alone. See lesson_reader.cpp for the file, judge.h for answers, and lesson_run.h for the progress through a lesson.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "state/closed_set.h"
#include "state/person/language.h"
#include "state/presets.h"
#include "text/per_enum.h"

namespace viewing {

/// A text in English and in the file's other languages.
struct LessonText {
    PerEnum<Language, std::string, language_count> by_language;
    bool empty() const { return in_english().empty(); }
    const std::string& in_english() const { return by_language.front(); }
    /// Returns the text in that language; English if the file lacks it.
    const std::string& in(Language language) const {
        const std::string& text = by_language[language];
        return text.empty() ? in_english() : text;
    }
    /// Returns the text in the current language.
    const std::string& shown() const { return in(spoken_language()); }
    bool operator==(const LessonText&) const = default;
};

/// The kinds of questions by their names in files. question_kind.h declares an entry for each, which says how it is
/// read, judged and described; ui/lesson/answer_input.h declares another, which says how it is drawn.
#define VIEWING_QUESTION_KINDS(KIND) \
    KIND(choice) KIND(number) KIND(vector) KIND(matrix) KIND(sequence) KIND(order) KIND(product) KIND(subset) KIND(goal)
enum class AskKind { VIEWING_QUESTION_KINDS(VIEWING_ENUMERATOR) };

/// One of the answers that a choice offers.
struct LessonChoice {
    LessonText say;
    bool right = false;
    LessonText why;   ///< explains why it is wrong
    std::string tag;  ///< the misconception that it shows
};

/// An answer: numbers row by row, or indices (from 0) into the list of choices or items.
struct Answer {
    std::vector<double> numbers = {};
    std::vector<int> items = {};
    bool empty() const { return numbers.empty() && items.empty(); }
    bool operator==(const Answer&) const = default;
};

/// A common wrong answer.
struct WrongAnswer {
    std::string when;  ///< an expression that recognizes it; "" to compare the answer with `sample`
    LessonText say;
    std::string tag;
    Answer sample;                      ///< an example that must be recognized
    std::vector<std::string> settings;  ///< for a goal: a change that must be recognized
    int points = 0;                     ///< in an exercise: points that it still earns
};

/// A number that shows the progress toward a goal.
struct GoalNumber {
    LessonText name;    ///< "V p"
    std::string value;  ///< an expression for a number or a vector
    LessonText needed;  ///< "(0, 0, −5)"
};

struct Ask {
    AskKind kind = AskKind::choice;
    LessonText question;
    std::vector<LessonText> hints;
    std::vector<LessonChoice> choices;
    std::vector<LessonText> items;                 ///< for sequence, order, product and subset
    int rows = 1, columns = 1;                     ///< of the entered answer
    std::string expect;                            ///< an expression for the right answer
    std::vector<std::vector<int>> expected_items;  ///< one or more equally right lists of item indices, from 0
    double tolerance = 0.0;                        ///< absolute, for each entry
    double relative_tolerance = 0.0;               ///< a fraction of the largest entry; 0: none
    bool up_to_factor = false;
    std::vector<std::string> factors;  ///< for product and sequence: an expression for each item's 4×4 matrix
    std::string shows_as;              ///< the field that shows the effect of the answer's matrix, or C or V; "": none
    std::string until;                 ///< for a goal: an expression that is true when it is reached
    std::vector<GoalNumber> progress;  ///< of a goal
    std::vector<std::string> allow;    ///< the fields or groups that may change; empty: all
    std::vector<std::string> model;    ///< settings that reach the goal
    std::vector<WrongAnswer> wrong;
    std::string constants;  ///< the step's own names for its expressions: a JSON object, or ""
};

struct Reveal {
    LessonText say;
    std::vector<std::string> settings;  ///< the changes
    double over_s = 0.0;                ///< the time that numbers take to change; the rest changes immediately
    std::vector<std::string> highlight;
};

/// A point in world space that is marked in the pictures.
struct LessonTarget {
    glm::dvec3 point_world{0.0};
    LessonText label;
};

struct LessonStep {
    std::string id;
    std::vector<int> slides;  ///< the slides that this step is about; by default, the lesson's
    LoadedState start;        ///< before the answer, including the layout
    Params revealed;          ///< after the answer: with a goal's model and the reveal's changes
    bool names_lower_left = false, names_lower_right = false;  ///< false: not in the layout, so the stage hides it
    bool keeps_lens = false;  ///< the step is about what its lens shows, so a narrow stage does not widen it
    std::optional<LessonTarget> target;
    LessonText say;
    std::vector<std::string> cover, highlight;
    Ask ask;
    Reveal reveal;
    std::vector<std::string> claims_before, claims;
    LessonText note;
    /// Whether the step asks nothing, like a preset in a lecture: a sentence replaces the question.
    bool only_shows() const { return ask.kind == AskKind::choice && ask.choices.empty(); }
};

/// What the card at the end of a lesson says.
struct LessonEnd {
    std::vector<LessonText> says;  ///< what was seen, in three sentences; empty: there is no card
    std::string exercise;          ///< the id of the matching exercise; "": none
};

/// The parts of a lecture: each is a lesson, some of its steps, or a preset.
struct Lecture {
    struct Part {
        LessonText title;
        std::string lesson;  ///< "" for a preset
        int minutes = 0;
        std::size_t first = 0, count = 0;  ///< the range of its steps in the lecture
        LessonEnd end;
    };
    std::vector<Part> parts;
    /// Returns the index of the part that a step belongs to.
    std::size_t part_of(std::size_t step) const;
};

/// One student's exercises, if the steps are exercises; one entry per step.
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
    std::vector<std::string> needs;                        ///< lessons to do first
    std::vector<std::pair<std::string, LessonText>> tags;  ///< misconceptions by their short names
    std::vector<LessonStep> steps;                         ///< at least one
    std::optional<LoadedState> picture;                    ///< shown on the lesson's card instead of the first step
    std::filesystem::path file;
    std::optional<Sheet> sheet = {};
    LessonEnd end = {};
    std::optional<Lecture> lecture = {};  ///< if set, `steps` has the steps of all its parts in order
};

/// The data that a list shows for a lesson.
struct LessonFile {
    std::string id;
    LessonText title;
    std::vector<int> slides;
    int minutes = 0;
    int steps = 0;
    std::filesystem::path path;
    std::string group = {};  ///< the topic under which lists show it, as for presets; "" for none
    struct Step {
        LessonText question;      ///< empty if it cannot be read
        std::vector<int> slides;  ///< its own, or the lesson's
    };
    std::vector<Step> listed_steps = {};
    std::vector<std::string> needs = {};  ///< ids of the lessons to do first
};

/// Returns the lessons of the assets directory in the order of the lecture: by file name, which begins with a number. A
/// lesson that cannot be read is listed by its file name; loading it reports why.
std::vector<LessonFile> lessons();
/// Returns the lectures of the assets directory, by file name.
std::vector<LessonFile> lectures();

/// Loads the lesson or the lecture with that id, or the file at that path. The error is one sentence that names the
/// file, the step and the field.
Result<Lesson> load_lesson(const std::string& argument);

/// Returns a sentence for each mistake in a lecture's file; the error says why it cannot be read at all.
Result<std::vector<std::string>> lecture_mistakes(const std::string& argument);

/// Return the JSON Schemas of lesson files and lecture files.
std::string lesson_schema();
std::string lecture_schema();

/// Reads a lesson or a lecture from a string. `source` ("mine.json") starts every message; file names in its scenes are
/// relative to `folder`.
Result<Lesson> parse_lesson(std::string_view json, const std::string& source, const std::filesystem::path& folder);

/// Returns all mistakes in the text of a lesson or a lecture, each as parse_lesson() would report it; empty if the text
/// can be read. Omits mistakes that only follow from others.
std::vector<std::string> lesson_mistakes(std::string_view json, const std::string& source,
                                         const std::filesystem::path& folder);

}  // namespace viewing
