// When the program hits a system limit or a time limit, it still exits with a documented status.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include "cli/program.h"
#include "platform/sanitized.h"

namespace cli_tests {
namespace {

class Limits : public Program {};

TEST_F(Limits, EveryCommandHasATimeout) {
    const std::vector<std::vector<std::string>> waiting{{"state", "-"},
                                                        {"matrices", "-"},
                                                        {"inspect", "-", "--pixel", "0,0"},
                                                        {"measure", "-", "--what", "visibility"},
                                                        {"snapshot", "-", "-o", "a.png"},
                                                        {"open", "-"}};
    for (std::vector<std::string> arguments : waiting) {
        arguments.insert(arguments.end(), {"--timeout", "0.2"});
        const Ended ended = expect(8, arguments, {.input_stays_open = true});
        EXPECT_NE(ended.err.find("--timeout"), std::string::npos) << ended.told();
    }
    for (const char* command : {"open", "snapshot", "compare", "matrices", "inspect", "measure", "state", "params",
                                "presets", "doctor", "lesson", "exercises", "grade", "suite"}) {
        const Ended help = expect(0, {command, "--help"});
        EXPECT_NE(help.out.find("--timeout S"), std::string::npos) << command;
        EXPECT_NE(help.out.find("\n  8  "), std::string::npos) << command;
        refused({command, "--timeout", "0"}, {"--timeout"});
    }
    EXPECT_EQ(files(), 0U);
}

TEST_F(Limits, AFileSizeLimitIsLikeAFullDisk) {
    const Ended ended = expect(2, {"snapshot", "-o", "a.png", "--size", "320x240"},
                               {.environment = {{"MESA_SHADER_CACHE_DISABLE", "1"}}, .limits = {{RLIMIT_FSIZE, 2000}}});
    EXPECT_NE(ended.err.find("a.png: cannot be written"), std::string::npos) << ended.told();
    EXPECT_EQ(files(), 0U);
}

/// Memory may run out in the program or inside the driver.
TEST_F(Limits, LittleMemoryEndsWithADocumentedStatus) {
    if (viewing::is_sanitized) GTEST_SKIP() << "a sanitizer needs terabytes of address space for itself";
    for (const unsigned long megabytes : {400, 300, 260, 220, 180, 140, 100, 60}) {
        std::filesystem::remove(folder() / "a.png");
        const Ended ended =
            run({"snapshot", "-o", "a.png", "--size", "320x240"},
                {.environment = {{"MESA_SHADER_CACHE_DISABLE", "1"}}, .limits = {{RLIMIT_AS, megabytes << 20U}}});
        EXPECT_GE(ended.status, 0) << megabytes << " MB: " << ended.told();
        EXPECT_LE(ended.status, 9) << megabytes << " MB: " << ended.told();
        EXPECT_EQ(ended.status == 0, exists("a.png")) << megabytes << " MB: " << ended.told();
    }
}

/// This picture has four samples per pixel and needs an observer view besides the camera view. No other picture needs
/// more memory.
TEST_F(Limits, TheLargestPictureTakesAtMostAGigabyte) {
    const Ended ended =
        expect(0, {"snapshot", "--view", "observer", "--samples", "4", "--size", "4096x4096", "-o", "a.png"});
    if (!viewing::is_sanitized) {
        EXPECT_LT(ended.peak_bytes, 1'000'000'000);
    }
    EXPECT_GT(ended.peak_bytes, 4 * 4096 * 4096) << "the picture alone takes this much";
}

}  // namespace
}  // namespace cli_tests
