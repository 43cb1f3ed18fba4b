// Embedded files: both the assembler (.incbin) and the arrays of a browser build yield the bytes on disk.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "embedded/test_array.h"
#include "embedded/test_incbin.h"

namespace viewing {
namespace {

std::string bytes_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(Embed, BothMethodsMatchTheFileOnDisk) {
    const std::filesystem::path pictures = std::filesystem::path(std::getenv("TEST_SOURCE_DIR")) / "golden";
    int compared = 0;
    for (const char* name : {"preset-projector.png", "preset-room.png", "update"}) {
        const std::string expected = bytes_of(pictures / name);
        EXPECT_FALSE(expected.empty()) << name;
        EXPECT_EQ(embedded_test_array(name), expected) << name;
        EXPECT_EQ(embedded_test_incbin(name), expected) << name;
        ++compared;
    }
    EXPECT_EQ(compared, 3);
}

TEST(Embed, UnknownNameYieldsNothing) {
    EXPECT_TRUE(embedded_test_array("preset-projecto.png").empty());
    EXPECT_TRUE(embedded_test_incbin("preset-projecto.png").empty());
}

}  // namespace
}  // namespace viewing
