// The entries that the search (Ctrl+P) offers in the current state, and those that match the typed words. Pure
// functions. search_box.h draws the result, and search_choices.cpp carries out the choice.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "lesson/lesson.h"
#include "state/fields.h"
#include "state/presets.h"
#include "ui/window/window_commands.h"

namespace viewing {

/// Entries that match equally well are sorted in this order.
enum class EntryKind { command, field, trouble, preset, view, lesson, step, exercise };
const char* name_of_kind(EntryKind kind);

struct PresetChoice {
    std::string name;
};
struct LessonPlace {
    std::string id, file;
    std::optional<std::size_t> step;  ///< none: where the user left the lesson
};
struct ExerciseChoice {
    std::string id;
};
/// A field. `setting` is "path=value", as on the command line, or "" if the value is still to be typed after `path`.
struct FieldChoice {
    std::string_view path;
    std::string setting;
    bool is_beside = false;  ///< applies only to the second picture
};
using SearchChoice = std::variant<PresetChoice, LessonPlace, ExerciseChoice, FieldChoice, Topic, const WindowCommand*>;

struct SearchEntry {
    EntryKind kind;
    std::string title;  ///< in the current language
    std::string note;   ///< at the right: a key, a value, a heading
    SearchChoice choice;
    std::string names;             ///< found first: the title and other names, in both languages, in lower case
    std::string about;             ///< found next: descriptions
    std::vector<int> slides = {};  ///< the lecture slides that it is for
};

struct ExerciseTitle {
    std::string id;
    LessonText title;
};

/// The lists that the search covers, as read from the assets.
struct SearchLists {
    std::span<const NamedFile> presets;
    std::span<const LessonFile> lessons;
    std::span<const ExerciseTitle> exercises;
};

/// Limits on what the search may find: never more than the window's own controls would allow.
struct SearchLimits {
    Place place = Place::window;
    bool may_choose_view = true;                      ///< otherwise the lower views are those of the step
    std::optional<std::vector<std::string>> movable;  ///< the fields and groups that may change; nullopt: all
    std::vector<std::string> covered;                 ///< parts that are hidden until answered (lesson/target_names.h)
};

std::vector<SearchEntry> search_entries(const SearchLists& lists, const SearchLimits& limits, const Params& params);

/// Returns the entries that contain every word of `query`, best match first: matches in names before matches in
/// descriptions, matches at the start of a word before matches inside one, short titles before long ones. A field also
/// matches if a value follows its name ("near 0.0001"); its choice is then that setting or, after "beside", that
/// setting for the second picture ("beside near 0.0001"). If no entry contains every word, returns the entries that
/// contain the most words, provided that they contain at least half of them. A slide number ("s12", "slide 12") finds
/// the entries for that slide: presets, then lessons and their steps.
std::vector<SearchEntry> found(std::span<const SearchEntry> entries, std::string_view query, std::size_t most = 12);

/// Whether a text in lower case contains every word of `query`.
bool contains_words(std::string_view text, std::string_view query);

}  // namespace viewing
