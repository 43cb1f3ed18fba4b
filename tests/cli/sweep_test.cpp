// `sweep` draws the same pictures as `snapshot`, and its table holds the expected numbers.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstdlib>
#include <sstream>

#include "cli/program.h"
#include "platform/sanitized.h"

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

TEST_F(Sweep, DrawsTheSameAsSnapshot) {
    expect(0, small({"--vary", "light.position[0]=-2:2:5", "-o", "frames"}));
    const char* const values[] = {"-2", "-1", "0", "1", "2"};
    for (int i = 0; i < 5; ++i) {
        expect(0, {"snapshot", "--set", std::string("light.position[0]=") + values[i], "--size", "64x36", "--view",
                   "camera", "-o", "one.png"});
        EXPECT_EQ(read("frames/000" + std::to_string(i + 1) + ".png"), read("one.png")) << values[i];
    }
    EXPECT_FALSE(exists("frames/0006.png"));
}

/// For the floor, both P · L and the first entry of S equal the light's height.
TEST_F(Sweep, WritesATableOfExpressions) {
    const std::string table = expect(0, {"sweep", "--vary", "light.position[1]=1:4:4", "--csv", "-", "--value",
                                         "facts.plane_dot_light", "--value", "S[0][0]"})
                                  .out;
    EXPECT_EQ(lines_of(table), (std::vector<std::string>{"light.position[1],facts.plane_dot_light,S[0][0]", "1,1,1",
                                                         "2,2,2", "3,3,3", "4,4,4"}));
}

/// The numbers belong to the pictures of --size: a square picture has P[0][0] = P[1][1].
TEST_F(Sweep, NumbersAreThoseOfThePicturesSize) {
    const std::vector<std::string> sweep{"sweep", "--vary",  "projection.fovy=40:60:2", "--csv",
                                         "-",     "--value", "P[0][0]/P[1][1]"};
    const auto ratios = [&](std::vector<std::string> more) {
        more.insert(more.begin(), sweep.begin(), sweep.end());
        return lines_of(expect(0, more).out);
    };
    EXPECT_EQ(ratios({"--size", "400x400"})[1], "40,1");
    EXPECT_EQ(ratios({})[1], "40,0.5625");
    const std::string beyond = expect(2, {"sweep", "--vary", "projection.fovy=40:60:2", "--csv", "-", "--size", "64x36",
                                          "--value", "pixel(64,0).color"})
                                   .err;
    EXPECT_TRUE(has(beyond, "whole numbers below 64 and 36")) << beyond;
}

/// Interpolated values carry no rounding errors, and whole numbers have one form.
TEST_F(Sweep, ValuesAreWrittenAsTyped) {
    const auto column = [&](const std::string& vary) {
        std::vector<std::string> lines = lines_of(expect(0, {"sweep", "--vary", vary, "--csv", "-"}).out);
        lines.erase(lines.begin());
        return lines;
    };
    EXPECT_EQ(column("camera.yaw=0.1:12.7:7"),
              (std::vector<std::string>{"0.1", "2.2", "4.3", "6.4", "8.5", "10.6", "12.7"}));
    EXPECT_EQ(column("coplanar.gap=0:0.01:3"), (std::vector<std::string>{"0", "0.005", "0.01"}));
    const std::vector<std::string> lines =
        lines_of(expect(0, {"sweep", "--vary", "light.position=[0,1,0,1]:[1,1,1,1]:3", "--csv", "-", "--value",
                            "light.position"})
                     .out);
    EXPECT_EQ(lines[2], R"("[0.5,1,0.5,1]","[0.5,1,0.5,1]")");
}

TEST_F(Sweep, FollowsKeyframesEasedAndBack) {
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
    EXPECT_EQ(number_at(16), 8 + 3 * (64 + 8)) << "one column for each value of the second field";
    EXPECT_EQ(number_at(20), 8 + 2 * (36 + 20 + 16)) << "one row for each value of the first field";
}

