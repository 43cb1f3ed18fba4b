// Internal to lesson/: the forms of values that lesson, lecture and exercise files have in common.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "lesson/lesson.h"
#include "state/file/form.h"

namespace viewing {

bool has(const Json& object, const char* key);

std::vector<std::string> keys_of(const Json& object);

/// A string, or {"en": …, "ko": …}. If `is_needed`, the English text must not be empty.
form::Form<LessonText> text_form(bool is_needed);

form::Form<std::vector<std::string>> names_form();

/// Misconceptions: texts by their short names.
form::Form<std::vector<std::pair<std::string, LessonText>>> tags_form();

/// A number, or a list of numbers and lists of at most `most` items, row by row. The schema defines it under `name`.
form::Form<std::vector<double>> numbers_form(const char* name, const Range& range, std::size_t most);

inline constexpr std::size_t most_entries = 64;  ///< the maximum number of entries in a list
inline constexpr int most_steps = 200;           ///< of a lesson

}  // namespace viewing
