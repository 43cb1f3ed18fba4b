// The JSON schema of a suite and its reader accept the same documents. The test gives random documents, valid and
// invalid, to both. It leaves out the rules that a schema cannot express: names that collide, a picture's pixels, and
// what an entry tests.
#include "suite/schema.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <random>
#include <string>
#include <vector>

#include "state/file/document.h"
#include "suite/suite.h"

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

TEST(SuiteSchema, AcceptsWhatTheReaderAccepts) {
    if (std::system("/usr/bin/python3 -c 'from jsonschema import Draft202012Validator' 2>/dev/null") != 0)
        GTEST_SKIP() << "no validator: Debian's package python3-jsonschema has it";
    const fs::path folder = fs::temp_directory_path() / ("suite-schema-" + std::to_string(::getpid()));
    fs::create_directories(folder);
    std::ofstream(folder / "schema.json") << suite_schema();
    constexpr unsigned seed = 2024;
    constexpr int count = 600;
    std::cout << "seed " << seed << '\n';
    Documents documents(seed);
    std::vector<std::string> texts, sentences;
    std::ofstream list(folder / "documents");
    for (int i = 0; i < count; ++i) {
        texts.push_back(documents.next());
        list << texts.back() << '\n';
        std::ofstream(folder / "suite.json") << texts.back();
        const Result<Suite> suite = load_suite((folder / "suite.json").string());
        sentences.push_back(suite ? "" : suite.error());
    }
    list.close();
    std::ofstream(folder / "judge.py") << R"(
import json, jsonschema
validator = jsonschema.Draft202012Validator(json.load(open("schema.json")))
for line in open("documents"): print("yes" if validator.is_valid(json.loads(line)) else "no")
)";
    const std::string command = "cd '" + folder.string() + "' && /usr/bin/python3 judge.py > judged";
    ASSERT_EQ(std::system(command.c_str()), 0);
    std::ifstream judged(folder / "judged");
    int taken = 0;
    for (int i = 0; i < count; ++i) {
        std::string verdict;
        judged >> verdict;
        const auto place = static_cast<std::size_t>(i);
        EXPECT_EQ(verdict, sentences[place].empty() ? "yes" : "no") << texts[place] << '\n' << sentences[place];
        taken += verdict == "yes" ? 1 : 0;
    }
    EXPECT_GT(taken, count / 5);
    EXPECT_LT(taken, count * 4 / 5);
    fs::remove_all(folder);
}

}  // namespace
}  // namespace viewing
