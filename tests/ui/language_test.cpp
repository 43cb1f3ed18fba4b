// Every text goes through the catalogue, and has room when it is longer. The window is drawn in the pseudo-language
// (text/catalogue.h): each text of the catalogue is in brackets, stretched by 40 %, without one English letter. So a
// word of English letters in the vertices that ImGui hands over was never looked up, and a "[" without its "]" is cut
// off.
#include <set>
#include <sstream>
#include <tuple>

#include "desk.h"
#include "text/catalogue.h"
#include "ui/parts/topics.h"

namespace viewing::test {
namespace {

/// A visible character on the screen.
struct Letter {
    ImWchar character;
    ImVec2 pen;  ///< where it was set, on the top of its line
    float end;   ///< where the next one of its word is set
    float line_height;
    ImVec4 clip;
};

/// The characters of the proportional fonts in a frame. What is monospaced is numbers, code and paths.
class Page {
public:
    explicit Page(const widgets::Fonts& fonts) {
        for (const ImFont* font : {fonts.text, fonts.heading, fonts.note})
            for (const ImFontGlyph& glyph : font->Glyphs)
                if (glyph.Visible) glyphs_[{glyph.U0, glyph.V0}] = {&glyph, font};
    }

    /// In the order in which they are drawn.
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
    std::optional<Letter> letter_at(const ImDrawList& list, const ImDrawCmd& command, ImDrawIdx first) const {
        const ImDrawVert& corner = list.VtxBuffer[static_cast<int>(command.VtxOffset) + first];
        const ImDrawVert& opposite = list.VtxBuffer[static_cast<int>(command.VtxOffset) + first + 2];
        const auto found = glyphs_.find({corner.uv.x, corner.uv.y});
        if (found == glyphs_.end()) return std::nullopt;
        const auto [glyph, font] = found->second;
        const float scale = (opposite.pos.x - corner.pos.x) / (glyph->X1 - glyph->X0);
        const ImVec2 pen(corner.pos.x - scale * glyph->X0, corner.pos.y - scale * glyph->Y0);
        return Letter{static_cast<ImWchar>(glyph->Codepoint), pen, pen.x + scale * glyph->AdvanceX,
                      scale * font->FontSize, command.ClipRect};
    }

    std::map<std::pair<float, float>, std::pair<const ImFontGlyph*, const ImFont*>> glyphs_;
};

bool is_english(ImWchar c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// What is no text: the symbols of formulas, GL and its names, the lecture's functions, and the program's own name.
bool is_symbol(const std::string& word) {
    static const std::set<std::string> symbols{
        "GL",      "BACK", "CCW",   "LESS", "MSAA", "BSP",          "Viewing",
        "Sandbox", "ab",   "ac",    "ad",   "bc",   "bd",           "cd",
        "fn",      "det",  "right", "up",   "back", "eye",          "aspect",
        "ll",      "sign", "xy",    "xz",   "yz",   "ShadowMatrix", "ReflectionMatrix"};
    return symbols.count(word) > 0 || word.rfind("gl", 0) == 0;
}

/// Words of at least two English letters.
std::set<std::string> english_words(const std::vector<Letter>& letters) {
    std::set<std::string> words;
    std::string word;
    const auto finish = [&] {
        if (word.size() > 1 && !is_symbol(word)) words.insert(word);
        word.clear();
    };
    for (std::size_t i = 0; i < letters.size(); ++i) {
        const bool goes_on = i > 0 && std::abs(letters[i].pen.x - letters[i - 1].end) < 1.5F &&
                             std::abs(letters[i].pen.y - letters[i - 1].pen.y) < 0.5F;
        if (!goes_on || !is_english(letters[i].character)) finish();
        if (is_english(letters[i].character)) word += static_cast<char>(letters[i].character);
    }
    finish();
    return words;
}

/// The visible parts of texts that begin and do not end, but for those that are scrolled out at the bottom.
std::vector<std::string> cut_texts(const std::vector<Letter>& letters) {
    struct Text {
        std::string shown;
        const Letter* last;
        bool is_complete = false;  ///< another one has begun
    };
    std::vector<Text> open;
    for (const Letter& letter : letters) {
        if (letter.character == '[') {
            if (!open.empty()) open.back().is_complete = true;
            open.push_back({"", &letter});
        }
        if (open.empty()) continue;
        if (!open.back().is_complete) {
            char bytes[5] = {};
            const ImWchar c = letter.character;
            if (c < 0x80) {
                bytes[0] = static_cast<char>(c);
            } else if (c < 0x800) {
                bytes[0] = static_cast<char>(0xC0 | (c >> 6U));
                bytes[1] = static_cast<char>(0x80 | (c & 0x3FU));
            }
            open.back().shown += bytes;
            open.back().last = &letter;
        }
        if (letter.character == ']') open.pop_back();
    }
    std::vector<std::string> cut;
    for (const Text& text : open) {
        const bool is_scrolled_out = text.last->pen.y + 2.0F * text.last->line_height > text.last->clip.w;
        if (!is_scrolled_out) cut.push_back(text.shown);
    }
    return cut;
}

using Case = std::tuple<ImVec2, double, Theme>;

class LanguageTest : public ::testing::TestWithParam<Case> {
protected:
    LanguageTest() { speak_pseudo(catalogue()); }
    ~LanguageTest() override { speak_english(); }
};

TEST_P(LanguageTest, EveryTextIsLookedUpAndHasRoom) {
    const auto [size, scale, theme] = GetParam();
    Desk desk(size);
    desk.params().ui = {theme, scale};
    desk.apply_looks();
    desk.ui.frames(4);
    std::map<std::string, std::string> words, cut;
    for (std::size_t topic = 0; topic < names_of<Topic>().size(); ++topic)
        for (const bool prefers_matrices : {false, true}) {
            const UiParams looks = desk.params().ui;
            desk.params() = Params{};
            desk.params().ui = looks;
            choose_topic(desk.params(), Slot::left, static_cast<Topic>(topic));
            desk.workbench.arrangement.prefers_matrices = prefers_matrices;
            desk.ui.frames(4);
            if (!desk.layout().panel.empty()) desk.fold_out_all();
            desk.ui.move_to({-1, -1});
            desk.ui.frames(3);
            const Page page(desk.workbench.widgets.fonts);
            const ImDrawData* data = ImGui::GetDrawData();
            for (int i = 0; i < data->CmdListsCount; ++i) {
                const std::vector<Letter> letters = page.letters(*data->CmdLists[i]);
                const std::string window = data->CmdLists[i]->_OwnerName;
                const std::string where = names_of<Topic>()[topic] + (", " + window);
                for (const std::string& word : english_words(letters)) words.emplace(word, where);
                for (const std::string& text : cut_texts(letters)) cut.emplace(text, where);
            }
        }
    for (const auto& [word, where] : words) ADD_FAILURE() << word << " (" << where << ") is not in the catalogue";
    for (const auto& [text, where] : cut) ADD_FAILURE() << text << " (" << where << ") is cut off";
}

INSTANTIATE_TEST_SUITE_P(Sizes, LanguageTest,
                         ::testing::Values(Case{{1600, 900}, 1.0, Theme::dark}, Case{{800, 600}, 1.0, Theme::dark},
                                           Case{{1600, 900}, 1.0, Theme::projector},
                                           Case{{1280, 720}, 1.0, Theme::light},
                                           Case{{1600, 3000}, 1.0, Theme::dark}));  // the whole panel

}  // namespace
}  // namespace viewing::test
