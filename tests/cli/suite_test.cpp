// Tests `suite run`, `suite accept` and `suite merge` as an assistant would use them in CI.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <fstream>
#include <tuple>

#include "cli/program.h"

namespace cli_tests {
namespace {

namespace fs = std::filesystem;

class SuiteCommand : public Program {
protected:
    /// Writes a suite with two pictures and the matrices of one of them. `settings` apply to all entries.
    void write_suite(const std::string& settings = "{}", const std::string& more = "") const {
        write("suite.json", R"({"suite": 1, "title": "Two", "defaults": {"size": [160, 90], "samples": 0, "set": )" +
                                settings + R"(},
  "entries": [
    {"name": "opening"},
    {"name": "derivation", "state": "shadow-derivation", "matrices": {"tolerance": 1e-9}})" +
                                more + "]}");
    }
    nlohmann::json report(const std::string& folder = "report") const {
        return nlohmann::json::parse(read(folder + "/report.json"));
    }
    std::string outcome(const std::string& name, const std::string& folder = "report") const {
        const nlohmann::json entry = result(name, folder);
        return entry.is_null() ? "" : entry["outcome"].get<std::string>();
    }
    nlohmann::json result(const std::string& name, const std::string& folder = "report") const {
        const nlohmann::json all = report(folder);
        for (const nlohmann::json& entry : all["entries"])
            if (entry["name"] == name) return entry;
        return nullptr;
    }
};

TEST_F(SuiteCommand, WritesMissingReferencesOnceAndNeverChangesOne) {
    write_suite();
    const Ended first = run({"suite", "run", "suite.json"});
    EXPECT_EQ(first.status, 1) << first.told();
    EXPECT_TRUE(has(first.out, "Two: 2 entries: 2 new")) << first.out;
    EXPECT_TRUE(exists("references/opening.png"));
    EXPECT_TRUE(exists("references/derivation.json"));
    EXPECT_TRUE(has(expect(0, {"suite", "run", "suite.json"}).out, "2 passed"));

    const std::string before = read("references/opening.png"), numbers = read("references/derivation.json");
    write_suite(R"({"light.position": [1, 5, 2, 1]})");
    const Ended other = run({"suite", "run", "suite.json"});
    EXPECT_EQ(other.status, 1) << other.told();
    EXPECT_TRUE(has(other.out, "different  opening: the picture is different:")) << other.out;
    EXPECT_EQ(read("references/opening.png"), before);
    EXPECT_EQ(read("references/derivation.json"), numbers);
    const nlohmann::json derivation = result("derivation")["details"];
    EXPECT_EQ(derivation["state"][0]["path"], "light.position[0]");
    EXPECT_EQ(derivation["state"][0]["actual"], 1);
    EXPECT_EQ(derivation["numbers"][0]["path"], "shadow_from_world[0][0]");
    EXPECT_EQ(derivation["numbers"][0]["actual"], 5) << "n · l";
    for (const char* const ending : {".actual.png", ".expected.png", ".difference.png", ".js"})
        EXPECT_TRUE(exists("report/pictures/opening" + std::string(ending))) << ending;
    EXPECT_EQ(read("report/pictures/opening.expected.png"), before);
}

TEST_F(SuiteCommand, NewEntriesPassWithAcceptNew) {
    write_suite();
    expect(0, {"suite", "run", "suite.json", "--accept-new"});
    EXPECT_EQ(outcome("opening"), "new");
}

TEST_F(SuiteCommand, AcceptUsesTheResultsOfTheLastRun) {
    write_suite();
    run({"suite", "run", "suite.json"});
    refused({"suite", "accept", "suite.json", "opning"}, {"opning", "did you mean opening?"});
    write_suite(R"({"light.position": [1, 5, 2, 1]})");
    run({"suite", "run", "suite.json"});
    EXPECT_EQ(expect(0, {"suite", "accept", "suite.json", "opening"}).out, "1 reference accepted\n");
    EXPECT_EQ(read("references/opening.png"), read("report/pictures/opening.actual.png"));
    EXPECT_EQ(outcome("opening"), "passed");
    EXPECT_EQ(outcome("derivation"), "different") << "this entry was not accepted";
    EXPECT_EQ(expect(0, {"suite", "accept", "suite.json"}).out, "1 reference accepted\n");
    expect(0, {"suite", "run", "suite.json"});
}

TEST_F(SuiteCommand, AcceptTakesNoResultOfAnotherSuite) {
    write("a.json", R"({"suite": 1, "entries": [{"name": "opening"}]})");
    write("b.json", R"({"suite": 1, "entries": [{"name": "opening", "set": {"camera.yaw": 0}}]})");
    run({"suite", "run", "a.json"});
    const std::string reference = read("references/opening.png");
    run({"suite", "run", "b.json"});
    refused({"suite", "accept", "a.json"}, {"report has the report of another suite, b: run a again"});
    refused({"suite", "accept", "a.json", "opening"}, {"another suite"});
    EXPECT_EQ(read("references/opening.png"), reference);
    run({"suite", "run", "a.json"});
    EXPECT_EQ(outcome("opening"), "passed");
}

TEST_F(SuiteCommand, AcceptSaysWhereNothingCanBeAccepted) {
    write("suite.json", R"({"suite": 1, "entries": [{"name": "opening", "problems": {"must": ["no such problem"]}}]})");
    run({"suite", "run", "suite.json"});
    run({"suite", "run", "suite.json"});
    ASSERT_EQ(outcome("opening"), "different");
    refused({"suite", "accept", "suite.json", "opening"},
            {"opening: nothing to accept, the result equals its reference", "no such problem"});
    EXPECT_EQ(expect(0, {"suite", "accept", "suite.json"}).out, "0 references accepted\n");
    EXPECT_EQ(outcome("opening"), "different");
}

TEST_F(SuiteCommand, AReferenceThatCannotBeReplacedWholeIsKept) {
    write_suite();
    run({"suite", "run", "suite.json"});
    const std::string reference = read("references/opening.png");
    write_suite(R"({"light.position": [1, 5, 2, 1]})");
    run({"suite", "run", "suite.json"});
    ASSERT_NE(read("report/pictures/opening.actual.png"), reference);
    const std::size_t before = files();
    const Ended ended = expect(2, {"suite", "accept", "suite.json"}, {.limits = {{RLIMIT_FSIZE, 2000}}});
    EXPECT_TRUE(has(ended.err, "opening.png: cannot be written")) << ended.told();
    EXPECT_EQ(read("references/opening.png"), reference);
    EXPECT_EQ(files(), before) << "an unfinished file is left";
}

TEST_F(SuiteCommand, AFolderOfStatesIsASuite) {
    fs::create_directories(folder() / "states");
    write("states/plain.json", "{}");
    write("states/own-size.json", R"({"projection": {"fovy": 70}})");
    write("states/broken.json", R"({"projection": {"naer": 1}})");
    const Ended ended = run({"suite", "run", "states"});
    EXPECT_EQ(ended.status, 1);
    EXPECT_EQ(outcome("plain", "states/report"), "new");
    EXPECT_EQ(outcome("own-size", "states/report"), "new");
    EXPECT_EQ(outcome("broken", "states/report"), "failed");
    EXPECT_TRUE(has(ended.out, "projection.naer")) << ended.out;
    EXPECT_TRUE(has(run({"suite", "run", "states"}).out, "2 passed, 1 failed"));
}

TEST_F(SuiteCommand, RequiredAndForbiddenProblemsAreChecked) {
    write("suite.json", R"({"suite": 1, "entries": [
      {"name": "in the plane", "set": {"light.position": [1, 0, 0, 1]}, "problems": {"must": ["lies in the plane"]}},
      {"name": "by id", "set": {"light.position": [1, 0, 0, 1]},
       "problems": {"must": ["light.in_plane"], "must_not": ["light.behind_plane"]}},
      {"name": "id not reported", "problems": {"must": ["light.in_plane"]}},
      {"name": "nothing reported", "problems": {"must": ["lies in the plane"]}},
      {"name": "none at all", "set": {"light.position": [1, 0, 0, 1]}, "problems": {"none": true}}]})");
    run({"suite", "run", "suite.json"});
    EXPECT_EQ(run({"suite", "run", "suite.json"}).status, 1);
    EXPECT_EQ(outcome("in the plane"), "passed");
    EXPECT_EQ(outcome("by id"), "passed");
    EXPECT_EQ(outcome("id not reported"), "different");
    const nlohmann::json reported = report();
    for (const nlohmann::json& entry : reported["entries"])
        if (entry["name"] == "by id") {
            EXPECT_EQ(entry.at("details").at("problem_details")[0].at("id"), "light.in_plane") << entry;
            EXPECT_EQ(entry.at("details").at("problem_details")[0].at("say"), entry.at("details").at("problems")[0]);
        }
    EXPECT_EQ(outcome("nothing reported"), "different");
    EXPECT_EQ(outcome("none at all"), "different");
}

