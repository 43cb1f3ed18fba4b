// Formulas in one line, with subscripts and superscripts, real math signs, and letters in the colors of their roles.
#include <algorithm>

#include "text/words.h"
#include "widgets/inner.h"

namespace widgets {

namespace inner {

namespace {

bool IsLetter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// Returns the number of bytes of the UTF-8 character at `s`; 0 if the character is malformed.
int CharacterBytes(const char* s) {
    const auto lead = static_cast<unsigned char>(*s);
    const int bytes = lead < 0x80 ? 1 : (lead >> 5) == 0x6 ? 2 : (lead >> 4) == 0xE ? 3 : (lead >> 3) == 0x1E ? 4 : 0;
    for (int i = 1; i < bytes; ++i) {
        if (!viewing::continues_character(s[i])) return 0;  // also stops at the end of the string
    }
    return bytes;
}

enum class Level { line, lowered, raised };

/// Writes characters into a layout. Joins neighbors of the same level and color into one piece.
class Writer {
public:
    Writer(FormulaLayout& out, Face face) : out_(out), face_(face) {
        const ImFont& font = *face.font;
        ascent_ = font.FontSize > 0.0F ? font.Ascent / font.FontSize : 0.8F;
        has_minus_ = font.FindGlyphNoFallback(0x2212) != nullptr;
        has_dot_ = font.FindGlyphNoFallback(0xB7) != nullptr;
        has_script_l_ = font.FindGlyphNoFallback(0x2113) != nullptr;
        out_.size.y = face.size;
    }

    void Put(const char* character, int count, Level level, ImU32 color) {
        std::string_view shown(character, static_cast<std::size_t>(count));
        if (count == 0) shown = "?";
        if (shown == "-" && has_minus_) shown = "−";
        if (shown == "*") shown = has_dot_ ? "·" : "*";
        if (!open_ || level != level_ || color != color_) Open(level, color);
        if (!open_ || out_.bytes + std::ssize(shown) > FormulaLayout::max_bytes) return;
        std::copy(shown.begin(), shown.end(), out_.text + out_.bytes);
        out_.bytes += static_cast<int>(shown.size());
        out_.pieces[out_.piece_count - 1].end = static_cast<short>(out_.bytes);
    }

    bool HasScriptL() const { return has_script_l_; }

    /// Adds the thin space between two factors.
    void PutThinSpace() {
        Close();
        x_ += face_.size * 0.12F;
    }

    void Close() {
        if (!open_) return;
        const FormulaLayout::Piece& piece = out_.pieces[out_.piece_count - 1];
        const char* text = out_.text;
        x_ += face_.font->CalcTextSizeA(piece.size, 1e9F, 0.0F, text + piece.begin, text + piece.end).x;
        out_.size.x = x_;
        open_ = false;
    }

private:
    void Open(Level level, ImU32 color) {
        Close();
        if (out_.piece_count == FormulaLayout::max_pieces) return;
        constexpr float small = 0.78F, lowered_by = 0.20F, raised_by = 0.34F;  // in line heights
        FormulaLayout::Piece& piece = out_.pieces[out_.piece_count++];
        piece = {static_cast<short>(out_.bytes), static_cast<short>(out_.bytes), x_, 0.0F, face_.size, color};
        if (level != Level::line) {
            const float shift = level == Level::lowered ? lowered_by : -raised_by;
            piece.size = face_.size * small;
            piece.y = face_.size * (ascent_ * (1.0F - small) + shift);
            out_.size.y = std::max(out_.size.y, piece.y + piece.size);
        }
        level_ = level;
        color_ = color;
        open_ = true;
    }

