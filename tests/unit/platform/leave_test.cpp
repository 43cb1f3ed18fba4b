// Leaving flushes all output and skips everything else that runs at exit. Each test runs in a child process.
#include "platform/leave.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

#include "platform/text_file.h"
#include "unit/state/scratch_folder.h"

namespace viewing {
namespace {

class Leave : public testing::ScratchFolder {};

TEST_F(Leave, FlushesOutput) {
    const std::filesystem::path file = folder_ / "printed";
    EXPECT_EXIT(
        {
            std::FILE* const open = std::fopen(file.c_str(), "w");  // never closed
            std::fputs("all of it", open);
            leave(7);
        },
        ::testing::ExitedWithCode(7), "");
    const Result<std::string> printed = read_text_file(file);
    ASSERT_TRUE(printed) << printed.error();
    EXPECT_EQ(*printed, "all of it");
}

TEST_F(Leave, SkipsExitHandlersExceptUnderASanitizer) {
    EXPECT_EXIT(
        {
            std::atexit([] { std::fputs("taken down", stderr); });
            leave(0);
        },
        ::testing::ExitedWithCode(0), leaves_at_once ? "^$" : "^taken down$");
}

}  // namespace
}  // namespace viewing
