// Exercises on the command line: listing them, making a student's sheet, testing exercises, and drawing an exercise as
// a picture.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <set>

#include "cli/program.h"

namespace cli_tests {
namespace {

class ExercisesCommand : public Program {};

bool has_hangul(const std::string& text) {
    return std::any_of(text.begin(), text.end(), [](char c) {
        return static_cast<unsigned char>(c) >= 0xea && static_cast<unsigned char>(c) <= 0xed;
    });
}

/// Returns an exercise that asks for z-far, which is 40, and that lists `wrong` as a wrong answer.
std::string exercise_with(const std::string& wrong, const std::string& near_list = "[0.5, 0.7]") {
    return R"({"exercise": 1, "id": "N01-far", "title": "Far", "sets": ["camera"], "points": 2,
        "tags": {"T10": "ten"}, "pick": {"n": )" +
           near_list + R"(},
        "step": {"state": {"set": {"projection.near": "=n"}},
                 "ask": {"kind": "number", "question": "z-near is {n}. Where is z-far?", "expect": "=projection.far",
                         "tol": 0.1, "wrong": [{"value": )" +
           wrong + R"(, "tag": "T10", "say": "That is ten."}]}}})";
}

// ---- the list ------------------------------------------------------------------------------------------------------

TEST_F(ExercisesCommand, ListsExercisesWithTheirPoints) {
    const std::vector<std::string> lines = lines_of(expect(0, {"exercises"}).out);
    ASSERT_EQ(lines.size(), 27U);
    EXPECT_EQ(lines.back(), "26 exercises, 53 points");
    for (std::size_t i = 0; i < 24; ++i) {
        const std::string id = "E" + std::to_string(101 + i).substr(1) + "-";
        EXPECT_EQ(lines[i].find(id), 0U) << lines[i];
        EXPECT_TRUE(has(lines[i], " variants)")) << lines[i];
    }
}

TEST_F(ExercisesCommand, ListsASetOrNamedExercises) {
    std::vector<std::string> lines = lines_of(expect(0, {"exercises", "--set", "shadow"}).out);
    std::set<std::string> found;
    for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
        found.insert(lines[i].substr(0, 3));
        EXPECT_TRUE(has(lines[i], "(shadow; ")) << lines[i];
    }
    EXPECT_EQ(found, (std::set<std::string>{"E16", "E17", "E18", "E19", "E20", "E25", "E26"}));
    lines = lines_of(expect(0, {"exercises", "--set", "E01,E16"}).out);
    ASSERT_EQ(lines.size(), 3U);
    EXPECT_EQ(lines[0].find("E01-view-matrix — The view matrix"), 0U) << lines[0];
    EXPECT_EQ(lines[1].find("E16-shadow-matrix — "), 0U) << lines[1];
    EXPECT_EQ(lines[2], "2 exercises, 6 points");
    std::set<std::string> all;
    for (const char* const set : {"camera", "hidden", "depth", "shadow", "mirror"}) {
        lines = lines_of(expect(0, {"exercises", "--set", set}).out);
        EXPECT_GT(lines.size(), 1U);
        for (std::size_t i = 0; i + 1 < lines.size(); ++i) all.insert(lines[i].substr(0, 3));
    }
    EXPECT_EQ(all.size(), 26U) << "each exercise belongs to one or more sets";
}

TEST_F(ExercisesCommand, AnUnknownSetSuggestsTheNearest) {
    refused({"exercises", "--set", "shadwo"},
            {"\"shadwo\"", "camera, hidden, depth, shadow, mirror", "did you mean shadow?"});
    refused({"exercises", "--set", "E01,E99"}, {"\"E99\""});
    refused({"exercises", "--set", "E01,"}, {"neither a set"});
    refused({"exercises", "--student", "1", "--set", "nothing"}, {"\"nothing\""});
}

// ---- a student's sheet ---------------------------------------------------------------------------------------------

TEST_F(ExercisesCommand, ASheetIsReproducibleAndIndividual) {
    const auto sheet = [&](const std::string& student, const std::string& course) {
        return expect(0, {"exercises", "--student", student, "--course", course}).out;
    };
    const std::string first = sheet("32201234", "viewing-2026");
    EXPECT_EQ(sheet("32201234", "viewing-2026"), first);
    EXPECT_NE(sheet("32201235", "viewing-2026"), first);
    EXPECT_NE(sheet("32201234", "viewing-2027"), first);
    int questions = 0;
    for (const std::string& line : lines_of(first)) questions += line[0] == 'E' && has(line, " · ") ? 1 : 0;
    EXPECT_EQ(questions, 26);
    EXPECT_FALSE(has(first, "→ ")) << "no answers";
    EXPECT_FALSE(has(first, "{")) << "every place is filled";
}

TEST_F(ExercisesCommand, VariantsMatchAnIndependentComputation) {
    const nlohmann::json sheet = expect(0, {"exercises", "--student", "32201234", "--course", "viewing-2026", "--set",
                                            "E16,E01", "--format", "json"})
                                     .json();
    EXPECT_EQ(sheet["student"], "32201234");
    EXPECT_EQ(sheet["course"], "viewing-2026");
    ASSERT_EQ(sheet["exercises"].size(), 2U);
    EXPECT_EQ(sheet["exercises"][0]["exercise"], "E16-shadow-matrix");
    EXPECT_EQ(sheet["exercises"][0]["variant"], 8);
    EXPECT_EQ(sheet["exercises"][0]["values"], nlohmann::json::parse(R"({"P": [0, 1, 0, 0], "L": [-1, 4, 3, 1]})"))
        << "the ninth of its deployed variants";
    EXPECT_EQ(sheet["exercises"][0]["points"], 3);
    EXPECT_EQ(
        sheet["exercises"][0]["question"],
        "The plane is (0, 1, 0, 0), the light (−1, 4, 3, 1). Enter the shadow matrix S, each number to four digits. "
        "(Any nonzero multiple is the same map.)");
    EXPECT_EQ(sheet["exercises"][1]["variant"], 12);
    EXPECT_FALSE(sheet["exercises"][0].contains("solution"));
}

TEST_F(ExercisesCommand, SolutionsAreForTheLecturer) {
    const nlohmann::json sheet =
        expect(0, {"exercises", "--student", "32201234", "--course", "viewing-2026", "--solutions", "--format", "json"})
            .json();
    ASSERT_EQ(sheet["exercises"].size(), 26U);
    for (const nlohmann::json& question : sheet["exercises"])
        EXPECT_FALSE(question["solution"].get<std::string>().empty()) << question;
    // P = (0, 1, 0, 0), L = (−1, 4, 3, 1): S = (P·L) I − L Pᵀ, computed by hand.
    const std::string by_hand = "4, 1, 0, 0; 0, 0, 0, 0; 0, −3, 4, 0; 0, −1, 0, 4";
    EXPECT_EQ(sheet["exercises"][15]["solution"], by_hand);
    EXPECT_EQ(sheet["exercises"][10]["solution"], "626") << "a code is a whole number";
    const std::string text =
        expect(0, {"exercises", "--student", "32201234", "--course", "viewing-2026", "--solutions"}).out;
    std::size_t arrows = 0;
    for (const std::string& line : lines_of(text)) arrows += line.find("  → ") == 0 ? 1U : 0U;
    EXPECT_EQ(arrows, 26U);
}

TEST_F(ExercisesCommand, ASheetCanBeInKorean) {
    const nlohmann::json korean =
        expect(0, {"exercises", "--student", "1", "--language", "ko", "--format", "json"}).json();
    const nlohmann::json english = expect(0, {"exercises", "--student", "1", "--format", "json"}).json();
    ASSERT_EQ(korean["exercises"].size(), 26U);
    for (std::size_t i = 0; i < 24; ++i) {
        const std::string question = korean["exercises"][i]["question"];
        EXPECT_TRUE(has_hangul(question)) << question;
        EXPECT_FALSE(has_hangul(english["exercises"][i]["question"])) << english["exercises"][i];
        EXPECT_EQ(korean["exercises"][i]["values"], english["exercises"][i]["values"]);
    }
    refused({"exercises", "--student", "1", "--language", "kr"}, {"--language", "ko"});
}

TEST_F(ExercisesCommand, IncompatibleOptionsAreRefused) {
    const std::vector<std::string> one_of{"only one of --student, --test and --deploy"};
    refused({"exercises", "--student", "1", "--test"}, one_of);
    refused({"exercises", "--student", "1", "--deploy"}, one_of);
    refused({"exercises", "--test", "--deploy"}, one_of);
    refused({"exercises", "--solutions"}, {"need --student"});
    refused({"exercises", "--course", "cg"}, {"need --student"});
    refused({"exercises", "--test", "--format", "json"}, {"need --student"});
    refused({"exercises", "--student", "1", "--format", "xml"}, {"--format", "json"});
    refused({"exercises", "--deploy"}, {"--deploy needs FILE"});
    refused({"exercises", "nowhere.json"}, {"nowhere.json"});
}

TEST_F(ExercisesCommand, AStudentMayHaveAnyName) {
    for (const char* const student : {"", "한국", "../../x", "a|b", "%s%n"}) {
        const nlohmann::json sheet =
            expect(0, {"exercises", "--student", student, "--set", "E16", "--format", "json"}).json();
        EXPECT_EQ(sheet["student"], student);
    }
    expect(0, {"exercises", "--student", std::string(5000, 'x'), "--set", "E16"});
    EXPECT_EQ(files(), 0U);
}

// ---- custom exercises ----------------------------------------------------------------------------------------------

TEST_F(ExercisesCommand, AWrongAnswerThatIsRightFailsTheTest) {
    write("mine.json", exercise_with("10"));
    EXPECT_TRUE(has(expect(0, {"exercises", "mine.json", "--test"}).out,
                    "2 variants: right answers accepted, wrong ones refused and distinguished"));
    write("mine.json", exercise_with("40"));
    const Ended failed = expect(1, {"exercises", "mine.json", "--test"});
    EXPECT_TRUE(has(failed.out, "N01-far, step variant 0: ask.wrong[0] is accepted as right\n")) << failed.told();
    EXPECT_TRUE(has(failed.out, "N01-far, step variant 1: ask.wrong[0] is accepted as right\n")) << failed.told();
    EXPECT_TRUE(has(failed.err, "2 variants fail")) << failed.told();
    EXPECT_FALSE(has(failed.out, "2 wrong answers distinguished")) << failed.told();
    write("mine.json", exercise_with("\"=80 * n\""));  // 40 only for n = 0.5
    EXPECT_TRUE(has(expect(1, {"exercises", "mine.json", "--test"}).err, "1 variant fails"));
}

TEST_F(ExercisesCommand, SomeShippedExercisesPassTheirTest) {
    const std::string told = expect(0, {"exercises", "--set", "E16,E18", "--test"}).out;
    EXPECT_TRUE(has(told, "E16-shadow-matrix: 16 deployed")) << told;
    EXPECT_TRUE(has(told, "32 variants: right answers accepted")) << told;
}

TEST_F(ExercisesCommand, ABrokenFileIsReportedInOneSentence) {
    write("mine.json", exercise_with("10", "[]"));
    refused({"exercises", "mine.json"}, {"mine.json: pick.n: must have at least one value"});
    write("mine.json", "{");
    refused({"exercises", "mine.json", "--test"}, {"mine.json: "});
    write("mine.json", exercise_with("10", "[{}]"));
    refused({"exercises", "mine.json", "--student", "1"}, {"mine.json: variant 0: state.set.projection.near: "});
    std::filesystem::create_directory(folder() / "none");
    refused({"exercises", "none"}, {"the folder contains no .json file"});
    write("a.json", exercise_with("10"));
    write("b.json", exercise_with("11"));
    refused({"exercises", "a.json", "b.json"}, {"b.json: a.json also has the id \"N01-far\""});
}

TEST_F(ExercisesCommand, ErrorsInExpressionsNameFileAndField) {
    const std::string own = exercise_with("10");
    const std::size_t at = own.find("\"=n\"");
    const auto told = [&](const std::string& expression) {
        write("mine.json", std::string(own).replace(at, 4, "\"=" + expression + "\""));
        return expect(2, {"exercises", "mine.json", "--student", "1"}, {.limits = {{RLIMIT_CPU, 10}}}).err;
    };
    const std::string field = "mine.json: variant 0: state.set.projection.near: ";
    EXPECT_TRUE(has(told("\\\"\\\\xff\\\""), field + "its value \\xff is not valid UTF-8"));
    EXPECT_TRUE(has(told("(--'\\n(function() return 1 end)() --'\\n)"), field + "function is not allowed"));
}

TEST_F(ExercisesCommand, AVariantMeasuresAtMostSixtyFourDistinctValues) {
    const auto sheet = [&](int status, int values) {
        std::string places;
        for (int i = 0; i < values; ++i) places += "{pixel(" + std::to_string(i) + ", 0).stencil}";
        std::string own = exercise_with("10");
        const std::string question = "z-near is {n}.";
        write("mine.json", own.replace(own.find(question), question.size(), places + "{pixel(0, 0).stencil}"));
        return expect(status, {"exercises", "mine.json", "--student", "1"});
    };
    EXPECT_TRUE(has(sheet(0, 64).out, std::string(65, '0')));
    EXPECT_TRUE(has(sheet(2, 65).err, "pixel exceeds the limit of 64 different measured values")) << sheet(2, 65).err;
}

TEST_F(ExercisesCommand, DeployedVariantsKeepTheSheets) {
    write("mine.json", exercise_with("10",
                                     "[0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1, 1.1, 1.2, 1.3, 1.4, 1.5, 1.6, "
                                     "1.7, 1.8, 1.9, 2]"));
    const auto sheets = [&] {
        std::string all;
        for (const char* const student : {"1", "2", "3", "4"})
            all += expect(0, {"exercises", "mine.json", "--student", student, "--format", "json"}).out;
        return all;
    };
    const std::string before = sheets();
    const std::string deployed = expect(0, {"exercises", "mine.json", "--deploy"}).out;
    const nlohmann::json parsed = nlohmann::json::parse("{" + deployed + "}");
    ASSERT_EQ(parsed["deployed"].size(), 16U);
    EXPECT_EQ(std::set<nlohmann::json>(parsed["deployed"].begin(), parsed["deployed"].end()).size(), 16U);
    // A different list of values changes the sheets, unless the file lists the deployed variants.
    const std::string other = exercise_with("10", "[3, 4]");
    write("mine.json", other);
    EXPECT_NE(sheets(), before);
    write("mine.json", "{" + deployed + "," + other.substr(1));
    EXPECT_EQ(sheets(), before);
}

// ---- pictures ------------------------------------------------------------------------------------------------------

TEST_F(ExercisesCommand, DrawsTheBeginningOrTheEndOfAnExercise) {
    const auto draw = [&](std::vector<std::string> what, const std::string& file) {
        what.insert(what.begin(), "snapshot");
        what.insert(what.end(), {"--exercise", "E18", "--view", "camera", "--size", "320x180", "-o", file});
        expect(0, what);
    };
    draw({"--student", "1"}, "begins.png");
    draw({"--student", "1"}, "again.png");
    EXPECT_EQ(read("begins.png"), read("again.png"));
    const std::string head = R"({"answers": 1, "course": "", "student": "1", "items": [)";
    write("nothing.json", head + "]}");
    draw({"nothing.json"}, "nothing.png");
    EXPECT_EQ(read("nothing.png"), read("begins.png"));
    write("moved.json", head + R"({"exercise": "E18-place-the-light", "variant": 0, "attempts": [
        {"set": {"light.position": [0, 9, 0, 1]}}, {"hint": 1}, {"set": {"light.position": [-3, 6, 3, 1]}}]}]})");
    draw({"moved.json"}, "moved.png");
    EXPECT_NE(read("moved.png"), read("begins.png"));
    write("back.json", head + R"({"exercise": "E18-place-the-light", "variant": 0, "attempts": [
        {"set": {"light.position": [-3, 6, 3, 1]}}, {"set": {}}]}]})");
    draw({"back.json"}, "back.png");
    EXPECT_EQ(read("back.png"), read("begins.png")) << "the latest attempt counts";
}