    FormulaLayout& out_;
    Face face_;
    float ascent_ = 0.8F;
    float x_ = 0.0F;
    bool has_minus_ = false, has_dot_ = false, has_script_l_ = false;
    bool open_ = false;
    Level level_ = Level::line;
    ImU32 color_ = 0;
};

/// Returns the character at `s`, which has `bytes` bytes; 0 if it is malformed.
char32_t CharacterAt(const char* s, int bytes) {
    if (bytes == 1) return static_cast<unsigned char>(*s);
    char32_t character = static_cast<unsigned char>(*s) & (0x7FU >> bytes);
    for (int i = 1; i < bytes; ++i) character = (character << 6U) | (static_cast<unsigned char>(s[i]) & 0x3FU);
    return bytes == 0 ? 0 : character;
}

ImU32 ColorOf(char32_t letter, std::span<const LetterRole> roles, ImU32 base) {
    for (const LetterRole& entry : roles) {
        if (entry.letter == letter) return CurrentContext().palette.of(entry.role);
    }
    return base;
}

/// Returns whether the space at `s` separates two one-letter factors, as in "l_x n_y"; a space beside a sign or a word
/// does not.
bool IsThinSpace(const char* formula, const char* s) {
    const auto is_symbol = [](char c) { return IsLetter(c) || (c >= '0' && c <= '9') || c == '}'; };
    if (s == formula || !is_symbol(s[-1]) || !IsLetter(s[1])) return false;
    const bool word_before = s - formula >= 2 && IsLetter(s[-1]) && IsLetter(s[-2]);
    const bool word_after = IsLetter(s[2]);
    return !word_before && !word_after;
}

/// Finds the operand of `_` or `^`: the characters inside {…}, or a single one. Returns the operand's end, or `begin`
/// itself if there is no operand.
const char* ScriptEnd(const char* begin, const char** inside, const char** inside_end) {
    if (*begin == '\0' || *begin == ' ') return begin;
    if (*begin == '{') {
        const char* close = begin;
        while (*close != '\0' && *close != '}') ++close;
        *inside = begin + 1;
        *inside_end = close;
        return *close == '}' ? close + 1 : close;
    }
    *inside = begin;
    *inside_end = begin + std::max(1, CharacterBytes(begin));
    return *inside_end;
}

}  // namespace

FormulaLayout::FormulaLayout(const char* formula, std::span<const LetterRole> roles, ImU32 base, Face face)
    : font(face.font) {
    Writer writer(*this, face);
    ImU32 letter_color = base;
    for (const char* s = formula; *s != '\0';) {
        if (*s == '_' || *s == '^') {
            const char* inside = s;
            const char* inside_end = s;
            const char* end = ScriptEnd(s + 1, &inside, &inside_end);
            if (end != s + 1) {
                const Level level = *s == '_' ? Level::lowered : Level::raised;
                while (inside < inside_end) {
                    const int count = CharacterBytes(inside);
                    writer.Put(inside, count, level, letter_color);
                    inside += std::max(1, count);
                }
                s = end;
                continue;
            }
        }
        if (*s == ' ' && IsThinSpace(formula, s)) {
            writer.PutThinSpace();
            ++s;
            continue;
        }
        if (!IsLetter(*s)) {
            const int count = CharacterBytes(s);
            letter_color = ColorOf(CharacterAt(s, count), roles, base);
            writer.Put(s, count, Level::line, letter_color);
            s += std::max(1, count);
            continue;
        }
        const char* word_end = s;
        while (IsLetter(*word_end)) ++word_end;
        const bool is_word = word_end - s >= 3, is_alone = word_end - s == 1;  // "ln" is neither
        for (; s < word_end; ++s) {
            letter_color = is_word ? base : ColorOf(static_cast<unsigned char>(*s), roles, base);
            const bool is_script_l = is_alone && *s == 'l' && writer.HasScriptL();
            writer.Put(is_script_l ? "ℓ" : s, is_script_l ? 3 : 1, Level::line, letter_color);
        }
    }
    writer.Close();
}

void FormulaLayout::Draw(ImDrawList* draw, ImVec2 position, float opacity) const {
    for (int i = 0; i < piece_count; ++i) {
        const Piece& piece = pieces[i];
        const ImU32 color = Shown(opacity < 1.0F ? WithAlpha(piece.color, opacity) : piece.color);
        draw->AddText(font, piece.size, ImVec2(position.x + piece.x, position.y + piece.y), color, text + piece.begin,
                      text + piece.end);
    }
}

}  // namespace inner

ImVec2 Formula(ImDrawList* draw, ImVec2 position, const char* formula, std::span<const LetterRole> roles, ImU32 base,
               ImFont* font) {
    const inner::FormulaLayout layout(formula, roles, base, inner::FaceOf(font));
    if (draw) layout.Draw(draw, position);
    return layout.size;
}

}  // namespace widgets
