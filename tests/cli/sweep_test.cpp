// sweep: the same pictures as snapshot, and a table whose numbers are known.
#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>

#include "cli/program.h"

namespace cli_tests {
namespace {

class Sweep : public Program {
protected:
    std::vector<std::string> small(std::vector<std::string> more) const {
        std::vector<std::string> words{"sweep", "--size", "64x36"};
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }
};

std::vector<std::string> lines_of(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

TEST_F(Sweep, DrawsWhatSnapshotDraws) {
    expect(0, small({"--vary", "light.position[0]=-2:2:5", "-o", "frames"}));
    const char* const values[] = {"-2", "-1", "0", "1", "2"};
    for (int i = 0; i < 5; ++i) {
        expect(0, {"snapshot", "--set", std::string("light.position[0]=") + values[i], "--size", "64x36", "--view",
                   "camera", "-o", "one.png"});
        EXPECT_EQ(read("frames/000" + std::to_string(i + 1) + ".png"), read("one.png")) << values[i];
    }
    EXPECT_FALSE(exists("frames/0006.png"));
}

/// P · L of the floor is the light's height, and that is S's first entry.
TEST_F(Sweep, WritesATableOfExpressions) {
    const std::string table = expect(0, {"sweep", "--vary", "light.position[1]=1:4:4", "--csv", "-", "--value",
                                         "facts.plane_dot_light", "--value", "S[0][0]"})
                                  .out;
    EXPECT_EQ(lines_of(table), (std::vector<std::string>{"light.position[1],facts.plane_dot_light,S[0][0]", "1,1,1",
                                                         "2,2,2", "3,3,3", "4,4,4"}));
}

TEST_F(Sweep, GoesThroughKeyframesEasedAndBack) {
    const auto column = [&](const std::vector<std::string>& more) {
        std::vector<std::string> words{"sweep", "--csv", "-"};
        words.insert(words.end(), more.begin(), more.end());
        std::vector<std::string> lines = lines_of(expect(0, words).out);
        lines.erase(lines.begin());
        return lines;
    };
    using Lines = std::vector<std::string>;
    EXPECT_EQ(column({"--vary", "camera.yaw=0:10:0:5"}), (Lines{"0", "5", "10", "5", "0"}));
    EXPECT_EQ(column({"--vary", "camera.yaw=0:8:3", "--back"}), (Lines{"0", "4", "8", "4"}));
    EXPECT_EQ(column({"--vary", "camera.yaw=0:16:5", "--ease", "smooth"}), (Lines{"0", "2.5", "8", "13.5", "16"}));
    EXPECT_EQ(column({"--vary", "camera.yaw=7:9:1"}), (Lines{"7"}));
    EXPECT_EQ(column({"--vary", "depth.format=d16:d24:d32f:3"}), (Lines{"d16", "d24", "d32f"}));
    EXPECT_EQ(column({"--vary", "camera.target=[0,0,0]:[2,4,6]:3"}),
              (Lines{"\"[0,0,0]\"", "\"[1,2,3]\"", "\"[2,4,6]\""}));
    EXPECT_EQ(column({"--vary", "camera.yaw=0:1:2", "--vary", "camera.pitch=0:2:3"}),
              (Lines{"0,0", "0,1", "0,2", "1,0", "1,1", "1,2"}));
    EXPECT_EQ(column({"--vary", "camera.yaw=0:1:2", "--vary", "camera.pitch=0:2:2", "--together"}),
              (Lines{"0,0", "1,2"}));
}

TEST_F(Sweep, MakesASheet) {
    expect(0, small({"--vary", "light.position[1]=1:6:2", "--vary", "shadow.opacity=0.25:1:3", "-o", "sheet.png"}));
    const std::string bytes = read("sheet.png");
    ASSERT_GT(bytes.size(), 24U);
    const auto number_at = [&](std::size_t at) {
        int value = 0;
        for (std::size_t i = at; i < at + 4; ++i) value = value * 256 + static_cast<unsigned char>(bytes[i]);
        return value;
    };
    EXPECT_EQ(number_at(16), 8 + 3 * (64 + 8)) << "a column for each value of the second";
    EXPECT_EQ(number_at(20), 8 + 2 * (36 + 20 + 16)) << "a row for each of the first";
}

TEST_F(Sweep, MakesFilmsWhereThereIsFfmpeg) {
    if (std::system("command -v ffmpeg ffprobe >/dev/null") != 0) GTEST_SKIP() << "ffmpeg is not installed";
    for (const std::string film : {"a.mp4", "a.gif", "a.webp"}) {
        expect(0, small({"--vary", "camera.yaw=0:30:7", "--fps", "10", "-o", film}));
        EXPECT_GT(read(film).size(), 500U) << film;
        if (film == "a.webp") continue;  // ffmpeg 5 does not read what it writes there
        const std::string probe =
            "ffprobe -v error -count_frames -show_entries stream=nb_read_frames,width,height "
            "-of csv=p=0 '" +
            (folder() / film).string() + "' >'" + (folder() / "probe").string() + "'";
        ASSERT_EQ(std::system(probe.c_str()), 0);
        EXPECT_EQ(read("probe").substr(0, 7), "64,36,7") << film;
    }
    expect(0, small({"--vary", "camera.yaw=0:30:7", "--fps", "10", "-o", "b.mp4"}));
    expect(0, small({"--vary", "camera.yaw=0:30:7", "--fps", "10", "-o", "c.mp4"}));
    EXPECT_EQ(read("b.mp4"), read("c.mp4"));
}

TEST_F(Sweep, SaysThatAFilmNeedsFfmpeg) {
    Surroundings without;
    without.environment["PATH"] = "/nowhere";
    refused(small({"--vary", "camera.yaw=0:1:2", "-o", "a.mp4"}), {"ffmpeg", "not installed"}, without);
}

TEST_F(Sweep, MistakesAreSaidBeforeAnythingIsDrawn) {
    refused(small({"-o", "a.png"}), {"--vary"});
    refused(small({"--vary", "camera.yaw=0:1", "-o", "a.png"}), {"camera.yaw=0:1", "PATH=FROM:TO:COUNT"});
    refused(small({"--vary", "camera.yaw=0:1:x", "-o", "a.png"}), {"COUNT", "10000"});
    refused(small({"--vary", "camera.yaw=0:1:20000", "-o", "a.png"}), {"COUNT"});
    refused(small({"--vary", "camera.yav=0:1:2", "-o", "a.png"}), {"camera.yav", "did you mean", "camera.yaw"});
    refused(small({"--vary", "projection.near=0:1:2", "-o", "a.png"}), {"projection.near"});
    refused(small({"--vary", "camera.yaw=0:1:2"}), {"-o"});
    refused(small({"--vary", "camera.yaw=0:1:2", "-o", "a.png", "--fps", "5"}), {"--fps", "film"});
    refused(small({"--vary", "camera.yaw=0:1:2", "-o", "a.png", "--value", "1"}), {"--value", "--csv"});
    refused(small({"--vary", "camera.yaw=0:1:2", "--csv", "-", "--value", "nonsense"}), {"nonsense"});
    refused(small({"--vary", "camera.yaw=0:1:2", "--vary", "camera.pitch=0:1:3", "--together", "-o", "a.png"}),
            {"2 and 3", "alike"});
    refused({"sweep", "--size", "63x36", "--vary", "camera.yaw=0:1:2", "-o", "a.mp4"}, {"even"});
    refused({"sweep", "--vary", "camera.yaw=0:1:200", "-o", "a.png"}, {"sheet", "16384"});
}

}  // namespace
}  // namespace cli_tests