TEST_F(SuiteCommand, ShardsCoverEveryEntryOnceAndMergeIntoTheSameReport) {
    write_suite("{}", R"(,
    {"name": "c", "state": "orthographic"}, {"name": "d", "state": "teapot"}, {"name": "e", "state": "room"})");
    run({"suite", "run", "suite.json"});
    expect(0, {"suite", "run", "suite.json"});
    const nlohmann::json whole = report();
    for (const char* const shard : {"1/3", "2/3", "3/3"})
        expect(0, {"suite", "run", "suite.json", "--shard", shard, "--times", "report"});
    fs::remove_all(folder() / "report");
    expect(0, {"suite", "merge", "suite.json", "report-1-of-3", "report-2-of-3", "report-3-of-3"});
    const nlohmann::json merged = report();
    ASSERT_EQ(merged["entries"].size(), 5U);
    for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(merged["entries"][i]["name"], whole["entries"][i]["name"]);
    EXPECT_EQ(merged["counts"], whole["counts"]);
    EXPECT_TRUE(exists("report/pictures/e.actual.png"));

    const Ended without = run({"suite", "merge", "suite.json", "report-1-of-3", "report-3-of-3"});
    EXPECT_EQ(without.status, 1) << "a shard is missing: " << without.told();
    EXPECT_TRUE(has(without.out, "not drawn") && !has(without.out, "failed")) << without.out;
    EXPECT_EQ(run({"suite", "merge", "suite.json", "report-1-of-3", "report-1-of-3"}).status, 2) << "one twice";
}

