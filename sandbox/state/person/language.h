// The language of the window. The window's own texts come from assets/text/CODE.po, and those of lessons from the
// lesson files. CONTRIBUTING.md says what a new language needs.
#pragma once

#include <iterator>
#include <string_view>

#include "state/fields.h"
#include "text/result.h"

namespace viewing {

/// The languages' own names, in the order of Language.
inline constexpr const char* language_names[] = {"English", "한국어"};
inline constexpr std::size_t language_count = std::size(language_names);

/// Sets the language of all texts looked up from now on. If its file cannot be read, the texts are English, and the
/// returned error says why in one sentence; a text without a translation appears in English.
Status speak(Language language);

/// Returns the most recently set language; initially English.
Language spoken_language();

/// Returns the environment's language for messages, from the first of LC_ALL, LC_MESSAGES and LANG that is set; English
/// if the program does not have that language.
Language system_language();

}  // namespace viewing
