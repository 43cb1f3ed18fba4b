// The parts of a suite that need no GL: names, numbers, shards, workers that misbehave, and the parts of reports.
#include "suite/suite.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <fstream>
#include <numeric>
#include <random>
#include <set>

#include "platform/sanitized.h"
#include "suite/numbers_apart.h"
#include "suite/report.h"
#include "suite/suite_run.h"
#include "text/words.h"

namespace viewing {
namespace {

namespace fs = std::filesystem;

TEST(SafeFileName, IsReadableAndSafeEverywhere) {
    EXPECT_EQ(safe_file_name("shadow-w_2.1"), "shadow-w_2.1");
    EXPECT_EQ(safe_file_name("Shadow of a box/hard edge"), "Shadow-of-a-box-hard-edge");
    EXPECT_EQ(safe_file_name("a:b*c?"), "a%3Ab%2Ac%3F");
    EXPECT_EQ(safe_file_name("그림자"), "%EA%B7%B8%EB%A6%BC%EC%9E%90");
    EXPECT_EQ(safe_file_name("con"), "_con") << "a device on Windows";
    EXPECT_EQ(safe_file_name("COM1.x"), "_COM1.x");
    EXPECT_EQ(safe_file_name("communal"), "communal");
    EXPECT_EQ(safe_file_name("ends."), "ends_");
    EXPECT_EQ(safe_file_name(".hidden"), "%2Ehidden");
    EXPECT_EQ(safe_file_name("../../etc/passwd").find('/'), std::string::npos);
    EXPECT_LE(safe_file_name(std::string(1000, 'x')).size(), 150U);
}

TEST(NumbersApart, ListsPlacesBeyondTheTolerance) {
    const Json expected = Json::parse(R"({"S": [[4, 1], [0, -3]], "text": "a", "gone": 1, "big": 1e6})");
    const Json actual = Json::parse(R"({"S": [[4, 1.001], [0, -3]], "text": "b", "new": null, "big": 1000500})");
    const auto paths = [&](double tolerance) {
        std::vector<std::string> found;
        for (const NumberChange& change : numbers_apart(expected, actual, tolerance)) found.push_back(change.path);
        return found;
    };
    EXPECT_EQ(paths(0.0), (std::vector<std::string>{"S[0][1]", "text", "gone", "big"}));
    EXPECT_EQ(paths(0.0006), (std::vector<std::string>{"S[0][1]", "text", "gone"})) << "a share of 1e6";
    EXPECT_EQ(paths(0.0011), (std::vector<std::string>{"text", "gone"}));
    EXPECT_TRUE(numbers_apart(expected, expected, 0.0).empty());
    EXPECT_EQ(numbers_apart(Json::parse("[1, 2]"), Json::parse("[1]"), 0.0).front().path, "[1]");
    EXPECT_EQ(numbers_apart(Json::parse("[1]"), Json::parse("[null]"), 1e9).size(), 1U);
    EXPECT_EQ(numbers_apart(Json(std::vector<int>(900, 1)), Json(std::vector<int>(900, 2)), 0.0, 7).size(), 7U);
}

Suite suite_of(int count) {
    Suite suite;
    suite.name = "made";
    for (int i = 0; i < count; ++i) {
        SuiteEntry entry;
        entry.name = entry.file_name = "e" + std::to_string(i);
        suite.entries.push_back(entry);
    }
    return suite;
}

TEST(Shards, HaveEachEntryOnceAndEqualTimes) {
    constexpr unsigned seed = 1609;
    std::mt19937 random(seed);
    std::cout << "seed " << seed << '\n';
    for (int trial = 0; trial < 50; ++trial) {
        const int count = static_cast<int>(random() % 60 + 1), of = static_cast<int>(random() % 7 + 1);
        const Suite suite = suite_of(count);
        std::map<std::string, double> seconds;
        double longest = 0.0, all = 0.0;
        for (const SuiteEntry& entry : suite.entries) {
            seconds[entry.name] = static_cast<double>(random() % 1000 + 1) / 100.0;
            longest = std::max(longest, seconds[entry.name]);
            all += seconds[entry.name];
        }
        std::multiset<std::size_t> seen;
        for (int shard = 1; shard <= of; ++shard) {
            double load = 0.0;
            for (const std::size_t entry : entries_of_shard(suite, shard, of, seconds)) {
                seen.insert(entry);
                load += seconds[suite.entries[entry].name];
            }
            EXPECT_LE(load, all / of + longest) << "no shard is longer than its share and one entry";
        }
        ASSERT_EQ(seen.size(), static_cast<std::size_t>(count));
        EXPECT_EQ(std::set<std::size_t>(seen.begin(), seen.end()).size(), seen.size());
    }
}

/// Provides a script that plays the worker: it reads "entry": N and behaves as N says.
class Workers : public ::testing::Test {
protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() / ("suite-worker-" + std::to_string(::getpid()));
        fs::create_directories(folder_);
        std::ofstream(folder_ / "worker") << R"(#!/bin/sh
echo '{"renderer": "made"}'
while read -r line; do
    n=${line#*entry\":}; n=${n%%,*}
    case $n in
        3) kill -SEGV $$;;
        5) sleep 60;;
        7) echo 'no JSON at all';;
        9) echo 'it hurts' >&2; exit 9;;
        *) echo "trouble $n" >&2; sleep 0.02
           echo "{\"name\": \"e$n\", \"file\": \"e$n\", \"outcome\": \"passed\", \"key\": \"\", \"output\": \"\"}";;
    esac
