// Internal to lesson/: the parts of lesson and exercise files that both have, from JSON trees. Everything here throws
// Refusal with the whole message.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "lesson/lesson.h"
#include "state/file/reader.h"

namespace viewing {

bool has(const Json& object, const char* key);

std::vector<std::string> keys_of(const Json& object);

/// A text, or {"en": …, "ko": …}.
LessonText read_text_of(const Json& value, const Where& where);
LessonText text_at(const Json& object, const char* key, const Where& where, bool is_needed);

/// What stands there by name; nothing where the key is missing.
std::string name_at(const Json& object, const char* key, const Where& where);
std::vector<std::string> names_at(const Json& object, const char* key, const Where& where);

std::vector<int> read_slides(const Json& object, const Where& where);
std::vector<std::pair<std::string, LessonText>> read_tags(const Json& object, const Where& where);

inline constexpr std::size_t most_entries = 64;  ///< of a list in such a file

}  // namespace viewing