TEST_F(Sweep, MakesFilmsWithFfmpeg) {
    if (std::system("command -v ffmpeg ffprobe >/dev/null") != 0)
        GTEST_SKIP() << "no ffmpeg: Debian's package of that name has it";
    for (const std::string film : {"a.mp4", "a.gif", "a.webp"}) {
        expect(0, small({"--vary", "camera.yaw=0:30:7", "--fps", "10", "-o", film}));
        EXPECT_GT(read(film).size(), 500U) << film;
        if (film == "a.webp") continue;  // ffmpeg 5 cannot read the WebP files that it writes
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

TEST_F(Sweep, AFolderOfPicturesIsReplacedAsAWhole) {
    expect(0, small({"--vary", "camera.yaw=0:9:4", "-o", "frames"}));
    std::filesystem::permissions(folder() / "frames", std::filesystem::perms(0750));
    const std::string second = read("frames/0002.png");
    expect(0, small({"--vary", "camera.yaw=0:90:2", "-o", "frames/"}));
    EXPECT_NE(read("frames/0002.png"), second);
    EXPECT_FALSE(exists("frames/0003.png")) << "a picture of the earlier sweep";
    EXPECT_EQ(std::filesystem::status(folder() / "frames").permissions(), std::filesystem::perms(0750));
    EXPECT_EQ(files(), 1U) << "the earlier folder is gone";

    std::filesystem::create_directory_symlink("frames", folder() / "link");
    expect(0, small({"--vary", "camera.yaw=0:9:3", "-o", "link"}));
    EXPECT_TRUE(exists("frames/0003.png"));
    EXPECT_TRUE(std::filesystem::is_symlink(folder() / "link"));

    const std::string kept = read("frames/0003.png");
    const Ended full =
        expect(2, small({"--vary", "camera.yaw=0:30:2", "-o", "frames"}), {.limits = {{RLIMIT_FSIZE, 300}}});
    EXPECT_TRUE(has(full.err, "cannot be written")) << full.told();
    const Ended table = run(small({"--vary", "camera.yaw=0:30:2", "-o", "frames", "--csv", "/dev/full"}));
    EXPECT_EQ(table.status, 2) << table.told();
    EXPECT_EQ(read("frames/0003.png"), kept);
    EXPECT_EQ(files(), 2U) << "no unfinished file is left";
}

/// A folder is replaced only if everything in it comes from a sweep.
TEST_F(Sweep, AFolderWithSomethingElseIsLeftAlone) {
    std::filesystem::create_directory(folder() / "mine");
    const auto is_refused = [&](const std::string& name) {
        refused(small({"--vary", "camera.yaw=0:9:2", "-o", "mine"}), {"mine", name, "new or an empty folder"});
        std::filesystem::remove_all(folder() / "mine" / name);
    };
    write("mine/notes.txt", "kept");
    is_refused("notes.txt");
    write("mine/0001.png", "a picture, but not of a sweep");
    is_refused("0001.png");
    std::filesystem::create_directory(folder() / "mine/0001.png");
    is_refused("0001.png");
    refused(small({"--vary", "camera.yaw=0:9:2", "-o", "."}), {"working folder"});
    write("file", "kept");
    refused(small({"--vary", "camera.yaw=0:9:2", "-o", "file"}), {"file", "it is a file"});
    expect(0, small({"--vary", "camera.yaw=0:9:2", "-o", "mine"}));
    for (const char* const film : {"film.mov", "film.avi", "sheet.jpg", "sheet.svg"}) {
        refused(small({"--vary", "camera.yaw=0:9:2", "-o", film}), {"must end in .png, .mp4, .gif, .webp", film});
        EXPECT_FALSE(exists(film));
    }
    std::filesystem::create_directory(folder() / "run.1");
    expect(0, small({"--vary", "camera.yaw=0:9:2", "-o", "run.1"}));
}

TEST_F(Sweep, MistakesAreReportedBeforeDrawing) {
    refused(small({"-o", "a.png"}), {"--vary"});
    refused(small({"--vary", "camera.yaw=0:1", "-o", "a.png"}), {"camera.yaw=0:1", "PATH=FROM:TO:COUNT"});
    refused(small({"--vary", "camera.yaw=0:1:x", "-o", "a.png"}), {"COUNT", "10000"});
    refused(small({"--vary", "camera.yaw=0:1:20000", "-o", "a.png"}), {"COUNT"});
    refused(small({"--vary", "camera.yav=0:1:2", "-o", "a.png"}), {"camera.yav", "did you mean", "camera.yaw"});
    refused(small({"--vary", "projection.near=0:1:2", "-o", "a.png"}), {"projection.near"});
    refused(small({"--vary", "camera.yaw=0:1:2"}), {"-o"});
    refused(small({"--vary", "camera.yaw=0:1:2", "-o", "a.png", "--fps", "5"}), {"--fps", "film"});
    refused(small({"--vary", "camera.yaw=0:1:2", "-o", "a.png", "--value", "1"}), {"--value", "--csv"});
    refused(small({"--vary", "camera.yaw=0:1:2", "--csv", "-", "--value", "nonsense"}),
            {"--value nonsense", "unknown name"});
    // The program must refuse these expressions before it draws: the memory limit is too low for a driver to start.
    for (const char* const expression : {"(function() return 1 end)()", "(--'\n(function() return 1 end)() --'\n)"})
        refused(small({"--vary", "camera.yaw=0:1:2", "--csv", "-", "--value", expression}),
                {"--value", "function is not allowed"},
                {.limits = {{RLIMIT_AS, viewing::is_sanitized ? RLIM_INFINITY : 120UL << 20U}}});
    refused(small({"--vary", "camera.yaw=0:1:2", "--vary", "camera.pitch=0:1:3", "--together", "-o", "a.png"}),
            {"2 and 3", "equal"});
    for (const char* const part : {"light.position[0]", "light.position"})
        refused(small({"--vary", "light.position[0]=-3:3:2", "--vary", std::string(part) + "=1:2:2", "-o", "a.png"}),
                {"light.position[0]", "overlap"});
    refused(small({"--vary", "depth.format=d16:d24:d32f:2", "-o", "a.png"}), {"number of values, 3"});
    refused(small({"--vary", "camera.yaw=0:1:2", "-o", "-"}), {"-o", "standard output"});
    refused(small({"--vary", "scene=torus-and-boxes:lecture:2", "-o", "a.png"}), {"--vary scene", "lecture"});
    refused({"sweep", "--size", "63x36", "--vary", "camera.yaw=0:1:2", "-o", "a.mp4"}, {"even"});
    // The program counts pictures before it lists them: a list of a hundred million would need gigabytes.
    refused(small({"--vary", "camera.yaw=0:1:10000", "--vary", "camera.pitch=0:1:10000", "-o", "a"}),
            {"100000000 pictures", "10000"}, {.limits = {{RLIMIT_CPU, 2}}});
    refused({"sweep", "--vary", "camera.yaw=0:1:200", "-o", "a.png"}, {"sheet", "16384"});
}

// ---- flights -------------------------------------------------------------------------------------------------------

constexpr const char* flight = R"({"version": 1, "kind": "flight", "seconds": 1.05, "state": {"camera": {"yaw": 20}},
"frames": [
{"t": 0.25, "set": {"camera.yaw": 25.000000000000004, "light.position": [1, 5, 2, 1]}},
{"t": 0.5, "set": {"camera.position": [3.3, 2.1, 6.6], "projection.near": 0.7}},
{"t": 0.5, "set": {"scene": "letters", "view.shows": "facing"}}
]})";