done
)";
        ::chmod((folder_ / "worker").c_str(), 0755);
    }
    void TearDown() override { fs::remove_all(folder_); }

    RunWish wish(int count) const {
        RunWish wish;
        wish.worker = {(folder_ / "worker").string()};
        wish.entry_timeout_s = 4.0;  // also the limit for the start of a worker
        for (int i = 0; i < count; ++i) wish.chosen.push_back(static_cast<std::size_t>(i));
        return wish;
    }
    fs::path folder_;
};

TEST_F(Workers, ThatCrashHangOrBabbleFailOnlyTheirEntry) {
    for (const int jobs : {1, 3}) {
        const Suite suite = suite_of(12);
        RunWish wanted = wish(12);
        wanted.jobs = jobs;
        std::size_t told = 0;
        wanted.tell = [&](const EntryResult&, std::size_t done) { EXPECT_EQ(done, ++told); };
        const GatheredResults results = run_entries(suite, wanted);
        ASSERT_FALSE(results.failure);
        ASSERT_EQ(results.entries.size(), 12U);
        EXPECT_EQ(results.renderer, "made");
        for (std::size_t i = 0; i < 12; ++i) {
            const EntryResult& entry = results.entries[i];
            EXPECT_EQ(entry.name, "e" + std::to_string(i));
            const bool fails = i == 3 || i == 5 || i == 7 || i == 9;
            EXPECT_EQ(entry.outcome, fails ? Outcome::failed : Outcome::passed) << i;
            if (!fails) {
                EXPECT_EQ(entry.output, "trouble " + std::to_string(i) + "\n");
            }
        }
        EXPECT_EQ(results.entries[3].reasons.front(), "the program crashed: signal 11 (Segmentation fault)");
        EXPECT_EQ(results.entries[5].reasons.front(), "not finished within 4 s");
        EXPECT_NE(results.entries[7].reasons.front().find("no JSON at all"), std::string::npos);
        EXPECT_EQ(results.entries[9].reasons.front(), "the program crashed: exit status 9");
        EXPECT_EQ(results.entries[9].output, "it hurts\n");
    }
}

TEST_F(Workers, ThatCannotStartEndTheRun) {
    std::ofstream(folder_ / "worker") << "#!/bin/sh\necho 'no OpenGL here' >&2\nexit 3\n";
    const Suite suite = suite_of(2);
    const GatheredResults results = run_entries(suite, wish(2));
    ASSERT_TRUE(results.failure);
    EXPECT_EQ(results.failure->exit_status, 3);
    EXPECT_EQ(results.failure->complaint, "no OpenGL here\n");

    RunWish nobody = wish(2);
    nobody.worker = {(folder_ / "nobody").string()};
    nobody.entry_timeout_s = 3600.0;  // far longer than the test waits
    const GatheredResults none = run_entries(suite, nobody);
    ASSERT_TRUE(none.failure);
    EXPECT_NE(none.failure->complaint.find("cannot be started"), std::string::npos) << none.failure->complaint;
}

RunResult made_run() {
    RunResult run{"A <b> & \"c\"", "suite.json", "1.2.3", "made", 1, 1, 1.5, {}};
    EntryResult bad;
    bad.name = "</script><script>alert(1)</script>";
    bad.file_name = safe_file_name(bad.name);
    bad.outcome = Outcome::different;
    bad.reasons = {"a < b", "second \x01 line"};
    bad.output = "]]>";
    EntryResult good;
    good.name = good.file_name = "good";
    good.outcome = Outcome::passed;
    run.entries = {bad, good};
    return run;
}

TEST(Report, PageEscapesForeignTexts) {
    const std::string page = report_page(made_run());
    EXPECT_EQ(page.find("{{"), std::string::npos) << "a placeholder is not filled in";
    EXPECT_EQ(page.find("<script>alert"), std::string::npos);
    EXPECT_NE(page.find("A &lt;b&gt; &amp; &quot;c&quot;"), std::string::npos);
    EXPECT_EQ(page.find("http"), std::string::npos) << "no network";
}

TEST(Report, JunitCountsAndEscapes) {
    const std::string xml = junit_of(made_run());
    EXPECT_NE(xml.find("tests=\"2\" failures=\"1\" errors=\"0\""), std::string::npos) << xml;
    EXPECT_NE(xml.find("message=\"a &lt; b\""), std::string::npos) << xml;
    EXPECT_EQ(xml.find('\x01'), std::string::npos);
    EXPECT_NE(xml.find("<system-err>]]&gt;</system-err>"), std::string::npos) << xml;
}

