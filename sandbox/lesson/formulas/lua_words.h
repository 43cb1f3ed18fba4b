// Internal to lesson/: finds the words of Lua source by splitting it into tokens as Lua does, so that no comment or
// long string hides a word. Source: Lua 5.4 Reference Manual, §3.1.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace viewing {

/// Returns the words outside strings and comments, in order: names and Lua's keywords, but not members (after a dot).
/// If Lua would refuse the source, words after the error may be missing.
std::vector<std::string> words_of_source(std::string_view source);

/// Whether a word is a keyword of Lua, which no name can be: "and", "function".
bool is_word_of_lua(std::string_view word);

/// Whether a word is a keyword that may occur in an expression for a single value: and, false, nil, not, or, true.
bool is_word_of_values(std::string_view word);

/// Whether a word consists of a letter or _, followed by letters, digits and _.
bool has_form_of_name(std::string_view word);

}  // namespace viewing
