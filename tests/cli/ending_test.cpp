// Commands that are stopped from outside leave no unfinished file and no child process; a suite still leaves its
// report.
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <cstdlib>
#include <random>
#include <thread>

#include "cli/program.h"

namespace cli_tests {
namespace {

namespace fs = std::filesystem;

class Ending : public Program {
protected:
    /// Returns the paths of everything below the folder.
    std::vector<std::string> names() const {
        std::vector<std::string> names;
        std::error_code gone;  // files may disappear while we look
        for (fs::recursive_directory_iterator at(folder(), gone), end; !gone && at != end; at.increment(gone))
            names.push_back(at->path().lexically_relative(folder()).string());
        return names;
    }
    void expect_nothing_unfinished() const {
        for (const std::string& name : names()) EXPECT_FALSE(has(name, ".viewing-sandbox-")) << name;
    }
    /// Returns the number of processes, of one program or of all, whose working directory is this folder.
    int processes_in_it(const std::string& program = "") const {
        int count = 0;
        std::error_code gone;  // a process may end while we look
        for (const fs::directory_entry& process : fs::directory_iterator("/proc", gone))
            if (fs::read_symlink(process.path() / "cwd", gone) == folder() &&
                (program.empty() || fs::read_symlink(process.path() / "exe", gone).filename() == program))
                ++count;
        return count;
    }
    void expect_nobody_left() const {
        const auto patience = std::chrono::steady_clock::now() + std::chrono::minutes(1);
        while (processes_in_it() > 0 && std::chrono::steady_clock::now() < patience)
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        EXPECT_EQ(processes_in_it(), 0);
    }
    static std::string entry(int i) {
        return R"({"name": "e)" + std::to_string(i) + R"(", "set": {"camera.yaw": )" + std::to_string(i) + "}}";
    }
    void write_suite(int count) const {
        std::string entries;
        for (int i = 0; i < count; ++i) entries += (i == 0 ? "" : ", ") + entry(i);
        write("suite.json",
              R"({"suite": 1, "defaults": {"size": [640, 480], "view": "window"}, "entries": [)" + entries + "]}");
    }
    nlohmann::json report() const { return nlohmann::json::parse(read("report/report.json")); }
    void expect_whole_pictures() const {
        for (const std::string& name : names())
            if (name.ends_with(".png")) {
                const std::string bytes = read(name);
                EXPECT_TRUE(bytes.starts_with("\x89PNG") && has(bytes.substr(bytes.size() - 12), "IEND")) << name;
            }
    }
};

constexpr int many = 40;

/// The parent cleans up after its workers, and the workers leave nothing unfinished either.
TEST_F(Ending, OfASuiteReportsTheRestAsNotDrawn) {
    for (const int signal : {SIGTERM, SIGINT, SIGHUP}) {
        SCOPED_TRACE(signal);
        for (const char* const left : {"references", "report"}) fs::remove_all(folder() / left);
        write_suite(many);
        const Ended ended = run({"suite", "run", "suite.json", "--jobs", "2"},
                                {.signal = signal, .signal_when = [&] { return exists("references/e0.png"); }});
        EXPECT_EQ(ended.status, 128 + signal) << ended.told();
        EXPECT_EQ(lines_of(ended.err).size(), 1U) << ended.told();
        expect_nothing_unfinished();
        expect_nobody_left();
        expect_whole_pictures();
        const nlohmann::json all = report();
        EXPECT_EQ(all["entries"].size(), std::size_t{many});
        EXPECT_GT(all["counts"]["not drawn"], 0);
        EXPECT_EQ(all["counts"]["not drawn"].get<int>() + all["counts"]["new"].get<int>(), many);
        for (const nlohmann::json& entry : all["entries"]) {
            const bool has_picture = exists("report/pictures/" + entry["file"].get<std::string>() + ".actual.png");
            const bool is_drawn = entry["outcome"] == "new";
            EXPECT_TRUE(is_drawn ? has_picture : has(entry["reasons"][0], "SIG")) << entry;
        }
        EXPECT_TRUE(has(read("report/junit.xml"), "<skipped message=")) << "other programs see skipped entries";
        EXPECT_TRUE(has(ended.err, std::to_string(all["counts"]["not drawn"].get<int>()) + " entries were not drawn"))
            << ended.err;
    }
}

TEST_F(Ending, OfASuiteByTimeoutLeavesItsReport) {
    std::string large;  // entries that take a second or more each
    for (const char* const name : {"a", "b", "c", "d", "e", "f"})
        large += R"({"name": ")" + std::string(name) + R"(", "size": [4096, 4096], "samples": 4}, )";
    write("suite.json", R"({"suite": 1, "entries": [{"name": "small"}, )" + large + R"({"name": "after"}]})");
    const Ended ended = expect(8, {"suite", "run", "suite.json", "--timeout", "3"});
    EXPECT_TRUE(has(ended.err, "--timeout")) << ended.err;
    expect_nothing_unfinished();
    expect_nobody_left();
    EXPECT_EQ(report()["entries"].size(), 8U);
    EXPECT_EQ(report()["entries"][7]["outcome"], "not drawn");
    EXPECT_TRUE(has(report()["entries"][7]["reasons"][0], "--timeout"));
}

/// If a suite ends early, the entries that it has not drawn keep their cache keys.
TEST_F(Ending, OfASuiteKeepsKnownResults) {
    write_suite(6);
    run({"suite", "run", "suite.json", "--cache"});
    expect(0, {"suite", "run", "suite.json", "--cache"});
    run({"suite", "run", "suite.json", "--cache"},
        {.signal = SIGTERM, .signal_when = [&] { return processes_in_it() > 1; }});
    EXPECT_GT(report()["counts"]["not drawn"], 0) << "the suite is stopped while its worker starts";
    EXPECT_TRUE(has(expect(0, {"suite", "run", "suite.json", "--cache"}).out, "(6 unchanged, not drawn again)"));
}

TEST_F(Ending, OfAKilledSuiteEndsItsWorkersToo) {
    write_suite(many);
    const Ended ended = run({"suite", "run", "suite.json", "--jobs", "2"},
                            {.signal = SIGKILL, .signal_when = [&] { return exists("references/e0.png"); }});
    EXPECT_EQ(ended.status, 128 + SIGKILL);
    expect_nobody_left();
    expect_nothing_unfinished();
    expect_whole_pictures();
    EXPECT_FALSE(exists("report/report.json"));
    EXPECT_EQ(run({"suite", "run", "suite.json", "--only", "e0"}).status, 0) << "the folder still belongs to the suite";
}

/// Signals arrive at random moments of the sweep, but not before its first picture.
TEST_F(Ending, OfASweepLeavesNoPartOfItsFolder) {
    constexpr unsigned seed = 41;
    std::cout << "seed " << seed << '\n';
    std::mt19937 random(seed);
    const auto pictures = [&] {
        std::size_t count = 0;
        for (const std::string& name : names()) count += name.ends_with(".png") ? 1U : 0U;
        return count;
    };
    for (const int signal : {SIGTERM, SIGINT, SIGHUP, SIGTERM}) {
        const std::size_t moment = random() % 12 + 1;
        SCOPED_TRACE(std::to_string(signal) + " at picture " + std::to_string(moment));
        const Ended ended = run({"sweep", "--vary", "camera.yaw=0:90:2000", "--size", "64x36", "-o", "a/frames"},
                                {.signal = signal, .signal_when = [&] { return pictures() >= moment; }});
        EXPECT_EQ(ended.status, 128 + signal) << ended.told();
        EXPECT_EQ(names(), std::vector<std::string>{});
    }
    expect(8, {"sweep", "--vary", "camera.yaw=0:90:2000", "--size", "64x36", "-o", "frames", "--timeout", "1"});
    EXPECT_EQ(names(), std::vector<std::string>{});
}

/// Replaces ffmpeg with a script that stores its input; the running process is named `cat`.
TEST_F(Ending, OfAFilmLeavesNoFileAndNoChild) {
    fs::create_directory(folder() / "bin");
    write("bin/ffmpeg", "#!/bin/sh\nfor last; do :; done\nexec cat >\"$last\"\n");
    fs::permissions(folder() / "bin/ffmpeg", fs::perms(0755));
    fs::create_directory(folder() / "temporary");
    const std::map<std::string, std::string> environment{
        {"TMPDIR", (folder() / "temporary").string()},
        {"PATH", (folder() / "bin").string() + ":" + std::getenv("PATH")}};
    const std::vector<std::string> before = names();
    for (const int signal : {SIGTERM, SIGKILL}) {
        const Ended ended = run(
            {"sweep", "--vary", "camera.yaw=0:90:2000", "--size", "64x36", "-o", "film.mp4"},
            {.environment = environment, .signal = signal, .signal_when = [&] { return processes_in_it("cat") > 0; }});
        EXPECT_EQ(ended.status, 128 + signal) << ended.told();
        expect_nobody_left();
        EXPECT_EQ(names(), before);
    }
    expect(0, {"sweep", "--vary", "camera.yaw=0:90:3", "--size", "64x36", "-o", "film.mp4"},
           {.environment = environment});
    EXPECT_EQ(read("film.mp4").size(), 3U * 64U * 36U * 4U);
    EXPECT_EQ(names().size(), before.size() + 1);
}

/// Complete files get their names only after standard output is written.
TEST_F(Ending, ByAPipeWithoutAReaderLeavesNothing) {
    const Ended ended = run({"snapshot", "--view", "camera", "--size", "64x36", "-o", "a.png", "--json", "-"},
                            {.output_has_no_reader = true});
    EXPECT_EQ(ended.status, 128 + SIGPIPE) << ended.told();
    EXPECT_EQ(names(), std::vector<std::string>{});
}

}  // namespace
}  // namespace cli_tests
