#include "text/particles.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "text/words.h"

namespace viewing {
namespace {

struct Particle {
    std::string_view marker, after_consonant, after_vowel;
};
constexpr std::array particles{Particle{"[은/는]", "은", "는"}, Particle{"[이/가]", "이", "가"},
                               Particle{"[을/를]", "을", "를"}, Particle{"[과/와]", "과", "와"},
                               Particle{"[으로/로]", "으로", "로"}};

/// Units that are read aloud as words of their own, recognized at the end of a text; longest first.
struct Unit {
    std::string_view end;
    LastSound sound;
};
constexpr std::array units{Unit{"ms", LastSound::vowel}, Unit{"µs", LastSound::vowel}, Unit{"px", LastSound::l},
                           Unit{"MB", LastSound::vowel}, Unit{"%", LastSound::vowel},  Unit{"°", LastSound::vowel}};

bool is_latin(char byte) {
    return (byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z');
}

LastSound sound_of_digit(char digit) {
    constexpr std::string_view consonants = "036", ls = "178";  // 영 삼 육; 일 칠 팔
    if (consonants.find(digit) != std::string_view::npos) return LastSound::consonant;
    return ls.find(digit) != std::string_view::npos ? LastSound::l : LastSound::vowel;
}

/// Returns the last sound of the letter's Korean name (엘, 엠, 엔, 알) if the letter is alone, otherwise the last sound
/// of a word that ends in the letter.
LastSound sound_of_latin(char letter, bool is_alone) {
    const char small = static_cast<char>(letter | 0x20);
    if (small == 'l' || (is_alone && small == 'r')) return LastSound::l;
    return small == 'm' || small == 'n' ? LastSound::consonant : LastSound::vowel;
}

/// Returns the last character of a UTF-8 text as a code point.
std::uint32_t last_character(std::string_view text) {
    std::size_t begin = text.size() - 1;
    while (begin > 0 && continues_character(text[begin])) --begin;
    const auto first = static_cast<unsigned char>(text[begin]);
    std::uint32_t code = text.size() - begin == 1 ? first : first & (0x7FU >> (text.size() - begin));
    for (std::size_t i = begin + 1; i < text.size(); ++i)
        code = code << 6U | (static_cast<unsigned char>(text[i]) & 0x3FU);
    return code;
}

/// Returns the part that is read aloud last, without quotes and brackets at its end, and without a gloss: "평면" for
/// "평면(plane)".
std::string_view read_aloud(std::string_view text) {
    constexpr std::array<std::string_view, 7> marks{"]", "}", "\"", "'", "’", "”", " "};
    for (bool found = true; found;) {
        found = false;
        for (const std::string_view mark : marks)
            if (text.ends_with(mark)) {
                text.remove_suffix(mark.size());
                found = true;
            }
        if (!text.ends_with(')')) continue;
        const std::size_t open = text.rfind('(');
        const bool is_gloss = open != std::string_view::npos && open > 0 && text[open - 1] != ' ';
        text = is_gloss ? text.substr(0, open) : text.substr(0, text.size() - 1);
        found = true;
    }
    return text;
}

}  // namespace

LastSound last_sound(std::string_view text) {
    text = read_aloud(text);
    if (text.empty()) return LastSound::vowel;
    for (const Unit& unit : units) {
        const bool follows_a_letter =
            text.size() > unit.end.size() && is_latin(text[text.size() - unit.end.size() - 1]);
        if (text.ends_with(unit.end) && !follows_a_letter) return unit.sound;
    }
    const char last = text.back();
    if (is_digit(last)) return sound_of_digit(last);
    if (is_latin(last)) return sound_of_latin(last, text.size() < 2 || !is_latin(text[text.size() - 2]));
    constexpr std::uint32_t first_syllable = 0xAC00, last_syllable = 0xD7A3, finals = 28, final_l = 8;
    const std::uint32_t code = last_character(text);
    if (code < first_syllable || code > last_syllable) return LastSound::vowel;
    const std::uint32_t final_letter = (code - first_syllable) % finals;
    return final_letter == 0 ? LastSound::vowel : final_letter == final_l ? LastSound::l : LastSound::consonant;
}

std::string with_particles(std::string text) {
    for (std::size_t at = 0; (at = text.find('[', at)) != std::string::npos; ++at)
        for (const Particle& particle : particles) {
            if (!std::string_view(text).substr(at).starts_with(particle.marker)) continue;
            const LastSound before = last_sound(std::string_view(text).substr(0, at));
            // Korean uses 으로 after a consonant, but 로 after ㄹ.
            const bool is_short =
                before == LastSound::vowel || (before == LastSound::l && particle.after_vowel == "로");
            text.replace(at, particle.marker.size(), is_short ? particle.after_vowel : particle.after_consonant);
        }
    return text;
}

}  // namespace viewing
