// Languages come from .po files alone, so another language needs only its file, as the pseudo-language shows here. A
// faulty file is reported in one sentence, and the language stays English.
#include "state/person/language.h"

#include <gtest/gtest.h>
#include <stdlib.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "platform/text_file.h"
#include "state/scene.h"
#include "text/catalogue.h"

namespace viewing {
namespace {

namespace fs = std::filesystem;

class LanguageTest : public ::testing::Test {
protected:
    LanguageTest() {
        fs::remove_all(folder);
        fs::create_directories(folder / "text");
        ::setenv("VIEWING_SANDBOX_ASSETS", folder.c_str(), 1);
    }
    ~LanguageTest() override {
        ::setenv("VIEWING_SANDBOX_ASSETS", assets.c_str(), 1);
        EXPECT_TRUE(speak(Language::en));
        fs::remove_all(folder);
    }
    void write(const std::string& content) const { std::ofstream(folder / "text" / "ko.po") << content; }

    const fs::path assets = assets_directory();
    // Tests run in parallel.
    const fs::path folder = fs::path(::testing::TempDir()) / ("language-test-" + std::to_string(::getpid()));
};

TEST_F(LanguageTest, FullyTranslatedFileIsALanguage) {
    const Result<std::string> korean = read_text_file(assets / "text" / "ko.po");
    ASSERT_TRUE(korean);
    const Result<std::vector<PoEntry>> entries = read_po(*korean);
    ASSERT_TRUE(entries) << entries.error();
    std::string file;
    const auto quoted = [](std::string_view text) {
        std::string result = "\"";
        for (const char c : text) result += c == '"' || c == '\\' ? std::string{'\\', c} : std::string{c};
        return result + "\"\n";
    };
    for (const PoEntry& entry : *entries)
        file += "msgid " + quoted(entry.english) + "msgstr " + quoted(pseudo_text(entry.english)) + "\n";
    write(file);
    ASSERT_TRUE(speak(Language::ko));
    EXPECT_EQ(spoken_language(), Language::ko);
    for (const PoEntry& entry : *entries) EXPECT_EQ(tr(entry.english.c_str()), pseudo_text(entry.english));
    EXPECT_NE(spoken_texts().find(pseudo_text("Scene")), std::string::npos);
    ASSERT_TRUE(speak(Language::en));
    EXPECT_STREQ(tr("Scene"), "Scene");
    EXPECT_EQ(spoken_texts(), "");
}

TEST_F(LanguageTest, FaultyFileIsReportedAndEnglishStays) {
    for (const char* const content : {"", "msgid \"Scene\"\n", "hello\n"}) {
        if (*content) write(content);
        const Status spoken = speak(Language::ko);
        ASSERT_FALSE(spoken) << content;
        EXPECT_NE(spoken.error().find("ko.po"), std::string::npos) << spoken.error();
        EXPECT_EQ(spoken.error().find('\n'), std::string::npos) << spoken.error();
        EXPECT_EQ(spoken_language(), Language::en);
        EXPECT_STREQ(tr("Scene"), "Scene");
    }
}

TEST_F(LanguageTest, MissingOrFuzzyTranslationFallsBackToEnglish) {
    write(
        "msgid \"Scene\"\nmsgstr \"장면\"\n\nmsgid \"Undo\"\nmsgstr \"\"\n\n#, fuzzy\nmsgid \"Redo\"\nmsgstr "
        "\"다시\"\n");
    ASSERT_TRUE(speak(Language::ko));
    EXPECT_STREQ(tr("Scene"), "장면");
    EXPECT_STREQ(tr("Undo"), "Undo");
    EXPECT_STREQ(tr("Redo"), "Redo");
}

TEST(SystemLanguage, IsTheFirstVariableSetOrEnglish) {
    struct Case {
        const char *all, *messages, *lang;
        Language expected;
    };
    const Case cases[] = {{"", "", "", Language::en},
                          {"", "", "ko_KR.UTF-8", Language::ko},
                          {"", "ko", "en_GB.UTF-8", Language::ko},
                          {"C.UTF-8", "ko_KR", "ko_KR", Language::en},
                          {"", "", "kok_IN", Language::en},
                          {"", "", "de_DE@euro", Language::en},
                          {"ko_KR@x", "", "", Language::ko}};
    for (const Case& each : cases) {
        ::setenv("LC_ALL", each.all, 1);
        ::setenv("LC_MESSAGES", each.messages, 1);
        ::setenv("LANG", each.lang, 1);
        EXPECT_EQ(system_language(), each.expected) << each.all << '|' << each.messages << '|' << each.lang;
    }
    for (const char* variable : {"LC_ALL", "LC_MESSAGES", "LANG"}) ::unsetenv(variable);
}

TEST(Languages, HaveTheirOwnNames) {
    ASSERT_EQ(names_of<Language>().size(), language_count);
    EXPECT_STREQ(language_names[static_cast<std::size_t>(Language::en)], "English");
    EXPECT_STREQ(language_names[static_cast<std::size_t>(Language::ko)], "한국어");
}

}  // namespace
}  // namespace viewing
