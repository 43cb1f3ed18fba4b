// Korean: every character of the catalog and the lessons is drawn. Other characters are loaded on demand or shown as a
// box. An English window loads no Korean characters until a text needs them. Switching is immediate, and the language
// belongs to the user: neither opening a state nor undo ever changes it.
#include <regex>
#include <set>

#include "desk.h"
#include "letters.h"
#include "ui/window/syllables.h"

namespace viewing::test {
namespace {

constexpr ImWchar first_syllable = 0xAC00, last_syllable = 0xD7A3, box = 0x25A1;

std::vector<ImFont*> fonts_of(const Desk& desk) {
    const widgets::Fonts& fonts = desk.workbench.widgets.fonts;
    return {fonts.text, fonts.heading, fonts.note, fonts.number, fonts.small_number, fonts.caption};
}

bool shows(const Desk& desk, const char* syllable) {
    unsigned character = 0;
    for (const char* byte = syllable; *byte; ++byte)
        character = byte == syllable ? *byte & 0x0FU : character << 6U | (*byte & 0x3FU);
    for (ImFont* font : fonts_of(desk)) {
        const ImFontGlyph* glyph = font->FindGlyphNoFallback(static_cast<ImWchar>(character));
        if (!glyph || !glyph->Visible) return false;
    }
    return true;
}

/// Collects every text of a lesson, with its translations.
void collect(const Lesson& lesson, std::vector<LessonText>& texts) {
    texts.push_back(lesson.title);
    for (const LessonStep& step : lesson.steps) {
        for (const LessonText& text : {step.say, step.ask.question, step.reveal.say, step.note}) texts.push_back(text);
        texts.insert(texts.end(), step.ask.hints.begin(), step.ask.hints.end());
        texts.insert(texts.end(), step.ask.items.begin(), step.ask.items.end());
        for (const LessonChoice& choice : step.ask.choices) {
            texts.push_back(choice.say);
            texts.push_back(choice.why);
        }
        for (const WrongAnswer& wrong : step.ask.wrong) texts.push_back(wrong.say);
        if (step.target) texts.push_back(step.target->label);
    }
}

std::vector<LessonText> lecture_texts() {
    std::vector<LessonText> texts;
    for (const LessonFile& file : lessons()) collect(*load_lesson(file.path.string()), texts);
    return texts;
}

class KoreanTest : public UiTest {
protected:
    KoreanTest() {
        params.ui.language = Language::ko;
        desk.apply_looks();
        ui.frames(3);
    }
};

TEST_F(KoreanTest, EveryCharacterOfTheCatalogAndTheLessonsIsDrawn) {
    std::set<ImWchar> needed;
    const auto need = [&needed](const std::string& text) {
        for (const char* at = text.c_str(); *at;) {
            const auto lead = static_cast<unsigned char>(*at);
            const int length = lead < 0x80 ? 1 : lead < 0xE0 ? 2 : 3;
            ASSERT_LT(lead, 0xF0) << text;
            unsigned character = length == 1 ? lead : lead & (0xFFU >> (length + 1));
            for (int i = 1; i < length; ++i) character = character << 6U | (static_cast<unsigned>(at[i]) & 0x3FU);
            if (character > ' ' && character != 0xA0) needed.insert(static_cast<ImWchar>(character));
            at += length;
        }
    };
    for (const PoEntry& entry : catalogue()) need(entry.translation);
    for (const LessonText& text : lecture_texts()) {
        need(text.in(Language::ko));
        desk.workbench.korean.want(text.in(Language::ko));
    }
    desk.apply_looks();
    EXPECT_GT(needed.size(), 500U);
    for (const ImWchar character : needed)
        for (ImFont* font : fonts_of(desk)) {
            const ImFontGlyph* glyph = font->FindGlyphNoFallback(character);
            EXPECT_TRUE(glyph && glyph->Visible) << utf8(character);
        }
}

TEST_F(KoreanTest, EverySyllableIsDrawnOrShownAsABox) {
    for (ImWchar syllable = first_syllable; syllable <= last_syllable; ++syllable) desk.workbench.korean.want(syllable);
    desk.workbench.korean.want("〄");  // none of our fonts has it
    desk.apply_looks();
    for (ImFont* font : fonts_of(desk)) {
        int drawn = 0;
        for (ImWchar syllable = first_syllable; syllable <= last_syllable; ++syllable) {
            const ImFontGlyph* glyph = font->FindGlyph(syllable);
            drawn += glyph->Codepoint == syllable ? 1 : 0;
            ASSERT_TRUE(glyph->Visible) << utf8(syllable);
            ASSERT_TRUE(glyph->Codepoint == syllable || glyph->Codepoint == box) << utf8(syllable);
        }
        EXPECT_GE(drawn, 2350) << "KS X 1001";
        for (const ImWchar unknown : {ImWchar{0x3004}, ImWchar{0x4E00}}) {
            EXPECT_EQ(font->FindGlyph(unknown)->Codepoint, box);
            EXPECT_TRUE(font->FindGlyph(unknown)->Visible);
        }
    }
}

TEST_F(KoreanTest, EveryTextOfTheLectureIsTranslated) {
    static const std::regex hangul("[\xEA-\xED]");
    for (const LessonText& text : lecture_texts()) {
        // Formulas are the same in both languages.
        static const std::regex words("[a-z]{3,} [a-z]{2,} ");
        const bool is_sentence = std::regex_search(text.in_english(), words);
        static const std::regex latin("[A-Za-z]");  // texts without Latin letters need no translation
        const std::string korean = text.in(Language::ko);
        EXPECT_TRUE(!is_sentence || std::regex_search(korean, hangul) || !std::regex_search(korean, latin))
            << text.in_english();
    }
}

TEST_F(KoreanTest, ValuesAreNotFollowedBySoundDependentParticles) {
    // 은/는, 이/가, 을/를, 로/으로, 와/과 depend on whether the preceding word ends in a consonant.
    static const std::regex after_place("\\}(은|는|이|가|을|를|으로|로|와|과|이며|이고|이나|나)($|[ .,:;!?)])");
    for (const PoEntry& entry : catalogue())
        EXPECT_FALSE(std::regex_search(entry.translation, after_place)) << entry.line << ": " << entry.translation;
}

TEST_F(KoreanTest, UndoPresetsAndResetLeaveTheLanguageAlone) {
    params.projection.near = 1.0;
    ui.frames(3);
    params.ui.language = Language::en;
    ui.frames(3);
    params.ui.language = Language::ko;
    ui.frames(3);
    desk.undo();
    EXPECT_EQ(params.projection.near, Params{}.projection.near) << "undo reverts the number, not the language";
    EXPECT_EQ(params.ui.language, Language::ko);
    desk.redo();
    EXPECT_EQ(params.projection.near, 1.0);
    EXPECT_EQ(params.ui.language, Language::ko);
    desk.session.open("projector");
    desk.settle();
    EXPECT_EQ(params.ui.theme, Theme::projector);
    EXPECT_EQ(params.ui.language, Language::ko);
    EXPECT_FALSE(desk.session.departs_from_preset());
    desk.session.reset();
    EXPECT_EQ(params.ui.language, Language::ko);
    EXPECT_NE(desk.session.text().find("\"language\": \"ko\""), std::string::npos);
}

using EnglishTest = UiTest;

TEST_F(EnglishTest, LoadsNoKorean) {
    EXPECT_FALSE(shows(desk, "한"));
    for (ImFont* font : fonts_of(desk))
        for (const ImFontGlyph& glyph : font->Glyphs) EXPECT_LT(glyph.Codepoint, first_syllable);
}

TEST_F(EnglishTest, TheMenuSwitchesImmediately) {
    desk.click("top/Look");
    ui.frames(2);
    EXPECT_TRUE(desk.workbench.korean.has_new()) << "한국어 is in the menu";
    desk.apply_looks();
    EXPECT_TRUE(shows(desk, "어"));
    ui.click("top/language/한국어");
    EXPECT_EQ(params.ui.language, Language::ko);
    desk.apply_looks();
    EXPECT_STREQ(tr("Scene"), "장면");
    EXPECT_TRUE(shows(desk, "면"));
}

TEST_F(EnglishTest, ForeignKoreanTextIsLoadedOnDemand) {
    desk.clipboard = R"({"scene": {"objects": [{"name": "주전자", "shape": "teapot"}]}})";
    desk.press_with(Key::ctrl, Key::v);
    desk.settle();
    EXPECT_TRUE(desk.workbench.korean.has_new());
    desk.apply_looks();
    EXPECT_TRUE(shows(desk, "전"));
    EXPECT_NE(desk.session.text().find("주전자"), std::string::npos) << "written back unchanged";
    desk.session.message = {"파일.json: 열 수 없음", true};
    ui.frames(2);
    desk.apply_looks();
    EXPECT_TRUE(shows(desk, "없"));
}

}  // namespace
}  // namespace viewing::test