TEST_F(ExercisesCommand, OpensAWindowWithTheQuestion) {
    expect(0, {"snapshot", "--exercise", "E16", "--student", "1", "--size", "640x480", "-o", "one.png"});
    expect(0, {"snapshot", "--exercise", "E16", "--student", "2", "--size", "640x480", "-o", "two.png"});
    EXPECT_NE(read("one.png"), read("two.png"));
}

TEST_F(ExercisesCommand, APictureOfAnUnknownExerciseIsRefused) {
    const auto picture = [&](std::vector<std::string> what, const std::vector<std::string>& words) {
        what.insert(what.begin(), "snapshot");
        what.insert(what.end(), {"--view", "camera", "--size", "320x180", "-o", "x.png"});
        refused(what, words);
    };
    picture({"--exercise", "E99", "--student", "1"}, {"\"E99\""});
    picture({"--exercise", "E18-place-the-lihgt", "--student", "1"}, {"E18-place-the-lihgt"});
    picture({"--exercise", "shadow", "--student", "1"}, {"must name one exercise"});
    picture({"--student", "1"}, {"need --exercise"});
    picture({"--exercise", "E18", "nowhere.json"}, {"nowhere.json"});
    write("a.json", R"({"answers": 1, "student": "1", "items": [{"exercise": "E18-place-the-light", "variant": 0,
        "attempts": [{"set": {"camera.yaw": 9}}]}]})");
    picture({"--exercise", "E18", "a.json"}, {"camera.yaw"});
    picture({"--exercise", "E18", "a.json", "--student", "1"}, {"cannot be given with a hand-in"});
    write("b.json", R"({"answers": 1, "student": "1", "items": [{"exercise": "E18-place-the-light", "variant": 0,
        "attempts": [{"set": {"light.position": "up"}}]}]})");
    picture({"--exercise", "E18", "b.json"}, {"light.position"});
    picture({"--exercise", "E18", "--lesson", "lens"}, {"--lesson"});
    picture({"--exercise", "", "--student", "1"}, {"--exercise"});
}

}  // namespace
}  // namespace cli_tests
