// Chooses the Korean particle after a value that becomes known only when the sentence is filled in: "{light}[이/가]"
// becomes "광원 2가", "광원 3이".
#pragma once

#include <string>
#include <string_view>

namespace viewing {

/// How a word ends when it is read aloud.
enum class LastSound { vowel, l, consonant };

/// Returns the last sound of a text when it is read in Korean. Hangul ends in the sound of its final letter; digits,
/// units and single letters are read by their Korean names ("3" 삼, "%" 퍼센트, "R" 알); Latin words that end in m or n
/// count as ending in a consonant, and those that end in l count as ending in ㄹ. Skips brackets and quotes at the end.
/// Returns vowel for everything else and for an empty text.
LastSound last_sound(std::string_view text);

/// Replaces each "[은/는]", "[이/가]", "[을/를]", "[과/와]" and "[으로/로]" with the form that fits the text before it.
std::string with_particles(std::string text);

}  // namespace viewing
