// Catalogs: the reader of .po files, lookup, and the pseudo-language.
#include "text/catalogue.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace viewing {
namespace {

TEST(Po, ReadsMultilineTextsWithEscapes) {
    const auto entries = read_po(
        "# a comment\n"
        "msgid \"\"\nmsgstr \"Language: ko\\n\"\n\n"
        "#. where\nmsgid \"\"\n\"a \\\"quoted\\\"\\n\"\n\"second\"\nmsgstr \"b\"\n"
        "#, fuzzy\nmsgid \"c\"\nmsgstr \"d\"\n\n"
        "msgid \"e\"\nmsgstr \"\"\n#~ msgid \"gone\"\n");
    ASSERT_TRUE(entries) << entries.error();
    ASSERT_EQ(entries->size(), 3U);
    EXPECT_EQ((*entries)[0].english, "a \"quoted\"\nsecond");
    EXPECT_EQ((*entries)[0].translation, "b");
    EXPECT_EQ((*entries)[0].line, 6);
    EXPECT_FALSE((*entries)[0].is_fuzzy);
    EXPECT_TRUE((*entries)[1].is_fuzzy);
    EXPECT_EQ((*entries)[2].translation, "");
}

TEST(Po, ReportsAMistakeWithItsLine) {
    const auto message = [](std::string_view content) {
        const auto entries = read_po(content);
        return entries ? std::string("accepted") : entries.error();
    };
    EXPECT_EQ(message("msgid \"a\nmsgstr \"b\"\n"), "line 1: a string must be in double quotes on one line");
    EXPECT_EQ(message("msgid \"a\"\nmsgid \"b\"\n"), "line 2: a msgstr is missing before this line");
    EXPECT_EQ(message("msgid \"a\"\n"), "line 1: a msgstr is missing before this line");
    EXPECT_EQ(message("msgstr \"a\"\n"), "line 1: a msgstr must follow a msgid");
    EXPECT_EQ(message("msgid \"a\\q\"\nmsgstr \"\"\n"), "line 1: a backslash must be followed by n, t, \\ or \"");
    EXPECT_EQ(message("msgid \"a\"b\"\nmsgstr \"\"\n"), "line 1: a double quote inside a string must be written \\\"");
    EXPECT_EQ(message("\"a\"\n"), "line 1: a string must follow a msgid or a msgstr");
    EXPECT_EQ(message("msgctxt \"x\"\n"),
              "line 1: a line must begin with msgid, msgstr, # or a double quote, not with \"msgctxt\"");
    EXPECT_EQ(message("msgid \"a\"\nmsgstr \"\"\n\nmsgid \"a\"\nmsgstr \"\"\n"), "line 4: \"a\" appears twice");
}

TEST(Po, FindsPlaceholdersOfATemplate) {
    using Places = std::vector<std::string>;
    EXPECT_EQ(*places_in("{count} of {all} and {count}"), (Places{"all", "count"}));
    EXPECT_EQ(*places_in("{{no}} {z:>7}"), Places{"z:>7"});
    EXPECT_FALSE(places_in("{open"));
    EXPECT_FALSE(places_in("closed}"));
}

class CatalogTest : public ::testing::Test {
protected:
    ~CatalogTest() override { speak_english(); }
    static std::string differ() {
        return say("{count} of {all} differ", "count"_a = 3, "all"_a = grouped_number(4000));
    }
};

TEST_F(CatalogTest, EnglishIsShownUnchanged) {
    const char* english = "Scene";
    EXPECT_EQ(tr(english), english);
    EXPECT_EQ(differ(), "3 of 4,000 differ");
    EXPECT_EQ(say_count(1, "one node", "{count} nodes"), "one node");
    EXPECT_EQ(say_count(0, "one node", "{count} nodes"), "0 nodes");
    EXPECT_EQ(say_count(1200, "one node", "{count} nodes in {where}", "where"_a = "front"), "1,200 nodes in front");
}

TEST_F(CatalogTest, TranslationMayReorderPlaceholders) {
    speak(std::vector<PoEntry>{{"{count} of {all} differ", "{all} 중 {count}", false, 1}, {"Scene", "장면", false, 2}});
    EXPECT_EQ(differ(), "4,000 중 3");
    EXPECT_STREQ(tr("Scene"), "장면");
    EXPECT_EQ(tr_part("Scene"), "장면");
    EXPECT_STREQ(tr("scene"), "scene");
}

TEST_F(CatalogTest, BrokenOrMissingTranslationFallsBackToEnglish) {
    for (const char* broken : {"{cuont}", "{count", "}", "{count:q}", "{0} {7}", ""}) {
        speak(std::vector<PoEntry>{{"{count} of {all} differ", broken, false, 1}});
        EXPECT_EQ(differ(), "3 of 4,000 differ") << broken;
    }
    speak(std::vector<PoEntry>{{"Scene", "장면", true, 1}});
    EXPECT_STREQ(tr("Scene"), "Scene");
}

TEST_F(CatalogTest, LookedUpTextSurvivesALanguageChange) {
    speak(std::vector<PoEntry>{{"Scene", "장면", false, 1}});
    const char* shown = tr("Scene");
    speak_english();
    speak(std::vector<PoEntry>{{"Scene", "Szene", false, 1}});
    EXPECT_STREQ(shown, "장면");
    EXPECT_STREQ(tr("Scene"), "Szene");
}

TEST_F(CatalogTest, PseudoLanguageIsLongerWithoutEnglishLetters) {
    const std::string_view english = "Of {all} pixels, {count:>5} differ from the picture before.";
    const std::string pseudo = pseudo_text(english);
    EXPECT_EQ(pseudo.front(), '[');
    EXPECT_EQ(pseudo.back(), ']');
    EXPECT_EQ(*places_in(pseudo), *places_in(english));
    const auto is_character = [](char c) { return (c & 0xC0) != 0x80; };
    const auto length = std::count_if(pseudo.begin(), pseudo.end(), is_character);
    EXPECT_GE(static_cast<double>(length), 1.25 * static_cast<double>(english.size()));
    bool in_place = false;
    for (const char c : pseudo) {
        in_place |= c == '{';
        EXPECT_TRUE(in_place || !std::isalpha(static_cast<unsigned char>(c))) << c;
        in_place &= c != '}';
    }
    speak_pseudo(std::vector<PoEntry>{{"{count} of {all} differ", "", false, 1}});
    EXPECT_NE(differ().find('3'), std::string::npos);
    EXPECT_NE(differ().find("4,000"), std::string::npos);
    EXPECT_STREQ(tr("not in the catalogue"), "not in the catalogue");
}

}  // namespace
}  // namespace viewing
