// Input and output files: empty, long or misleading names, and unreadable files. Apart from its output files, the
// program writes nothing.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdlib>

#include "cli/program.h"

namespace cli_tests {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

class FileNames : public Program {
protected:
    static Words small(const std::string& output, const Words& more = {}) {
        Words words{"snapshot", "--view", "camera", "--size", "48x32", "-o", output};
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }
};

TEST_F(FileNames, AnEmptyStateIsRefusedByEveryCommand) {
    refused({""}, {"STATE is empty"});
    refused({"open", ""}, {"STATE is empty"});
    refused(small("x.png", {""}), {"STATE is empty", "snapshot --help"});
    refused({"matrices", ""}, {"STATE is empty"});
    refused({"inspect", "", "--pixel", "1,1"}, {"STATE is empty"});
    refused({"measure", "", "--what", "fighting"}, {"STATE is empty"});
    refused({"state", ""}, {"STATE is empty"});
    refused({"compare", "a.png", ""}, {"B.png is empty"});
}

TEST_F(FileNames, AnEmptyValueIsRefused) {
    refused(small("x.png", {"--compare", ""}), {"--compare", "empty"});
    refused(small("x.png", {"--compare="}), {"--compare", "empty"});
    refused(small(""), {"empty"});
    refused(small("x.png", {"--json", ""}), {"empty"});
    refused({"state", "--bundle", ""}, {"--bundle", "empty"});
    refused({"inspect", "--pixels", ""}, {"empty"});
    refused({"state", "--mesh", ""}, {"--mesh", ".obj"});
}

TEST_F(FileNames, TwoHyphensEndTheOptions) {
    const std::string state = expect(0, {"state", "--set", "camera.yaw=7"}).out;
    write("--set", state);
    write("-x.json", state);
    EXPECT_EQ(expect(0, {"state", "--", "-x.json"}).out, state);
    EXPECT_EQ(expect(0, {"state", "--set=camera.yaw=8", "--", "--set"}).json()["camera"]["yaw"], 8);
    EXPECT_EQ(expect(0, {"state", "--", "-"}, {.input = state}).out, state);
    refused({"state", "--", "-x.json", "--help"}, {"\"--help\"", "unexpected argument"});
    refused({"state", "-x.json"}, {"-x.json: no such option"});
}

TEST_F(FileNames, PicturesEndInPng) {
    for (const char* name : {"x.jpg", "x", "x.png.gif", "png"}) refused(small(name), {"-o", ".png", name});
    expect(0, small("x.PNG"));
    expect(0, small("x.png", {"--json", "report.txt"}));
    expect(0, small("/dev/null"));
    refused({"compare", "x.PNG", "x.png", "-o", "difference.bmp"}, {"-o", ".png", "difference.bmp"});
}

TEST_F(FileNames, MayBeAsLongAsTheFileSystemAllows) {
    const std::string longest = std::string(251, 'x') + ".png", longer = "x" + longest;
    expect(0, small(longest));
    EXPECT_TRUE(exists(longest));
    refused(small(longer), {"cannot be written", "too long"});
    const std::string state = std::string(250, 'x') + ".json";
    write(state, "{}");
    EXPECT_EQ(expect(0, {"state", state}).out, expect(0, {"state"}).out);
    refused({"state", "x" + state}, {"cannot be read", "too long"});
}

TEST_F(FileNames, UnreadableFilesSayWhy) {
    fs::create_directory(folder() / "folder");
    refused({"state", "./folder"}, {"./folder: is a directory"});
    refused({"state", "missing.json"}, {"missing.json: no such file"});
    refused({"state", "/proc/self/mem"}, {"/proc/self/mem: is not a file on a disk"});
    refused({"state", "./folder/x.json"}, {"no such file"});
}

TEST_F(FileNames, ModesOfReplacedFilesAreKept) {
    write("x.png", "old");
    ASSERT_EQ(::chmod((folder() / "x.png").c_str(), 0604), 0);
    expect(0, small("x.png"));
    EXPECT_EQ(fs::status(folder() / "x.png").permissions(), static_cast<fs::perms>(0604));
}

TEST_F(FileNames, ASceneSaysThatItIsNotAPreset) {
    refused({"state", "decals"}, {"decals: is a scene, not a preset", "--set scene=decals"});
    refused(small("x.png", {"decals"}), {"decals: is a scene, not a preset", "--set scene=decals"});
    expect(0, {"state", "--set", "scene=decals"});
    EXPECT_EQ(expect(0, {"state", "coplanar"}).json()["scene"], "coplanar") << "a preset too";
}

TEST_F(FileNames, SamplesHasTwoValues) {
    const std::string error = expect(2, small("x.png", {"--samples", "8"})).err;
    EXPECT_NE(error.find("--samples: must be 0 or 4, got \"8\"\n"), std::string::npos) << error;
}

/// A preloaded library makes the program use one of the test's folders as its home folder.
TEST_F(FileNames, NothingElseIsWrittenWithoutAHome) {
    const fs::path library = fs::path(std::getenv("VIEWING_SANDBOX")).parent_path() / "tests" / "libother-home.so";
    if (!fs::exists(library)) GTEST_SKIP() << "no library to be loaded before others in this build";
    fs::create_directory(folder() / "home");
    fs::create_directory(folder() / "work");
    Surroundings bare{
        .folder = folder() / "work",
        .environment = {{"LD_PRELOAD", library.string()}, {"OTHER_HOME", (folder() / "home").string()}},
        .without = {"HOME", "XDG_CACHE_HOME", "XDG_DATA_HOME", "MESA_SHADER_CACHE_DIR", "MESA_SHADER_CACHE_DISABLE"}};
    for (const Words& words : {small("x.png"), Words{"snapshot", "-o", "x.png"}, Words{"inspect", "--pixel", "1,1"},
                               Words{"doctor"}, Words{"measure", "--what", "visibility"}})
        expect(0, words, bare);
    EXPECT_TRUE(fs::is_empty(folder() / "home"));
    EXPECT_EQ(std::distance(fs::directory_iterator(folder() / "work"), fs::directory_iterator()), 1);
    // When its cache is enabled, the driver writes to that home.
    bare.without.pop_back();
    bare.environment["MESA_SHADER_CACHE_DISABLE"] = "false";
    expect(0, small("x.png"), bare);
    EXPECT_FALSE(fs::is_empty(folder() / "home"));
}

}  // namespace
}  // namespace cli_tests
