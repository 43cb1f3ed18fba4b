// The language of the window. The window's own texts come from assets/text/CODE.po, and those of lessons from the
// lesson files. A new language needs an enumerator of Language, its code in fields.cpp, its name in own_name() and a
// higher language_count below, and a .po file; if its script is not Latin, it also needs a font in ui/window/fonts.cpp.
#pragma once

#include <string_view>

#include "state/fields.h"
#include "text/result.h"

namespace viewing {

inline constexpr std::size_t language_count = 2;

/// Returns the language's name in that language.
constexpr const char* own_name(Language language) {
    return language == Language::ko ? "한국어" : "English";
}

/// Sets the language of all texts looked up from now on. If its file cannot be read, the texts are English, and the
/// returned error says why in one sentence; a text without a translation appears in English.
Status speak(Language language);

/// Returns the most recently set language; initially English.
Language spoken_language();

/// Returns the environment's language for messages, from the first of LC_ALL, LC_MESSAGES and LANG that is set; English
/// if the program does not have that language.
Language system_language();

}  // namespace viewing
