#include "ui/window/syllables.h"

#include <stb/stb_truetype.h>

#include <algorithm>
#include <iterator>

#include "text/words.h"

namespace viewing {
namespace {

/// Jamo, punctuation, compatibility jamo, syllables, full-width signs.
constexpr ImWchar blocks[][2] = {
    {0x1100, 0x11FF}, {0x3000, 0x303F}, {0x3131, 0x318E}, {0xAC00, 0xD7A3}, {0xFF01, 0xFF5E}};

}  // namespace

void Syllables::want(ImWchar character) {
    const bool is_ours = std::any_of(std::begin(blocks), std::end(blocks), [character](const ImWchar(&block)[2]) {
        return character >= block[0] && character <= block[1];
    });
    if (is_ours) characters_.insert(character);
}

void Syllables::want(std::string_view text) {
    // All these characters have three bytes: 1110xxxx 10xxxxxx 10xxxxxx.
    for (std::size_t i = 0; i + 2 < text.size(); ++i) {
        if ((text[i] & 0xF0) != 0xE0 || !continues_character(text[i + 1]) || !continues_character(text[i + 2]))
            continue;
        want(static_cast<ImWchar>((text[i] & 0x0F) << 12 | (text[i + 1] & 0x3F) << 6 | (text[i + 2] & 0x3F)));
        i += 2;
    }
}

const ImWchar* Syllables::ranges(std::span<const std::byte> font_file) {
    ranges_.clear();
    in_ranges_ = characters_.size();
    stbtt_fontinfo font;
    if (characters_.empty() || font_file.empty() ||
        !stbtt_InitFont(&font, reinterpret_cast<const unsigned char*>(font_file.data()), 0))
        return nullptr;
    for (const ImWchar character : characters_) {
        const int glyph = stbtt_FindGlyphIndex(&font, character);
        if (glyph == 0 || stbtt_IsGlyphEmpty(&font, glyph)) continue;
        const bool goes_on = !ranges_.empty() && ranges_.back() + 1 == character;
        if (!goes_on) ranges_.insert(ranges_.end(), {character, character});
        ranges_.back() = character;
    }
    if (ranges_.empty()) return nullptr;
    ranges_.push_back(0);
    return ranges_.data();
}

}  // namespace viewing
