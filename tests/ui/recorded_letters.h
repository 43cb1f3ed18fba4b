// Checks that each letter drawn by Dear ImGui appears in a figure exactly once, at its position and in its color, and
// that no other letters appear. The letters are read from the latest frame's vertices (letters.h), independently of the
// recorder's own method.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "figure/write.h"
#include "ui/letters.h"
#include "ui/window/recording.h"

namespace viewing::test {

inline std::vector<Letter> letters_of_frame() {
    const Page page(ImGui::GetIO().Fonts->Fonts);
    std::vector<Letter> all;
    const ImDrawData& data = *ImGui::GetDrawData();
    for (int i = 0; i < data.CmdListsCount; ++i)
        for (const Letter& letter : page.letters(*data.CmdLists[i])) all.push_back(letter);
    return all;
}

/// A letter of the frame, and whether the recording accounts for it.
struct LetterOfFrame {
    Letter letter;
    bool is_recorded = false;
};

inline std::string described(char32_t character, float x, float y) {
    return "'" + utf8(static_cast<ImWchar>(character)) + "' at (" + std::to_string(x) + ", " + std::to_string(y) + ")";
}

/// Finds letters of the frame that the recording lost, and letters of the recording that the frame does not have.
class Accounts {
public:
    Accounts(const std::vector<Letter>& letters, const Drawing& drawing) {
        for (const Letter& letter : letters) drawn_[letter.character].push_back({letter});
        for (const Mark& mark : drawing.marks)
            if (const viewing::Line* const line = std::get_if<viewing::Line>(&mark.what)) account(*line);
        for (const auto& [character, all] : drawn_)
            for (const LetterOfFrame& drawn : all)
                if (!drawn.is_recorded && is_seen(drawn.letter))
                    wrong.push_back("lost: " + described(character, drawn.letter.pen.x, drawn.letter.baseline));
    }

    std::vector<std::string> wrong;

private:
    static bool is_seen(const Letter& letter) {
        const ImVec2 screen = ImGui::GetIO().DisplaySize;
        return letter.max.x > std::max(letter.clip.x, 0.0F) && letter.min.x < std::min(letter.clip.z, screen.x) &&
               letter.max.y > std::max(letter.clip.y, 0.0F) && letter.min.y < std::min(letter.clip.w, screen.y);
    }

    void account(const viewing::Line& line) {
        for (std::size_t i = 0; i < line.characters.size(); ++i) {
            const float x = line.lefts_px[i], baseline = line.baseline_px;
            if (line.characters[i] != U' ' && !take(line.characters[i], x, baseline, line.ink))
                wrong.push_back("made up: " + described(line.characters[i], x, baseline));
        }
    }

    bool take(char32_t character, float x, float baseline, const Ink& ink) {
        constexpr float reach = 0.3F;
        for (LetterOfFrame& drawn : drawn_[static_cast<ImWchar>(character)]) {
            if (drawn.is_recorded || std::abs(drawn.letter.pen.x - x) > reach ||
                std::abs(drawn.letter.baseline - baseline) > reach || ink_of(drawn.letter.color) != ink)
                continue;
            return drawn.is_recorded = true;
        }
        return false;
    }

    std::map<ImWchar, std::vector<LetterOfFrame>> drawn_;
};

/// Returns the contents of an SVG document's text elements.
inline std::vector<std::string> lines_in(const std::string& svg) {
    std::vector<std::string> texts;
    for (std::size_t at = svg.find("<text"); at != std::string::npos; at = svg.find("<text", at + 1)) {
        const std::size_t begin = svg.find('>', at) + 1;
        std::string text = svg.substr(begin, svg.find("</text>", begin) - begin);
        for (const auto& [entity, plain] : {std::pair{"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&amp;", "&"}})
            for (std::size_t found = text.find(entity); found != std::string::npos;
                 found = text.find(entity, found + 1))
                text.replace(found, std::string_view(entity).size(), plain);
        texts.push_back(text);
    }
    return texts;
}

inline std::vector<std::string> lines_in(const Drawing& drawing) {
    std::vector<std::string> texts;
    for (const Mark& mark : drawing.marks)
        if (const viewing::Line* const line = std::get_if<viewing::Line>(&mark.what)) {
            std::string& text = texts.emplace_back();
            for (const char32_t character : line->characters) text += utf8(static_cast<ImWchar>(character));
        }
    return texts;
}

/// Compares the drawing with the frame from which it was recorded, and its SVG document with the drawing.
inline void expect_all_letters(const Drawing& drawing, const std::string& what) {
    const std::vector<Letter> letters = letters_of_frame();
    EXPECT_FALSE(letters.empty()) << what;
    const Accounts accounts(letters, drawing);
    for (std::size_t i = 0; i < accounts.wrong.size() && i < 5; ++i)
        ADD_FAILURE() << what << ": " << accounts.wrong[i] << " (one of " << accounts.wrong.size() << ")";
    EXPECT_EQ(lines_in(as_svg(drawing, {})), lines_in(drawing)) << what;
}

}  // namespace viewing::test