class SweepOfAFlight : public Sweep {
protected:
    SweepOfAFlight() { write("flight.json", flight); }
};

TEST_F(SweepOfAFlight, DrawsEachRecordedPictureAsSnapshotDrawsItsState) {
    expect(0, small({"flight.json", "-o", "frames"}));
    const char* const times[] = {"0", "0.25", "0.5"};
    const char* const files[] = {"frames/0001.png", "frames/0002.png", "frames/0004.png"};
    for (std::size_t i = 0; i < 3; ++i) {
        write("state.json", expect(0, {"state", "flight.json", "--at", times[i]}).out);
        expect(0, {"snapshot", "state.json", "--size", "64x36", "--view", "camera", "-o", "one.png"});
        EXPECT_EQ(read(files[i]), read("one.png")) << times[i];
        expect(0, {"snapshot", "flight.json", "--at", times[i], "--size", "64x36", "--view", "camera", "-o", "at.png"});
        EXPECT_EQ(read("at.png"), read("one.png")) << times[i];
    }
    EXPECT_TRUE(exists("frames/0003.png"));
    EXPECT_FALSE(exists("frames/0005.png"));
    EXPECT_EQ(expect(0, {"state", "flight.json"}).json()["camera"]["yaw"], 20) << "the start, without --at";
}

