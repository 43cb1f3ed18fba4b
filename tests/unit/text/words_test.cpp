// Characters of UTF-8, against counts made by eye.
#include "text/words.h"

#include <gtest/gtest.h>

namespace viewing {
namespace {

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

TEST(Words, InAMessageAreCutBetweenCharacters) {
    const std::string line = one_line("x" + std::string(198, 'y') + "½½");
    EXPECT_EQ(line, "x" + std::string(198, 'y') + "…");
}

}  // namespace
}  // namespace viewing
