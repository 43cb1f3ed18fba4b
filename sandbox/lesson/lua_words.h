// Internal to lesson/: the words of Lua source, found by Lua's own tokens, so that no comment and no long text hides
// one. Source: Lua 5.4 Reference Manual, §3.1.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace viewing {

/// The words that stand outside of texts and comments and are no members (behind a point), in order: names, and Lua's
/// own words. Of source that Lua has read without an error; in other source what follows the error may be missing.
std::vector<std::string> words_of_source(std::string_view source);

/// Whether it is one of the words that Lua keeps for itself, which no name can be: "and", "function".
bool is_word_of_lua(std::string_view word);

/// Whether it is one of those that a single value may be made of: and, false, nil, not, or, true.
bool is_word_of_values(std::string_view word);

/// A letter or _, then letters, digits and _.
bool has_form_of_name(std::string_view word);

}  // namespace viewing
