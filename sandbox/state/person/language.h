// Which language the window speaks: its texts from assets/text/CODE.po, lessons' texts from their files. A further one
// is an enumerator of Language with its name in fields.cpp, its own name below, and that file; where its script is not
// Latin, a font in ui/window/fonts.cpp.
#pragma once

#include <string_view>

#include "state/fields.h"
#include "text/result.h"

namespace viewing {

inline constexpr std::size_t language_count = 2;

/// As its speakers call it.
constexpr const char* own_name(Language language) {
    return language == Language::ko ? "한국어" : "English";
}

/// Everything that is looked up from now on is in this language. Where its file cannot be read, the error
/// is one sentence, and English is spoken; a text without a translation is English.
Status speak(Language language);

/// What was spoken last; English at first.
Language spoken_language();

/// The language of messages that the environment asks for (LC_ALL, LC_MESSAGES, LANG, the first that is set); English
/// where it is none of ours.
Language system_language();

}  // namespace viewing
