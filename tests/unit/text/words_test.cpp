// UTF-8 characters, checked against counts made by hand.
#include "text/words.h"

#include <gtest/gtest.h>

namespace viewing {
namespace {

TEST(Words, AFormulaIsOneUnbrokenStart) {
    EXPECT_EQ(unbroken_start("k = n·q + d입니다. 그리고"), "k = n·q + d입니다.");
    EXPECT_EQ(unbroken_start("t = (n·ℓ + d)/(n·ℓ − n·p) moves"), "t = (n·ℓ + d)/(n·ℓ − n·p)");
    EXPECT_EQ(unbroken_start("the plane n·p + d = 0"), "the");
    EXPECT_EQ(unbroken_start("L / Pᵀ"), "L / Pᵀ");
    EXPECT_EQ(unbroken_start("word"), "word");
    EXPECT_EQ(unbroken_start("= at the start"), "= at");
    EXPECT_EQ(unbroken_start("at the end ="), "at");
    EXPECT_EQ(unbroken_start(""), "");
}

TEST(Words, CountCharactersNotBytes) {
    EXPECT_EQ(character_count(""), 0U);
    EXPECT_EQ(character_count("near"), 4U);
    EXPECT_EQ(character_count("Δz ≤ ½"), 6U);
    EXPECT_EQ(character_count("그림자"), 3U);
    EXPECT_EQ(character_count("😀"), 1U);
}

TEST(Words, LoseWholeCharactersAtTheEnd) {
    std::string text = "a½그";
    for (const char* expected : {"a½", "a", "", ""}) {
        remove_last_character(text);
        EXPECT_EQ(text, expected);
    }
}

TEST(Words, AreCutBetweenCharacters) {
    const std::string line = one_line("x" + std::string(198, 'y') + "½½");
    EXPECT_EQ(line, "x" + std::string(198, 'y') + "…");
}

TEST(Words, HaveSingularAndPlural) {
    EXPECT_EQ(counted(0, "step"), "0 steps");
    EXPECT_EQ(counted(1, "step"), "1 step");
    EXPECT_EQ(counted(1024, "entry", "entries"), "1,024 entries");
}

TEST(Words, LongMessageKeepsBeginningAndEnd) {
    EXPECT_EQ(without_middle("a/b.png: no such folder", 23), "a/b.png: no such folder");
    EXPECT_EQ(without_middle("[[[[[[[[: no folder", 10), "[[[[[ … older");
    EXPECT_EQ(without_middle("그림자그림자", 10), "그 … 림자") << "cut between characters of three bytes each";
}

TEST(Words, MessageEscapesInvisibleAndBidiCharacters) {
    EXPECT_EQ(printable("é 그 🙂 a"), "é 그 🙂 a");
    EXPECT_EQ(printable("a\nb\x1b[31m\x7f"), "a\\u000ab\\u001b[31m\\u007f");
    EXPECT_EQ(printable("\xc2\x9b"), "\\u009b") << "C1";
    EXPECT_EQ(printable("a\xe2\x80\x8b\xef\xbb\xbf\xc2\xad"
                        "b"),
              "a\\u200b\\ufeff\\u00adb")
        << "zero width";
    EXPECT_EQ(printable("\xe2\x80\x8d"), "\xe2\x80\x8d") << "a joiner, which some scripts need";
    EXPECT_EQ(printable("\xef\xbf\xbe\xf0\x9f\xbf\xbf"), "\\ufffe\\u1ffff") << "noncharacters";
    EXPECT_EQ(printable("\xe2\x80\xae"
                        "gnp.exe"),
              "\\u202egnp.exe");
    for (const char* turner : {"\xe2\x80\x8e", "\xe2\x80\x8f", "\xe2\x80\xaa", "\xe2\x81\xa6", "\xe2\x81\xa9"})
        EXPECT_TRUE(printable(turner).starts_with("\\u20")) << printable(turner);
    EXPECT_EQ(printable("\xff"
                        "a\xe2\x80"),
              "\\xffa\\xe2\\x80")
        << "not UTF-8";
}

TEST(Words, QuoteAtMostTwentyCharactersOfAFile) {
    EXPECT_EQ(excerpt("12345678901234567890"), "12345678901234567890");
    EXPECT_EQ(excerpt("123456789012345678901"), "12345678901234567890…");
    EXPECT_EQ(excerpt("그그그그그그그그그그그그그그그그그그그그그"), "그그그그그그그그그그그그그그그그그그그그…");
    EXPECT_EQ(excerpt("\n2345678901234567890"), "\\u000a2345678901234567890");
}

}  // namespace
}  // namespace viewing