TEST_F(SweepOfAFlight, ShowsTheScreenAtEachTime) {
    const std::string table = expect(0, {"sweep", "flight.json", "--fps", "4", "--csv", "-", "--value", "camera.yaw",
                                         "--value", "projection.near"})
                                  .out;
    EXPECT_EQ(lines_of(table), (std::vector<std::string>{"t,camera.yaw,projection.near", "0,20,0.5",
                                                         "0.25,25.000000000000004,0.5", "0.5,25.000000000000004,0.7",
                                                         "0.75,25.000000000000004,0.7", "1,25.000000000000004,0.7"}));
    expect(0, small({"flight.json", "--fps", "4", "-o", "frames"}));
    EXPECT_EQ(read("frames/0003.png"), read("frames/0005.png"));
    EXPECT_NE(read("frames/0002.png"), read("frames/0003.png"));
    EXPECT_FALSE(exists("frames/0006.png"));
    expect(0, small({"flight.json", "-o", "sheet.png"}));
    EXPECT_GT(read("sheet.png").size(), 500U);
    const std::string dressed =
        expect(0, {"sweep", "flight.json", "--set", "shadow.opacity=0.125", "--csv", "-", "--value", "shadow.opacity"})
            .out;
    EXPECT_EQ(lines_of(dressed),
              (std::vector<std::string>{"t,shadow.opacity", "0,0.125", "0.25,0.125", "0.5,0.125", "0.5,0.125"}));
}

TEST_F(SweepOfAFlight, MistakesAreReported) {
    refused(small({"flight.json", "--vary", "camera.yaw=0:1:2", "-o", "a.png"}), {"--vary", "flight", "--at"});
    refused(small({"flight.json", "--back", "-o", "a.png"}), {"--back"});
    refused(small({"flight.json"}), {"-o"});
    refused({"snapshot", "flight.json", "--at", "2", "-o", "a.png"}, {"--at", "from 0 to 1.05"});
    refused({"snapshot", "--at", "2", "-o", "a.png"}, {"--at", "flight"});
    std::string wrong = flight;
    wrong.replace(wrong.find("camera.yaw"), 10, "camera.yav");
    write("wrong.json", wrong);
    refused(small({"wrong.json", "-o", "a.png"}),
            {"wrong.json", "frames[0]", "camera.yav", "did you mean camera.yaw?"});
    std::string back = flight;
    back.replace(back.find("0.5,"), 4, "0.1,");
    write("back.json", back);
    refused(small({"back.json", "-o", "a.png"}), {"back.json", "frames[1]", "0.1"});
    std::string late = flight;
    late.replace(late.find("1.05"), 4, "9999");
    write("late.json", late);
    refused(small({"late.json", "-o", "a.gif"}), {"--fps", "10000"});
}

}  // namespace
}  // namespace cli_tests