TEST_F(SuiteCommand, UnchangedEntriesAreNotDrawnAgain) {
    write_suite();
    run({"suite", "run", "suite.json", "--cache"});
    EXPECT_TRUE(has(expect(0, {"suite", "run", "suite.json", "--cache"}).out, "2 passed"));
    const Ended again = expect(0, {"suite", "run", "suite.json", "--cache"});
    EXPECT_TRUE(has(again.out, "(2 unchanged, not drawn again)")) << again.out;

    write_suite(R"({"shadow.opacity": 0.6})");
    EXPECT_EQ(run({"suite", "run", "suite.json", "--cache"}).status, 1) << "the states have changed";
    EXPECT_EQ(result("opening")["kept"], false);
    write_suite();
    std::ofstream(folder() / "references/opening.png", std::ios::binary | std::ios::app) << "x";
    run({"suite", "run", "suite.json", "--cache"});
    run({"suite", "run", "suite.json", "--cache"});
    fs::copy_file(folder() / "references/derivation.png", folder() / "references/opening.png",
                  fs::copy_options::overwrite_existing);
    EXPECT_EQ(run({"suite", "run", "suite.json", "--cache"}).status, 1) << "the reference has changed";
    EXPECT_EQ(outcome("opening"), "different");
}

TEST_F(SuiteCommand, SeveralProcessesGiveTheSameResult) {
    write_suite("{}", R"(, {"each": "scene", "name": "scene-{}"})");
    run({"suite", "run", "suite.json", "--jobs", "3"});
    expect(0, {"suite", "run", "suite.json"});
    expect(0, {"suite", "run", "suite.json", "--jobs", "3"});
}

