// Every text goes through the catalog and still fits when it is longer. The window is drawn in the pseudo-language
// (text/catalogue.h), in which each text of the catalog is in brackets, is 40 % longer and has no English letters. If
// ImGui's vertices spell an English word, it was never looked up. If a "[" lacks its "]", the text is cut off.
#include <set>
#include <sstream>
#include <tuple>

#include "desk.h"
#include "letters.h"
#include "text/catalogue.h"
#include "ui/parts/topics.h"

namespace viewing::test {
namespace {

bool is_english(ImWchar c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// Returns whether a word is not text but a symbol of a formula, a name from GL, a function from the lecture, or the
/// program's name.
bool is_symbol(const std::string& word) {
    static const std::set<std::string> symbols{"GL",
                                               "BACK",
                                               "CCW",
                                               "LESS",
                                               "EQUAL",
                                               "MSAA",
                                               "BSP",
                                               "Viewing",
                                               "Sandbox",
                                               "ab",
                                               "ac",
                                               "ad",
                                               "bc",
                                               "bd",
                                               "cd",
                                               "fn",
                                               "det",
                                               "right",
                                               "up",
                                               "back",
                                               "eye",
                                               "aspect",
                                               "ll",
                                               "sign",
                                               "xy",
                                               "xz",
                                               "yz",
                                               "ShadowMatrix",
                                               "ReflectionMatrix"};
    return symbols.count(word) > 0 || word.rfind("gl", 0) == 0;
}

/// Returns the words of at least two English letters that are not symbols.
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

/// Returns the visible parts of texts whose ends are not visible, except those that scroll out at the bottom.
std::vector<std::string> cut_texts(const std::vector<Letter>& letters, bool scrolls) {
    struct Text {
        std::string shown;
        const Letter* last;
        bool is_complete = false;  ///< another text has begun after it
    };
    std::vector<Text> open;
    for (const Letter& letter : letters) {
        if (letter.character == '[') {
            if (!open.empty()) open.back().is_complete = true;
            open.push_back({"", &letter});
        }
        if (open.empty()) continue;
        if (!open.back().is_complete) {
            open.back().shown += utf8(letter.character);
            open.back().last = &letter;
        }
        if (letter.character == ']') open.pop_back();
    }
    std::vector<std::string> cut;
    for (const Text& text : open) {
        const bool is_scrolled_out = scrolls && text.last->pen.y + 2.0F * text.last->line_height > text.last->clip.w;
        if (!is_scrolled_out) cut.push_back(text.shown);
    }
    return cut;
}

using Looks = std::tuple<ImVec2, double, Theme>;

class LanguageTest : public ::testing::TestWithParam<Looks> {
protected:
    LanguageTest() { speak_pseudo(catalogue()); }
    ~LanguageTest() override { speak_english(); }
};

TEST_P(LanguageTest, EveryTextIsLookedUpAndFits) {
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
            const widgets::Fonts& fonts = desk.workbench.widgets.fonts;  // monospaced text is numbers, code and paths
            const Page page{fonts.text, fonts.heading, fonts.note};
            const ImDrawData* data = ImGui::GetDrawData();
            for (int i = 0; i < data->CmdListsCount; ++i) {
                const std::vector<Letter> letters = page.letters(*data->CmdLists[i]);
                const std::string window = data->CmdLists[i]->_OwnerName;
                const std::string where = names_of<Topic>()[topic] + (", " + window);
                for (const std::string& word : english_words(letters)) words.emplace(word, where);
                const bool scrolls = window != "top" && window != "status" && window != "views";
                for (const std::string& text : cut_texts(letters, scrolls)) cut.emplace(text, where);
            }
        }
    for (const auto& [word, where] : words) ADD_FAILURE() << word << " (" << where << ") is not in the catalog";
    for (const auto& [text, where] : cut) ADD_FAILURE() << text << " (" << where << ") is cut off";
}

INSTANTIATE_TEST_SUITE_P(Sizes, LanguageTest,
                         ::testing::Values(Looks{{1600, 900}, 1.0, Theme::dark}, Looks{{800, 600}, 1.0, Theme::dark},
                                           Looks{{1600, 900}, 1.0, Theme::projector},
                                           Looks{{1280, 720}, 1.0, Theme::light},
                                           Looks{{1600, 3000}, 1.0, Theme::dark}));  // the whole panel

}  // namespace
}  // namespace viewing::test
