// The blocks of the manual's Markdown, and its topics.
#include "text/manual.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>

namespace viewing {
namespace {

std::string described(const ManualBlock& block) {
    static constexpr const char* names[] = {"heading", "paragraph", "item", "code", "row"};
    std::string text = names[static_cast<std::size_t>(block.part)];
    for (const std::string& cell : block.cells) text += "|" + cell;
    return text;
}

std::vector<std::string> blocks_of(std::string_view markdown) {
    std::vector<std::string> all;
    for (const ManualBlock& block : manual_blocks(markdown)) all.push_back(described(block));
    return all;
}

using Texts = std::vector<std::string>;

TEST(Manual, HasHeadingsParagraphsListsCodeAndTables) {
    EXPECT_EQ(blocks_of("# One\n\nTwo\nthree.\n- four\n  five\n- six\n\n1. seven\n```sh\n  a | b\n\nc\n```\n| d | e "
                        "|\n|---|---|\n| `f|` | |\n"),
              (Texts{"heading|One", "paragraph|Two three.", "item|- four five", "item|- six", "item|1. seven",
                     "code|  a | b", "code|", "code|c", "row|d|e", "row|f||"}));
    EXPECT_EQ(blocks_of(""), Texts{});
}

TEST(Manual, RemovesMarkupOutsideCode) {
    EXPECT_EQ(blocks_of("**Bold** and *plain*, `a*b` and [a link](README.md), \\*."),
              Texts{"paragraph|Bold and plain, a*b and a link, *."});
    EXPECT_EQ(blocks_of("Entries [2] and P[3][2] stay."), Texts{"paragraph|Entries [2] and P[3][2] stay."});
    EXPECT_EQ(blocks_of("1.5 is no item.\n"), Texts{"paragraph|1.5 is no item."});
}

TEST(Manual, HasATopicForEachFile) {
    std::set<std::string> files, topics;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::string(std::getenv("VIEWING_SANDBOX_ASSETS")) + "/manual"))
        files.insert(entry.path().stem().string());
    for (const char* name : manual_topics()) {
        topics.insert(name);
        const std::vector<ManualBlock> blocks = manual_topic(name);
        ASSERT_FALSE(blocks.empty()) << name;
        EXPECT_EQ(blocks.front().part, ManualPart::heading) << name;
        EXPECT_EQ(manual_text(blocks).substr(0, blocks.front().cells.front().size()), blocks.front().cells.front());
    }
    EXPECT_EQ(files, topics);
    EXPECT_TRUE(manual_topic("nothing").empty());
    EXPECT_EQ(manual_text(manual_topic("nothing")), "");
}

TEST(Manual, WrapsTextAndKeepsLinesOfCode) {
    for (const char* name : manual_topics()) {
        const std::string text = manual_text(manual_topic(name));
        std::size_t begin = 0;
        for (std::size_t end = 0; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1) {
            const std::string line = text.substr(begin, end - begin);
            if (line.starts_with("    ")) continue;  // code
            std::size_t characters = 0;
            for (const char byte : line) characters += (byte & 0xC0) != 0x80 ? 1U : 0U;
            EXPECT_LE(characters, 100U) << name << ": " << line;
        }
    }
}

}  // namespace
}  // namespace viewing