TEST_F(SuiteCommand, RunningOneEntryKeepsTheResultsOfTheOthers) {
    const auto write_with = [&](const std::string& state) {
        write_suite("{}", R"(, {"name": "other", "state": ")" + state + R"("}, {"name": "last", "state": "letters"})");
    };
    write_with("tilted-plane");
    run({"suite", "run", "suite.json", "--only", "other"});
    EXPECT_EQ(outcome("other"), "new") << "without an earlier report";
    EXPECT_EQ(report()["entries"].size(), 1U);
    expect(0, {"suite", "run", "suite.json", "--accept-new"});
    expect(0, {"suite", "run", "suite.json"});
    const auto names = [&] {
        std::string all;
        for (const auto& entry : report()["entries"]) all += entry["name"].get<std::string>() + " ";
        return all;
    };
    const std::string all = names();
    write_with("letters");
    EXPECT_EQ(run({"suite", "run", "suite.json", "--only", "other"}).status, 1);
    EXPECT_EQ(outcome("other"), "different");
    EXPECT_EQ(outcome("opening"), "passed");
    EXPECT_EQ(names(), all);
    EXPECT_TRUE(has(expect(0, {"suite", "accept", "suite.json"}).out, "1 reference accepted"));
    expect(0, {"suite", "run", "suite.json"});
    refused({"suite", "run", "suite.json", "--only", "opning"}, {"opning", "did you mean opening?"});
}

TEST_F(SuiteCommand, ReportsToGitHubAndListsStrayReferences) {
    write_suite();
    run({"suite", "run", "suite.json"});
    write("references/gone.png", "");
    write_suite(R"({"shadow.opacity": 0.9})");
    const Ended ended = run({"suite", "run", "suite.json", "--github"});
    EXPECT_TRUE(has(ended.out, "::error file=suite.json,title=opening%3A different::the picture is different:"))
        << ended.out;
    EXPECT_TRUE(has(ended.out, "1 reference belongs to no entry: gone.png")) << ended.out;
}

TEST_F(SuiteCommand, DifferencesWithinTheThresholdsPass) {
    write_suite(R"({"shadow.opacity": 0.5})");
    run({"suite", "run", "suite.json"});
    write("suite.json", R"({"suite": 1, "defaults": {"size": [160, 90], "samples": 0}, "entries": [
      {"name": "opening", "set": {"shadow.opacity": 0.51}, "worst": 6},
      {"name": "derivation", "state": "shadow-derivation", "set": {"shadow.opacity": 0.51}, "worst": 0, "share": 0.2}]})");
    expect(0, {"suite", "run", "suite.json"});
    EXPECT_GT(result("opening")["details"]["compare"]["different"].get<int>(), 0);
}

TEST_F(SuiteCommand, MaskedPixelsAreNotCompared) {
    write_suite();
    run({"suite", "run", "suite.json"});
    const auto with_mask = [&](const std::string& masks) {
        write(
            "suite.json", R"({"suite": 1, "defaults": {"size": [160, 90], "samples": 0, "set": {"shadow.opacity": 0.9},
               "masks": )" + masks +
                              R"(}, "entries": [{"name": "opening"}]})");
        return run({"suite", "run", "suite.json"}).status;
    };
    EXPECT_EQ(with_mask("[]"), 1);
    EXPECT_EQ(with_mask("[[0, 0, 160, 89]]"), 0);
    EXPECT_EQ(with_mask("[[0, 0, 80, 90], [80, 1, 80, 90]]"), 0);
    EXPECT_EQ(with_mask("[[0, 0, 10, 10]]"), 1);
    write("suite.json", R"({"suite": 1, "entries": [{"name": "a", "masks": [[0, 0, 5]]}]})");
    refused({"suite", "run", "suite.json"}, {"entries[0].masks[0]", "[x, y, width, height]"});
}

