// Reads back from a frame's vertices which letters ImGui draws: each visible character with its position and clip
// rectangle. This is what the user sees, independently of the code that drew it.
#pragma once

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace viewing::test {

/// A visible character on the screen.
struct Letter {
    ImWchar character;
    ImVec2 pen;  ///< its origin, at the top of its line
    float end;   ///< where the next letter of the same word would start
    float line_height;
    ImVec2 min, max;  ///< of its ink
    ImVec4 clip;
    bool is_shaved;  ///< whether ImGui itself clipped a part of it
    float baseline;
    ImU32 color;
};

inline std::string utf8(ImWchar c) {
    const auto byte = [](unsigned value) { return static_cast<char>(value); };
    if (c < 0x80) return {byte(c)};
    if (c < 0x800) return {byte(0xC0U | (c >> 6U)), byte(0x80U | (c & 0x3FU))};
    return {byte(0xE0U | (c >> 12U)), byte(0x80U | ((c >> 6U) & 0x3FU)), byte(0x80U | (c & 0x3FU))};
}

/// Finds the characters that a frame draws in certain fonts.
class Page {
public:
    explicit Page(std::initializer_list<const ImFont*> fonts) { add(fonts); }
    explicit Page(const ImVector<ImFont*>& fonts) { add(fonts); }

    /// Returns the letters of a draw list in drawing order.
    std::vector<Letter> letters(const ImDrawList& list) const {
        std::vector<Letter> letters;
        for (const ImDrawCmd& command : list.CmdBuffer)
            for (unsigned i = 0; i + 6 <= command.ElemCount;) {
                const ImDrawIdx* index = &list.IdxBuffer[static_cast<int>(command.IdxOffset + i)];
                const bool is_quad = index[1] == index[0] + 1 && index[2] == index[0] + 2 && index[3] == index[0] &&
                                     index[4] == index[2] && index[5] == index[0] + 3;
                const std::optional<Letter> letter = is_quad ? letter_at(list, command, index[0]) : std::nullopt;
                if (letter) letters.push_back(*letter);
                i += letter ? 6 : 3;
            }
        return letters;
    }

private:
    template <typename Fonts>
    void add(const Fonts& fonts) {
        for (const ImFont* font : fonts)
            for (const ImFontGlyph& glyph : font->Glyphs)
                if (glyph.Visible) glyphs_[{glyph.U0, glyph.V0}] = {&glyph, font};
    }

    std::optional<Letter> letter_at(const ImDrawList& list, const ImDrawCmd& command, ImDrawIdx first) const {
        const ImDrawVert& corner = list.VtxBuffer[static_cast<int>(command.VtxOffset) + first];
        const ImDrawVert& opposite = list.VtxBuffer[static_cast<int>(command.VtxOffset) + first + 2];
        const auto found = glyphs_.find({corner.uv.x, corner.uv.y});
        if (found == glyphs_.end()) return std::nullopt;
        const auto [glyph, font] = found->second;
        // A clipped letter keeps the texture position of its upper left corner but not that of the opposite corner.
        const float across = (opposite.pos.x - corner.pos.x) / (glyph->X1 - glyph->X0);
        const float along = (opposite.pos.y - corner.pos.y) / (glyph->Y1 - glyph->Y0);
        const float scale = std::max(across, along);
        const bool is_shaved = std::abs(across - along) > 0.02F * scale;
        const ImVec2 pen(corner.pos.x - scale * glyph->X0, corner.pos.y - scale * glyph->Y0);
        return Letter{static_cast<ImWchar>(glyph->Codepoint),
                      pen,
                      pen.x + scale * glyph->AdvanceX,
                      scale * font->FontSize,
                      corner.pos,
                      opposite.pos,
                      command.ClipRect,
                      is_shaved,
                      pen.y + scale * std::round(font->Ascent),
                      corner.col};
    }

    std::map<std::pair<float, float>, std::pair<const ImFontGlyph*, const ImFont*>> glyphs_;
};

/// Returns whether a letter continues the previous one's text, directly or after a space.
inline bool goes_on(const Letter& before, const Letter& letter) {
    const float room = 0.5F * before.line_height;  // a space between words of one text
    return std::abs(letter.pen.y - before.pen.y) < 0.5F && letter.pen.x > before.end - 1.5F &&
           letter.pen.x - before.end < room && std::abs(letter.line_height - before.line_height) < 0.5F;
}

/// Consecutive letters: a text or one line of a text.
struct Line {
    std::string text;
    ImVec2 min, max;
    ImVec4 clip;
    float line_height;
    bool is_shaved = false;
};

inline std::vector<Line> lines_of(const std::vector<Letter>& letters) {
    std::vector<Line> lines;
    const Letter* before = nullptr;
    for (const Letter& letter : letters) {
        if (!before || !goes_on(*before, letter))
            lines.push_back({"", letter.min, letter.max, letter.clip, letter.line_height});
        Line& line = lines.back();
        if (before && !line.text.empty() && letter.pen.x - before->end > 1.0F) line.text += ' ';
        line.text += utf8(letter.character);
        line.is_shaved |= letter.is_shaved;
        line.min = {std::min(line.min.x, letter.min.x), std::min(line.min.y, letter.min.y)};
        line.max = {std::max(line.max.x, letter.max.x), std::max(line.max.y, letter.max.y)};
        before = &letter;
    }
    return lines;
}

/// Returns the texts whose ink is cut by their clip rectangle at the left or right or, unless the window scrolls, at
/// the top or bottom.
inline std::vector<std::string> cut_lines(const std::vector<Line>& lines, bool scrolls) {
    constexpr float rounding = 1.0F;
    std::vector<std::string> cut;
    for (const Line& line : lines) {
        const bool beside =
            line.is_shaved || line.max.x > line.clip.z + rounding || line.min.x < line.clip.x - rounding;
        const bool below = line.max.y > line.clip.w + rounding || line.min.y < line.clip.y - rounding;
        if (beside || (below && !scrolls)) cut.push_back(line.text);
    }
    return cut;
}

}  // namespace viewing::test
