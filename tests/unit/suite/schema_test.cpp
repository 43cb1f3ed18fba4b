// The JSON schema of a suite and its reader accept the same documents. The test gives random documents, valid and
// invalid, to both. It leaves out the rules that a schema cannot express: names that collide, a picture's pixels, and
// what an entry tests.
#include "suite/suite.h"

#include <gtest/gtest.h>

#include "agreement.h"
#include "platform/file.h"

namespace viewing {
namespace {

namespace fs = std::filesystem;

/// A key with valid and invalid values, as JSON.
struct Choices {
    const char* key;
    std::vector<const char*> right, wrong;
};

const std::vector<Choices> setting_choices{
    {"view", {"\"camera\"", "\"depth\"", "\"observer\""}, {"\"cam\"", "1", "null"}},
    {"size",
     {"[320, 240]", "[16384, 240]", "[640, 360]"},
     {"[0, 5]", "[5]", "[5, 5, 5]", "[16385, 1]", "[1.5, 2]", "\"5x5\""}},
    {"samples", {"0", "4", "\"state\""}, {"2", "\"4\"", "true"}},
    {"picture", {"true"}, {"1", "\"true\"", "null"}},
    {"profile", {"\"strict\"", "\"portable\""}, {"\"loose\"", "0"}},
    {"worst", {"0", "254"}, {"-1", "256", "1.5", "\"1\""}},
    {"share", {"0", "0.5"}, {"-0.1", "1.1", "\"0\""}},
    {"reach", {"0", "16"}, {"-1", "17"}},
    {"masks",
     {"[]", "[[0, 0, 1, 1]]", "[[16384, 16384, 16384, 16384], \"m.png\"]"},
     {"[[0, 0, 0, 1]]", "[[0, 0, 1, 0]]", "[[-1, 0, 1, 1]]", "[[0, 0, 5]]", "[[0, 0, 5, 5, 5]]", "[[0, 0, 16385, 1]]",
      "[[16385, 0, 1, 1]]", "[\"\"]", "[{}]", "{}", "[0, 0, 5, 5]"}},
    {"matrices", {"true", "false", "{}", "{\"tolerance\": 1e9}"}, {"{\"tolerance\": -1}", "{\"tol\": 1}", "0", "[]"}},
    {"measure",
     {"\"order\"", "[]", "[\"order\", {\"what\": \"mirror\", \"tolerance\": 0.5}]", "{\"what\": \"fighting\"}"},
     {"\"ordre\"", "{}", "{\"what\": 1}", "{\"what\": \"order\", \"tolerance\": -1}",
      "[\"order\", \"mirror\", \"fighting\", \"visibility\", \"order\"]"}},
    {"problems",
     {"{}", "{\"must\": [\"plane\"]}", "{\"must_not\": [\"a\"], \"none\": true}", "{\"must\": [], \"none\": true}"},
     {"{\"must\": [\"a\"], \"none\": true}", "{\"must\": [\"\"]}", "{\"must\": \"a\"}", "{\"no\": 1}", "[]"}}};

const Choices set_choices{"set", {"{}", "[]", "[\"a=1\"]"}, {"[\"a\"]", "[1]", "1", "[\"\"]"}};

const std::vector<Choices> entry_choices{
    {"about", {"\"why\""}, {"\"\"", "1", "\"a\\u0001\""}},
    {"state", {"\"opening\"", "{}", "{\"shadow\": {\"opacity\": 0.8}}"}, {"\"\"", "\"-\"", "1", "[]"}},
    {"lesson", {"\"lens\""}, {"\"\"", "{}"}},
    {"step", {"1", "1000"}, {"0", "1001", "1.5"}},
    {"revealed", {"true"}, {"1"}},
    {"present", {"false"}, {"\"\""}},
    {"exercise", {"\"E16\""}, {"16"}},
    {"course", {"\"c\""}, {"\"\""}},
    {"student", {"\"3\""}, {"3"}},
    {"veiw", {}, {"1"}}};

class Documents {
public:
    explicit Documents(unsigned seed) : random_(seed) {}

    std::string next() {
        std::string entries;
        const std::size_t count = 1 + random_() % 3;
        for (std::size_t i = 0; i < count; ++i) entries += (i == 0 ? "" : ", ") + entry(i);
        std::string text = R"({"suite": 1, "entries": [)" + entries + "]";
        if (one_in(3)) text += ", \"defaults\": {" + some_of(setting_choices, 3) + "}";
        if (one_in(8)) text += R"(, "loosened": [{"name": "e0", "about": "x", "share": 0.1}])";
        if (one_in(30)) text += R"(, "loosend": [])";
        return text + "}";
    }

private:
    bool one_in(unsigned n) { return random_() % n == 0; }