/// `suite run` refuses a wrong mask before it draws anything, and `compare` also refuses wrong masks.
TEST_F(SuiteCommand, MasksAreCheckedFirst) {
    expect(0, {"snapshot", "--view", "depth", "--size", "80x45", "-o", "small.png"});
    expect(0, {"snapshot", "--view", "camera", "--size", "160x90", "--samples", "0", "-o", "picture.png"});
    const std::pair<const char*, std::vector<std::string>> broken[] = {
        {R"(["nowhere.png"])", {"nowhere.png", "no such file"}},
        {R"(["small.png"])", {"small.png", "80 × 45", "160 × 90"}},
        {R"(["suite.json"])", {"suite.json", "not a PNG"}},
        {"[[160, 0, 5, 5]]", {"160,0,5,5", "outside", "160 × 90"}},
        {"[[0, 1000, 10, 10]]", {"0,1000,10,10", "outside"}},
        {"[[0, 0, 160, 90]]", {"nothing to compare"}},
        {"[[0, 0, 80, 90], [80, 0, 500, 90]]", {"nothing to compare"}}};
    for (const auto& [masks, words] : broken) {
        SCOPED_TRACE(masks);
        write("suite.json",
              R"({"suite": 1, "defaults": {"size": [160, 90], "samples": 0}, "entries": [{"name": "first"},
            {"name": "masked", "masks": )" +
                  std::string(masks) + "}]}");
        std::vector<std::string> all = words;
        all.insert(all.end(), {"suite.json", "masked"});
        refused({"suite", "run", "suite.json", "--accept-new"}, all);
    }
    for (const char* const mask : {"0,0,160,90", "160,0,1,1"})
        refused({"compare", "picture.png", "picture.png", "--mask", mask}, {"160 × 90"});
}

TEST_F(SuiteCommand, AnEntryThatCannotFailIsRefused) {
    const auto is_refused = [&](const std::string& entry, const std::string& why) {
        SCOPED_TRACE(entry);
        write("suite.json", R"({"suite": 1, "entries": [{"name": "good"}, {"name": "idle", )" + entry + "}]}");
        refused({"suite", "run", "suite.json"}, {"suite.json", "idle", why});
    };
    is_refused(R"("picture": false)", "tests nothing");
    is_refused(R"("picture": false, "matrices": false, "measure": [], "problems": {"none": false, "must": []})",
               "tests nothing");
    is_refused(R"("worst": 255)", "cannot fail");
    is_refused(R"("share": 1)", "cannot fail");
    write("suite.json",
          R"({"suite": 1, "entries": [{"name": "a"}], "loosened": [{"name": "a", "about": "x", "worst": 255}]})");
    refused({"suite", "run", "suite.json"}, {"cannot fail"});
    for (const char* const tested : {R"("matrices": true)", R"("measure": "order")",
                                     R"("problems": {"must_not": ["x"]})", R"("problems": {"none": true})"}) {
        write("suite.json",
              R"({"suite": 1, "entries": [{"name": "a", "picture": false, )" + std::string(tested) + "}]}");
        const Ended ended = run({"suite", "run", "suite.json", "--accept-new"});
        EXPECT_LE(ended.status, 1) << ended.told();
    }
}

