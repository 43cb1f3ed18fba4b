// Internal to lesson/: reads the common parts of lesson and exercise files from JSON trees. On an error, every function
// here that reads throws a Refusal with the whole message.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "lesson/lesson.h"
#include "state/file/form.h"

namespace viewing {

bool has(const Json& object, const char* key);

std::vector<std::string> keys_of(const Json& object);

/// Reads a string, or {"en": …, "ko": …}.
LessonText read_text_of(const Json& value, const Where& where);
LessonText text_at(const Json& object, const char* key, const Where& where, bool is_needed);

/// Read a name, which must exist, or a list of names, which is empty if the key is missing.
std::string name_at(const Json& object, const char* key, const Where& where);
std::vector<std::string> names_at(const Json& object, const char* key, const Where& where);

/// A text in one language or in several; one that is needed has English words.
form::Form<LessonText> text_form(bool is_needed);
form::Form<std::vector<std::string>> names_form();

std::vector<std::pair<std::string, LessonText>> read_tags(const Json& object, const Where& where);

inline constexpr std::size_t most_entries = 64;  ///< the maximum number of entries in a list
inline constexpr int most_steps = 200;           ///< of a lesson

}  // namespace viewing