    std::string entry(std::size_t i) {
        std::string text = "{\"name\": \"e" + std::to_string(i) + (one_in(60) ? "\\u0007" : "") + "\"";
        for (const std::string& part : {some_of(entry_choices, 2), some_of(setting_choices, 2)})
            if (!part.empty()) text += ", " + part;
        // No schema can express which settings a lesson's step allows.
        if (!has(text, "lesson") && !has(text, "exercise") && one_in(3)) text += ", " + value_of(set_choices);
        return text + "}";
    }

    /// Returns up to `most` keys with their values, each key once.
    std::string some_of(const std::vector<Choices>& all, std::size_t most) {
        std::string text;
        for (std::size_t i = random_() % (most + 1); i > 0; --i) {
            const Choices& one = all[random_() % all.size()];
            if (has(text, "\"" + std::string(one.key) + "\":") || (one.right.empty() && !one_in(4))) continue;
            text += (text.empty() ? "" : ", ") + value_of(one);
        }
        return text;
    }

    std::string value_of(const Choices& one) {
        const auto& values = one.right.empty() || one_in(8) ? one.wrong : one.right;
        return "\"" + std::string(one.key) + "\": " + values[random_() % values.size()];
    }

    static bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

    std::mt19937 random_;
};

class SuiteSchema : public ::testing::Test {
protected:
    SuiteSchema() { fs::create_directories(folder_); }
    ~SuiteSchema() override { fs::remove_all(folder_); }
    std::string complaint(const std::string& text) const {
        std::ofstream(folder_ / "suite.json") << text;
        const Result<Suite> suite = load_suite((folder_ / "suite.json").string());
        return suite ? "" : suite.error();
    }
    const fs::path folder_ = fs::temp_directory_path() / ("suite-schema-" + std::to_string(::getpid()));
};

TEST_F(SuiteSchema, AcceptsWhatTheReaderAccepts) {
    if (!has_validator()) GTEST_SKIP() << no_validator;
    constexpr unsigned seed = 2024;
    constexpr std::size_t count = 600;
    std::cout << "seed " << seed << '\n';
    Documents documents(seed);
    std::vector<std::string> texts, sentences;
    for (std::size_t i = 0; i < count; ++i) {
        texts.push_back(documents.next());
        sentences.push_back(complaint(texts.back()));
    }
    const std::vector<bool> verdicts = judged(suite_schema(), texts);
    for (std::size_t i = 0; i < count; ++i)
        EXPECT_EQ(verdicts[i], sentences[i].empty()) << texts[i] << '\n' << sentences[i];
    const auto taken = std::count(verdicts.begin(), verdicts.end(), true);
    EXPECT_GT(taken, count / 5);
    EXPECT_LT(taken, count * 4 / 5);
}

/// Changes a document written here and golden/suite.json, the suite of the program's own pictures.
TEST_F(SuiteSchema, RefusesWhatTheReaderRefusesAfterOneChange) {
    if (!has_validator()) GTEST_SKIP() << no_validator;
    const fs::path golden = fs::path(std::getenv("TEST_SOURCE_DIR")) / "golden/suite.json";
    const Json written = Json::parse(R"({"suite": 1, "title": "Two", "references": "references", "report": "report",
        "defaults": {"size": [64, 36], "samples": 0, "worst": 3, "share": 0.002},
        "entries": [{"name": "opening", "about": "first", "masks": [[0, 0, 8, 8], "mask.png"]},
                    {"name": "own", "state": "state.json", "set": {"projection.near": 0.1}, "view": "depth"},
                    {"name": "written", "state": {"shadow": {"opacity": 0.8}}, "profile": "portable", "reach": 1},
                    {"name": "S", "state": "shadow-derivation", "picture": false, "matrices": {"tolerance": 1e-9}},
                    {"name": "order", "picture": false, "measure": {"what": "order", "tolerance": 0.02}},
                    {"name": "step", "lesson": "rays", "step": 2, "revealed": true, "size": [640, 360]},
                    {"name": "task", "exercise": "E16", "course": "c", "student": "1", "size": [640, 360]},
                    {"each": "mended", "name": "fixed-{}", "about": "all", "except": ["shadow-fights"]},
                    {"name": "said", "set": ["light.position=[1,0,0,1]"], "problems": {"must": ["plane"], "must_not": []}}],
        "loosened": [{"name": "own", "about": "noise", "share": 0.06}]})");
    // Only the reader checks that names exist or differ, that sizes fit, and that an entry tests something.
    const std::vector<std::string> only_reader{
        "there is no ", "the same file name", "tests nothing",          "cannot fail",           "twice",
        ": size: ",     "only ui.",           "must not be the folder", "must be another folder"};
    const auto reader = [&](const std::string& text) { return complaint(text); };
    expect_agreement(suite_schema(), {written}, 200, 2025, reader, only_reader);
    expect_agreement(suite_schema(), {parse_document(*read_text_file(golden), "")}, 15, 2026, reader, only_reader);
}

}  // namespace
}  // namespace viewing