TEST(Report, JunitContainsNothingThatXmlForbids) {
    RunResult run = made_run();
    run.entries.front().name = "a\xef\xbf\xbe b\xff";  // U+FFFE, and an invalid UTF-8 byte
    run.entries.front().output = "first\n\x1b[31m\xe2\x80\xaesecond";
    const std::string xml = junit_of(run);
    EXPECT_TRUE(is_utf8(xml));
    EXPECT_EQ(xml.find("\xef\xbf\xbe"), std::string::npos);
    EXPECT_EQ(xml.find('\x1b'), std::string::npos);
    EXPECT_NE(xml.find("<system-err>first\n\\u001b[31m\\u202esecond</system-err>"), std::string::npos) << xml;
}

TEST(Report, OfManyEntriesIsAlsoReadBack) {
    const fs::path folder = fs::temp_directory_path() / ("suite-many-" + std::to_string(::getpid()));
    fs::create_directories(folder);
    RunResult run = made_run();
    constexpr std::size_t count = is_sanitized ? 1'000 : 9'000;
    run.entries.assign(count, EntryResult(run.entries.back()));
    for (EntryResult& entry : run.entries) entry.output = std::string(2'000, 'x');
    ASSERT_TRUE(write_report(folder, run));
    EXPECT_GT(fs::file_size(folder / "report.json"), (is_sanitized ? 1U : 16U) << 20U);
    const Result<RunResult> again = read_run(folder);
    fs::remove_all(folder);
    ASSERT_TRUE(again) << again.error();
    EXPECT_EQ(again->entries.size(), count);
}

class SuiteFiles : public ::testing::Test {
protected:
    SuiteFiles() { fs::create_directories(folder); }
    ~SuiteFiles() override { fs::remove_all(folder); }
    std::string refusal_of(const std::string& text) const {
        std::ofstream(folder / "suite.json") << text;
        const Result<Suite> suite = load_suite((folder / "suite.json").string());
        return suite ? "" : suite.error().substr(folder.string().size() + 1);
    }
    static std::string repeated(const std::string& first, int count) {
        std::string all = first;
        for (int i = 1; i < count; ++i) all += "," + first;
        return all;
    }
    const fs::path folder = fs::temp_directory_path() / ("suite-files-" + std::to_string(::getpid()));
};

class SuiteFilesSlowTest : public SuiteFiles {};

/// Small files that would expand too much are refused before they are expanded.
TEST_F(SuiteFilesSlowTest, ThatExpandTooMuchAreRefused) {
    const std::string too_much =
        "suite.json: entries: have more than 128 MiB of settings, masks and texts, including the defaults";
    const std::string entries = "\"entries\":[" + repeated(R"({"name":"a"})", 3000) + "]";
    const std::string set = "\"defaults\":{\"set\":[" + repeated(R"("projection.near=0.5")", 1000) + "]}";
    EXPECT_EQ(refusal_of("{\"suite\":1," + set + "," + entries + "}"), too_much);
    // More than 128 MiB of rectangles, then of sentences.
    const std::string masks = "\"defaults\":{\"masks\":[" + repeated("[0,0,9,9]", 1000) + "]}";
    EXPECT_EQ(refusal_of("{\"suite\":1," + masks + ",\"entries\":[" + repeated(R"({"name":"a"})", 10'000) + "]}"),
              too_much);
    const std::string sentences =
        "\"defaults\":{\"problems\":{\"must\":[" + repeated("\"" + std::string(1000, 'x') + "\"", 64) + "]}}";
    EXPECT_EQ(refusal_of("{\"suite\":1," + sentences + "," + entries + "}"), too_much);
    EXPECT_EQ(refusal_of("{\"suite\":1,\"entries\":[" + repeated(R"({"each":"preset","name":"{}"})", 5000) + "]}"),
              "suite.json: entries: are more than 100000, counting all those of \"each\"");
}

TEST_F(SuiteFiles, WithNamesThatAreNotUtf8AreRefusedAsAFolder) {
    std::ofstream(folder / "b\xff.json") << "{}";
    const Result<Suite> suite = load_suite(folder.string());
    ASSERT_FALSE(suite);
    EXPECT_NE(suite.error().find("b\\xff.json: the file name is not UTF-8"), std::string::npos) << suite.error();
}

TEST(Report, ReadsBackWhatItWrote) {
    const fs::path folder = fs::temp_directory_path() / ("suite-report-" + std::to_string(::getpid()));
    fs::create_directories(folder);
    const RunResult run = made_run();
    ASSERT_TRUE(write_report(folder, run));
    const Result<RunResult> again = read_run(folder);
    ASSERT_TRUE(again) << again.error();
    EXPECT_EQ(as_json(*again), as_json(run));
    fs::remove_all(folder);
    EXPECT_FALSE(read_run(folder));
}

}  // namespace
}  // namespace viewing