/// Sizes follow the rules of `snapshot`, and the error messages are the same.
TEST_F(SuiteCommand, SizesAreThoseOfSnapshot) {
    for (const auto& [view, width, height] : {std::tuple("camera", 16384, 16384),
                                              {"camera", 4097, 4096},
                                              {"depth", 4000, 16001},
                                              {"window", 319, 240},
                                              {"tree", 320, 239}}) {
        SCOPED_TRACE(view);
        const std::string size = std::to_string(width) + "x" + std::to_string(height);
        write("suite.json", R"({"suite": 1, "defaults": {"size": [)" + std::to_string(width) + ", " +
                                std::to_string(height) + R"(]}, "entries": [{"name": "a", "view": ")" + view + "\"}]}");
        const std::string suite = run({"suite", "run", "suite.json"}).err;
        const std::string snapshot = run({"snapshot", "--view", view, "--size", size, "-o", "x.png"}).err;
        const std::string sweep =
            run({"sweep", "--view", view, "--size", size, "--vary", "camera.yaw=0:1:2", "-o", "d"}).err;
        const auto rule = [](const std::string& text) {
            const std::size_t begin = text.find("size: ");
            const std::size_t end = std::min(text.find(", got"), text.find('\n'));
            return begin == std::string::npos ? text : text.substr(begin, end - begin);
        };
        EXPECT_TRUE(has(suite, "pixels")) << suite;
        EXPECT_EQ(rule(suite), rule(snapshot));
        EXPECT_EQ(rule(sweep), rule(snapshot));
    }
    EXPECT_EQ(files(), 1U);
}

TEST_F(SuiteCommand, AReportDoesNotOverwriteOtherFiles) {
    write_suite();
    fs::create_directories(folder() / "report/pictures");
    write("report/notes.txt", "kept");
    refused({"suite", "run", "suite.json"}, {"report", "notes.txt", "\"report\""});
    fs::remove(folder() / "report/notes.txt");
    write("report/pictures/holiday.png", "kept");
    refused({"suite", "run", "suite.json"}, {"report", "pictures", "\"report\""});
    fs::remove_all(folder() / "report");
    fs::create_directories(folder() / "report");
    write("report/report.json", R"({"quarter": 3})");
    refused({"suite", "run", "suite.json"}, {"report.json", "\"report\""});
    refused({"suite", "merge", "suite.json", "elsewhere"}, {"elsewhere"});
    EXPECT_EQ(read("report/report.json"), R"({"quarter": 3})");
    EXPECT_FALSE(exists("references"));
    fs::remove(folder() / "report/report.json");
    expect(0, {"suite", "run", "suite.json", "--accept-new"});
    write("report/notes.txt", "a reader's, in a folder that is a report's");
    expect(0, {"suite", "run", "suite.json"});
}

TEST_F(SuiteCommand, OtherSamplesPassThePortableProfile) {
    const auto with = [&](int samples, const std::string& profile) {
        write("suite.json", R"({"suite": 1, "entries": [{"name": "opening", "samples": )" + std::to_string(samples) +
                                R"(, "profile": ")" + profile + "\"}]}");
        return run({"suite", "run", "suite.json"}).status;
    };
    EXPECT_EQ(with(0, "strict"), 1) << "new";
    EXPECT_EQ(with(4, "strict"), 1);
    EXPECT_EQ(with(4, "portable"), 0);
}

