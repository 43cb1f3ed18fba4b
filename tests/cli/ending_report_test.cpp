// Tests the report of --json, which is written no matter how compare or snapshot ends.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include "cli/program.h"
#include "platform/sanitized.h"

namespace cli_tests {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Words = std::vector<std::string>;

class EndingReport : public Program {
protected:
    static Words with(Words words, const Words& more) {
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }
    static Words small(const Words& more) { return with({"snapshot", "--view", "camera", "--size", "96x64"}, more); }

    /// Expects the run to end with this status and its report to say the same as standard error; returns the report.
    Json told(int status, const Words& arguments, const Surroundings& surroundings = {}) const {
        const Ended ended = run(with(arguments, {"--json", "report.json"}), surroundings);
        EXPECT_EQ(ended.status, status) << ended.told();
        if (!exists("report.json")) {
            ADD_FAILURE() << "no report\n" << ended.told();
            return Json::object();
        }
        Json report = Json::parse(read("report.json"));
        fs::remove(folder() / "report.json");
        EXPECT_EQ(report.at("status"), status);
        EXPECT_EQ(report.at("command"), arguments.front());
        EXPECT_FALSE(report.at("meaning").get<std::string>().empty());
        EXPECT_NE(expect(0, {"--version"}).out.find(report.at("version").get<std::string>()), std::string::npos);
        if (!ended.err.empty()) {
            EXPECT_EQ(report.at("sentence").get<std::string>() + "\n", ended.err);
        }
        return report;
    }
    /// Expects the same as told(), and that no new file appears.
    Json alone(int status, const Words& arguments, const Surroundings& surroundings = {}) const {
        const std::size_t before = files();
        Json report = told(status, arguments, surroundings);
        EXPECT_EQ(files(), before);
        return report;
    }
};

TEST_F(EndingReport, OfBadInput) {
    const Words small_picture = small({"-o", "a.png"});
    for (const Words& wrong : std::vector<Words>{{"--set", "projection.near=0"},
                                                 {"--no-such-option"},
                                                 {"--samples", "3"},
                                                 {"missing.json"},
                                                 {"--compare", "a.jpg", "--worst", "300"},
                                                 {"--mask", "0,0,1,1"},
                                                 {"--repeat", "0"}}) {
        SCOPED_TRACE(wrong.front());
        const Json report = alone(2, with(small_picture, wrong));
        EXPECT_TRUE(report.at("duration_s").is_number());
        if (report.contains("compare")) {
            EXPECT_TRUE(report.at("compare").is_null() && report.at("renderer").is_null());
        }
    }
    EXPECT_EQ(alone(2, small({"-o", "missing/a.png"})).at("output"), "missing/a.png");
    EXPECT_EQ(alone(2, {"compare", "a.png", "b.png"}).at("a"), "a.png");
    EXPECT_EQ(alone(2, {"compare", "a.png"}).at("b"), nullptr);
    write("broken.png", "no picture");
    EXPECT_EQ(alone(2, small({"--compare", "broken.png"})).at("reference"), "broken.png");
    // A report is also written if it goes to standard output.
    const Ended ended = run(small({"-o", "a.png", "--samples", "3", "--json", "-"}));
    EXPECT_EQ(ended.status, 2);
    EXPECT_EQ(ended.json().at("status"), 2);
}

TEST_F(EndingReport, OfDriverErrors) {
    const Surroundings without_gl{.environment = {{"__EGL_VENDOR_LIBRARY_FILENAMES", "/nowhere.json"}}};
    const Json report = alone(3, small({"-o", "a.png"}), without_gl);
    EXPECT_EQ(report.at("size"), Json::parse("[96, 64]"));
    EXPECT_TRUE(report.at("renderer").is_null());
    EXPECT_TRUE(alone(5, small({"-o", "a.png", "--set", "camera.pitch=90", "--fail-if-blank"})).at("blank"));
}

TEST_F(EndingReport, OfComparisons) {
    expect(0, small({"-o", "a.png"}));
    expect(0, {"snapshot", "--view", "camera", "--size", "90x64", "-o", "narrow.png"});
    EXPECT_TRUE(alone(6, small({"--compare", "missing.png"})).at("compare").is_null());
    const Json equal = alone(0, small({"--compare", "a.png", "--profile", "portable"}));
    EXPECT_EQ(equal.at("compare").at("profile"), "portable");
    const Json different = alone(1, small({"--compare", "a.png", "--set", "camera.yaw=20"}));
    const Json sizes = alone(1, {"compare", "a.png", "narrow.png", "--mask", "0,0,9,9"});
    EXPECT_EQ(sizes.at("masks"), Json::parse(R"(["0,0,9,9"])"));
    EXPECT_EQ(sizes.at("sizes_differ"), true);
    for (const Json& report : {different.at("compare"), sizes, equal.at("compare")})
        for (const char* const name : {"mean", "worst", "blocks", "profile", "thresholds", "largest_block", "boxes"})
            EXPECT_TRUE(report.contains(name)) << name;
    EXPECT_EQ(different.at("sentence"), different.at("compare").at("sentence"));
    const Ended by_pipe = run(small({"--compare", "missing.png", "--json", "-"}));
    EXPECT_EQ(by_pipe.status, 6);
    EXPECT_EQ(by_pipe.json().at("sentence").get<std::string>() + "\n", by_pipe.err);
}

TEST_F(EndingReport, OfATimeout) {
    const Surroundings waiting{.input_stays_open = true};
    const Json report = alone(8, small({"-", "-o", "a.png", "--timeout", "0.3"}), waiting);
    EXPECT_EQ(report.at("duration_s"), 0.3);
    EXPECT_EQ(report.at("state"), "-");
    EXPECT_EQ(report.at("output"), "a.png");
    expect(0, small({"-o", "a.png"}));
    EXPECT_EQ(alone(8, {"compare", "a.png", "-", "--timeout", "0.3"}, waiting).at("equal"), nullptr);
    const Ended by_pipe = run(small({"-", "-o", "b.png", "--timeout", "0.3", "--json", "-"}), waiting);
    EXPECT_EQ(by_pipe.status, 8);
    EXPECT_EQ(by_pipe.json().at("status"), 8);
    // The report is written even if no process reads the picture.
    ASSERT_EQ(::mkfifo((folder() / "pipe").c_str(), 0600), 0);
    EXPECT_EQ(alone(8, small({"-o", "pipe", "--timeout", "2"})).at("duration_s"), 2.0);
}

TEST_F(EndingReport, ATimeoutBetweenFilesLeavesNothingUnfinished) {
    ASSERT_EQ(::mkfifo((folder() / "pipe").c_str(), 0600), 0);
    const Ended ended = run(small({"-o", "a.png", "--json", "pipe", "--timeout", "2"}));
    EXPECT_EQ(ended.status, 8) << ended.told();
    EXPECT_EQ(files(), 1U) << "the pipe";
}

TEST_F(EndingReport, OfAProcessWithoutMemory) {
    if (viewing::is_sanitized) GTEST_SKIP() << "a sanitizer needs terabytes of address space for itself";
    for (const unsigned long megabytes : {100, 140, 180, 220, 260, 300, 400}) {
        SCOPED_TRACE(std::to_string(megabytes) + " MB");
        const Ended ended =
            run(small({"-o", "a.png", "--json", "report.json"}),
                {.environment = {{"MESA_SHADER_CACHE_DISABLE", "1"}}, .limits = {{RLIMIT_AS, megabytes << 20U}}});
        if (ended.err.find("shared libraries") != std::string::npos) continue;  // the program did not start
        ASSERT_TRUE(exists("report.json")) << ended.told();
        EXPECT_EQ(Json::parse(read("report.json")).at("status"), ended.status) << ended.told();
        fs::remove(folder() / "report.json");
    }
}

TEST_F(EndingReport, OfAFullDisk) {
    EXPECT_EQ(told(2, small({"-o", "/dev/full"})).at("compare"), nullptr);
    const Ended ended = run(small({"-o", "missing/a.png", "--json", "-"}));
    EXPECT_EQ(ended.json().at("status"), 2) << ended.told();
}

TEST_F(EndingReport, LeavesOtherFilesAlone) {
    write("state.json", R"({"scene": "room.json"})");
    write("room.json", "no scene");
    for (const char* const name : {"state.json", "a.png", "/nowhere/report.json"}) {
        const Ended ended = run(small({"state.json", "-o", "a.png", "--no-such-option", "--json", name}));
        EXPECT_EQ(ended.status, 2) << ended.told();
    }
    refused(small({"state.json", "-o", "a.png", "--json", "room.json"}), {"--json", "scene", "same file"});
    EXPECT_EQ(read("state.json"), R"({"scene": "room.json"})");
    EXPECT_EQ(read("room.json"), "no scene");
    EXPECT_FALSE(exists("a.png"));
}

}  // namespace
}  // namespace cli_tests
