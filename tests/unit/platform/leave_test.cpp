// Leaving: what was printed is there, and nothing that would be done at a program's end keeps it. In children.
#include "platform/leave.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

#include "platform/text_file.h"
#include "unit/state/scratch_folder.h"

namespace viewing {
namespace {

class Leave : public testing::ScratchFolder {};

TEST_F(Leave, WhatWasPrintedIsWrittenOut) {
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

TEST_F(Leave, NothingIsDoneAtTheEndUnlessASanitizerLooks) {
    EXPECT_EXIT(
        {
            std::atexit([] { std::fputs("taken down", stderr); });
            leave(0);
        },
        ::testing::ExitedWithCode(0), leaves_at_once ? "^$" : "^taken down$");
}

}  // namespace
}  // namespace viewing