TEST_F(SuiteCommand, MistakesAreReportedInOneSentenceAndTouchNothing) {
    const auto is_refused = [&](const std::string& text, const std::vector<std::string>& words) {
        write("bad.json", text);
        refused({"suite", "run", "bad.json"}, words);
    };
    is_refused("{", {"bad.json"});
    is_refused(R"({"suite": 2, "entries": []})", {"bad.json: suite", "must be 1"});
    is_refused(R"({"suite": 1})", {"entries", "missing"});
    is_refused(R"({"suite": 1, "entries": []})", {"no entries"});
    is_refused(R"({"suite": 1, "entries": [{"name": "a", "veiw": "camera"}]})",
               {"entries[0].veiw", "did you mean", "view"});
    is_refused(R"({"suite": 1, "entries": [{"name": "a", "view": "cam"}]})", {"entries[0].view", "camera"});
    is_refused(R"({"suite": 1, "entries": [{"name": "a"}, {"name": "A"}]})", {"a", "A", "the same file name"});
    is_refused(R"({"suite": 1, "entries": [{"name": "a", "size": [0, 5]}]})", {"entries[0].size[0]"});
    is_refused(R"({"suite": 1, "entries": [{"name": "a", "samples": 8}]})", {"samples", "0"});
    is_refused(R"({"suite": 1, "entries": [{"name": "a", "state": {"projection": {"naer": 1}}}]})",
               {"entries[0].state", "projection.naer", "projection.near"});
    is_refused(R"({"suite": 1, "entries": [{"name": "a", "state": "opening", "lesson": "depth-fighting"}]})",
               {"more than one"});
    is_refused(R"({"suite": 1, "entries": [{"name": "a", "step": 2}]})", {"step", "needs \"lesson\""});
    is_refused(R"({"suite": 1, "entries": [{"name": "a", "measure": "fihgting"}]})", {"measure", "fighting"});
    is_refused(R"({"suite": 1, "entries": [{"name": "a", "measure": ["order", {"what": "order"}]}]})",
               {"entries[0].measure[1]", "twice"});
    is_refused(R"({"suite": 1, "entries": [{"name": "a"}], "loosened": [{"name": "b", "about": "x"}]})",
               {"loosened[0].name", "no entry"});
    is_refused(R"({"suite": 1, "entries": [{"name": "a"}], "loosened": [{"name": "a", "worst": 9}]})",
               {"loosened[0].about", "missing"});
    is_refused(R"({"suite": 1, "entries": [{"each": "preset", "name": "p"}]})", {"{}"});
    refused({"suite", "run", "nowhere"}, {"nowhere", "no such suite"});
    refused({"suite", "rnu", "bad.json"}, {"rnu", "run"});
    refused({"suite", "run"}, {"are required"});
    refused({"suite", "merge", "bad.json"}, {"bad.json"});
}

TEST_F(SuiteCommand, DescriptionsOfEntriesAreInTheReport) {
    write("suite.json", R"({"suite": 1, "defaults": {"size": [64, 36], "samples": 0}, "entries": [
        {"name": "opening", "about": "what all begins with"}, {"name": "room", "state": "room"}],
        "loosened": [{"name": "opening", "about": "noise", "worst": 3}]})");
    run({"suite", "run", "suite.json"});
    EXPECT_EQ(result("opening").at("about"), "what all begins with; noise");
    EXPECT_EQ(result("room").at("about"), "");
    EXPECT_TRUE(has(read("report/index.html"), "what all begins with; noise"));
    run({"suite", "merge", "suite.json", "report"});
    EXPECT_EQ(result("opening").at("about"), "what all begins with; noise");
}

TEST_F(SuiteCommand, AForeignSuiteMayNotReadEverything) {
    fs::create_directories(folder() / "inner");
    write("outside.json", R"({"objects": [{"name": "b", "shape": "box"}]})");
    write("inner/state.json", R"({"scene": "../outside.json"})");
    run({"suite", "run", "inner"});
    EXPECT_EQ(outcome("state", "inner/report"), "failed");
    run({"suite", "run", "inner", "--allow-outside"});
    EXPECT_EQ(outcome("state", "inner/report"), "new");
}

TEST_F(SuiteCommand, WriteErrorsAreReported) {
    write_suite();
    write("references", "a file where the folder should be");
    const Ended ended = run({"suite", "run", "suite.json"});
    EXPECT_EQ(ended.status, 2) << ended.told();
    EXPECT_TRUE(has(ended.err, "references")) << ended.err;
}

TEST_F(SuiteCommand, WithoutAContextEndsLikeEveryCommand) {
    write_suite();
    const Ended ended = run({"suite", "run", "suite.json", "--device", "99"});
    EXPECT_EQ(ended.status, 2) << ended.told();
    EXPECT_TRUE(has(ended.err, "--device")) << ended.err;
    EXPECT_FALSE(exists("report/report.json"));
}

}  // namespace
}  // namespace cli_tests
