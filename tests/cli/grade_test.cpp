// Hand-ins on the command line: right answers, the effect of a broken file, and the formats of the result.
#include <gtest/gtest.h>

#include <algorithm>

#include "cli/program.h"

namespace cli_tests {
namespace {

namespace fs = std::filesystem;

constexpr const char* far_exercise =
    R"({"exercise": 1, "id": "N01-far", "title": "Far", "sets": ["camera"], "points": 2,
    "tags": {"T10": "ten, not forty"}, "pick": {"n": [0.5, 0.7]},
    "step": {"state": {"set": {"projection.near": "=n"}},
             "ask": {"kind": "number", "question": "z-near is {n}. Where is z-far?", "expect": "=projection.far",
                     "tol": 0.1, "hints": ["Look at P."],
                     "wrong": [{"value": 10, "tag": "T10", "say": "That is ten."}]}}})";

constexpr const char* shadow_exercise =
    R"json({"exercise": 1, "id": "M02-shadow", "title": "The shadow matrix",
    "sets": ["shadow"], "points": 3, "tags": {"M33": "rows and columns"}, "pick": {"L": [[1, 4, 1, 1]]},
    "step": {"state": {"set": {"light.position": "=L"}},
             "ask": {"kind": "matrix", "question": "L = {L}. Type S.", "expect": "=S", "up_to_factor": true, "shows_as": "overrides.shadow_from_world",
                     "tol": 0.01, "wrong": [{"value": "=transpose(S)", "tag": "M33", "say": "Rows are columns."}]}}})json";

constexpr const char* near_exercise =
    R"({"exercise": 1, "id": "G03-near", "title": "Near", "sets": ["camera"],
    "points": 2, "pick": {"n": [1]},
    "step": {"state": {"set": {"projection.near": "=n"}},
             "ask": {"kind": "goal", "question": "Bring z-near to 0.2 or less.", "until": "projection.near <= 0.2",
                     "allow": ["projection.near"], "model": {"projection.near": 0.1},
                     "wrong": [{"when": "projection.near < 1", "try": {"projection.near": 0.6}, "points": 1,
                                "say": "Nearer than that."}]}}})";

// For the plane y = 0 and the light (1, 4, 1, 1): S = (P·L) I − L Pᵀ.
constexpr const char* shadow_matrix = "[[4, -1, 0, 0], [0, 0, 0, 0], [0, -1, 4, 0], [0, -1, 0, 4]]";
constexpr const char* transposed_matrix = "[[4, 0, 0, 0], [-1, 0, -1, -1], [0, 0, 4, 0], [0, 0, 0, 4]]";

std::size_t count_of(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++count;
    return count;
}

std::string answer(const std::string& value, const std::string& at = "2026-11-21T10:03:12") {
    return R"({"at": ")" + at + R"(", "answer": )" + value + R"(, "told": "right"})";
}

std::string change(const std::string& settings) {
    return R"({"set": )" + settings + "}";
}

std::string item(const std::string& exercise, int variant, const std::string& attempts) {
    return R"({"exercise": ")" + exercise + R"(", "variant": )" + std::to_string(variant) + R"(, "attempts": [)" +
           attempts + "]}";
}

std::string hand_in(const std::string& student, const std::string& items, const std::string& name = "김학생") {
    return R"({"answers": 1, "course": "cg", "student": ")" + student + R"(", "name": ")" + name + R"(", "items": [)" +
           items + "]}";
}

class GradeCommand : public Program {
protected:
    GradeCommand() {
        for (const char* const name : {"exercises", "hand-ins"}) fs::create_directory(folder() / name);
        write("exercises/1-far.json", far_exercise);
        write("exercises/2-shadow.json", shadow_exercise);
        write("exercises/3-near.json", near_exercise);
    }

    Ended grade(int status, std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), "grade");
        arguments.insert(arguments.end(), {"--exercises", "exercises"});
        return expect(status, arguments);
    }

    /// Returns the student's variant of N01-far, the only exercise with two variants.
    int variant_of(const std::string& student) const {
        write("probe.json", hand_in(student, ""));
        const nlohmann::json probe = grade(1, {"probe.json", "--format", "json"}).json();
        fs::remove(folder() / "probe.json");
        return probe["students"][0]["items"][0]["variant"];
    }

    /// Returns a right answer to each exercise. The times of the first two answers start with `at`.
    std::string right_items(const std::string& student, const std::string& at = "2026-11-21T10:") const {
        return item("N01-far", variant_of(student), answer("40", at + "03:12")) + "," +
               item("M02-shadow", 0, answer(shadow_matrix, at + "07:40")) + "," +
               item("G03-near", 0, change(R"({"projection.near": 0.1})"));
    }
};

TEST_F(GradeCommand, RightAnswersEarnTheirPoints) {
    write("right.json", hand_in("32201234", right_items("32201234")));
    const std::string table = grade(0, {"right.json"}).out;
    EXPECT_TRUE(has(table, "student   N01 M02 G03 points  first try  hints  notes\n")) << table;
    EXPECT_TRUE(has(table, "32201234    2   3   2    7/7        3/3      0\n")) << table;
    EXPECT_TRUE(has(grade(0, {"right.json", "--course", "cg"}).out, " 7/7 "));
}

TEST_F(GradeCommand, VerdictsInAFileAreNotTrusted) {
    write("wrong.json", hand_in("1", item("N01-far", variant_of("1"), answer("10") + R"(, {"hint": 1})") + "," +
                                         item("M02-shadow", 0, answer("7") + "," + answer(transposed_matrix)) + "," +
                                         item("G03-near", 0, change(R"({"projection.near": 0.6})"))));
    const std::string table = grade(1, {"wrong.json"}).out;
    for (const char* const cell : {" w:T10 ", " w:M33 ", " p1 ", " 1/7 ", " 0/3 "})
        EXPECT_TRUE(has(table, cell)) << table;
    const nlohmann::json student = grade(1, {"wrong.json", "--format", "json"}).json()["students"][0];
    EXPECT_EQ(student["hints"], 1);
    EXPECT_EQ(student["items"][0]["told"][0], "That is ten.");
    EXPECT_EQ(student["items"][1]["tags"], nlohmann::json({"", "M33"}));
    EXPECT_EQ(student["items"][1]["right"], nlohmann::json({false, false}));
    EXPECT_EQ(student["items"][2]["standing"], "partly");
}

TEST_F(GradeCommand, AnotherStudentsVariantIsNotJudgedAndMissingAnswersAreShown) {
    const int other = 1 - variant_of("1");
    write("one.json", hand_in("1", item("N01-far", other, answer("40"))));
    const std::string table = grade(1, {"one.json"}).out;
    EXPECT_TRUE(has(table, " v! ")) << table;
    EXPECT_EQ(count_of(table, " - "), 2U) << table;
    EXPECT_TRUE(has(table, "N01-far has variant " + std::to_string(other) + " instead of " +
                               std::to_string(variant_of("1")) + ": made for another number than \"1\""))
        << table;
}

TEST_F(GradeCommand, AHandInWithoutANumberIsNamedByItsFile) {
    write("hand-ins/none.json", hand_in("", right_items("")));
    write("hand-ins/2.json", hand_in("2", right_items("2")));
    const std::string table = run({"grade", "hand-ins", "--exercises", "exercises"}).out;
    EXPECT_TRUE(has(table, "none.json ")) << table;
    EXPECT_TRUE(has(table, "same attempt times as hand-ins/none.json")) << table;
}

TEST_F(GradeCommand, AnInvalidAnswerIsWrong) {
    const auto standing = [&](const std::string& items, std::size_t index) -> std::string {
        write("one.json", hand_in("1", items));
        const nlohmann::json student = grade(1, {"one.json", "--format", "json"}).json()["students"][0];
        return student["items"][index]["standing"];
    };
    const auto goal = [&](const std::string& settings) { return standing(item("G03-near", 0, change(settings)), 2); };
    EXPECT_EQ(goal(R"({"projection.near": 0.1, "projection.far": 90})"), "wrong");
    EXPECT_EQ(goal(R"({"projection.naer": 0.1})"), "wrong");
    EXPECT_EQ(goal(R"({"projection.near": "abc"})"), "wrong");
    EXPECT_EQ(goal(R"({"projection.near": -5})"), "wrong");
    EXPECT_EQ(standing(item("G03-near", 0, answer("0.1")), 2), "wrong");
    EXPECT_EQ(standing(item("M02-shadow", 0, answer("[1, 2]")), 1), "wrong");
    EXPECT_EQ(standing(item("M02-shadow", 0, answer("[]")), 1), "wrong");
    EXPECT_EQ(standing(item("M02-shadow", 0, change(R"({"light.position": [0, 9, 0, 1]})")), 1), "wrong");
}

TEST_F(GradeCommand, ABrokenFileCostsOnlyItsOwnLine) {
    write("hand-ins/a-cut.json", hand_in("1", "").substr(0, 30));
    write("hand-ins/b-plain.json", "my answers are 1 and 2");
    write("hand-ins/c-huge.json", hand_in("1", item("N01-far", 0, answer("1e999"))));
    write("hand-ins/d-nameless.json", R"({"answers": 1, "items": []})");
    write("hand-ins/e-right.json", hand_in("32201234", right_items("32201234")));
    write("hand-ins/f-deep.json", std::string(100, '[') + std::string(100, ']'));
    const Ended ended = grade(2, {"hand-ins", "nowhere.json"});
    for (const char* const name : {"a-cut", "b-plain", "c-huge", "d-nameless", "f-deep", "nowhere"})
        EXPECT_TRUE(has(ended.out, std::string(name) + ".json: ")) << ended.told();
    EXPECT_TRUE(has(ended.err, "a-cut.json: ")) << ended.told();
    EXPECT_TRUE(has(ended.err, "; 5 more cannot be read (see the table)")) << ended.told();
    EXPECT_TRUE(has(ended.out, "32201234    2   3   2    7/7 ")) << ended.told();
    const nlohmann::json all = grade(2, {"hand-ins", "--format", "json"}).json();
    EXPECT_EQ(all["students"].size(), 6U);
    EXPECT_TRUE(all["students"][0].contains("error"));
    EXPECT_EQ(all["students"][4]["points"], 7);
}

TEST_F(GradeCommand, AnUnreadableAnswerCostsOnlyItself) {
    const std::string student = "32201234";
    const std::string far_item = item("N01-far", variant_of(student), answer("40"));
    const std::string near_item = item("G03-near", 0, change(R"({"projection.near": 0.1})"));
    const auto graded_with = [&](const std::string& shadow_items) {
        write("one.json", hand_in(student, far_item + "," + shadow_items + "," + near_item));
        return grade(1, {"one.json", "--format", "json"}).json()["students"][0];
    };
    const std::string worded = graded_with(item("M02-shadow", 0, answer("\"as in the lecture\"")))["items"][1].dump();
    EXPECT_TRUE(has(worded, "not_judged")) << worded;
    EXPECT_TRUE(has(worded, "items[1].attempts[0].answer")) << worded;
    for (const char* const unreadable :
         {R"({"exercise": "M02-shadow", "variant": "two", "attempts": []})",
          R"({"exercise": "M02-shadow", "attempt": []})", "7", R"({"attempts": [{"answer": 1}]})"}) {
        const nlohmann::json student_grade = graded_with(unreadable);
        EXPECT_EQ(student_grade["points"], 4) << unreadable;
        EXPECT_TRUE(has(student_grade.dump(), "items[1]")) << student_grade;
    }
    // A second, readable answer counts; a second item of the same exercise does not.
    write("two.json", hand_in(student, right_items(student) + "," + item("N01-far", 0, answer("1")) + "," +
                                           item("N02", 0, answer("1") + R"(, {"answer": {}})")));
    const nlohmann::json both = grade(0, {"two.json", "--format", "json"}).json()["students"][0];
    EXPECT_EQ(both["points"], 7);
    EXPECT_TRUE(has(both["notes"].dump(), "left out: items[3].exercise")) << both;
    EXPECT_TRUE(has(both["notes"].dump(), "left out: items[4].attempts[1].answer")) << both;
    // Every way of showing the grades has the reason.
    write("one.json", hand_in(student, far_item + "," + item("M02-shadow", 0, answer("true")) + "," + near_item));
    grade(1, {"one.json", "--html", "page.html"});
    EXPECT_TRUE(has(read("page.html"), "items[1].attempts[0].answer"));
    for (const char* const format : {"text", "csv"})
        EXPECT_TRUE(has(grade(1, {"one.json", "--format", format}).out, "items[1].attempts[0].answer")) << format;
}

TEST_F(GradeCommand, ASpreadsheetGetsTextAndNoFormulas) {
    write("one.json", hand_in("=1+1", item("N01-far", variant_of("=1+1"), answer("10")), R"(@SUM(1, 2) \"Kim\")"));
    const std::string csv = grade(1, {"one.json", "--format", "csv"}).out;
    EXPECT_TRUE(has(csv, "student,name,file,N01-far,M02-shadow,G03-near,points,of,first_try,hints,notes\r\n")) << csv;
    EXPECT_TRUE(has(csv, R"('=1+1,"'@SUM(1, 2) ""Kim""",one.json,w:T10,,,0,7,0,0,)"
                         "\r\n"))
        << csv;
}

TEST_F(GradeCommand, MisconceptionsAreSharesOfStudentsWhoTried) {
    write("hand-ins/1.json", hand_in("1", item("N01-far", variant_of("1"), answer("10") + "," + answer("40"))));
    write("hand-ins/2.json", hand_in("2", item("N01-far", variant_of("2"), answer("40"))));
    write("hand-ins/3.json", hand_in("3", ""));
    const std::string said = "T10 ten, not forty: 50% of 2 students, 0% on the last attempt\n";
    EXPECT_TRUE(has(grade(1, {"hand-ins", "--tags"}).out, "\n\n" + said));
    const std::string csv = grade(1, {"hand-ins", "--tags", "--format", "csv"}).out;
    EXPECT_EQ(csv, "tag,text,students,at_last,students_of\r\nT10,\"ten, not forty\",1,0,2\r\n");
    // A student who hands in twice is one student, and a file that is named twice is one file.
    write("hand-ins/1-again.json", hand_in("1", item("N01-far", variant_of("1"), answer("10"))));
    const std::string again =
        grade(1, {"hand-ins", "hand-ins/2.json", "hand-ins", "--tags", "--html", "page.html"}).out;
    EXPECT_TRUE(has(again, "T10 ten, not forty: 50% of 2 students, 50% on the last attempt\n")) << again;
    EXPECT_EQ(count_of(again, "another file from the same student"), 2U) << again;
    EXPECT_TRUE(has(read("page.html"), "<p>3 students, ")) << "the third one tried nothing";
}

TEST_F(GradeCommand, OnlyTheSetCounts) {
    write("one.json", hand_in("1", item("M02-shadow", 0, answer(shadow_matrix))));
    EXPECT_TRUE(has(grade(0, {"one.json", "--set", "shadow"}).out, "student  M02 points"));
    EXPECT_TRUE(has(grade(1, {"one.json", "--set", "N01,G03-near"}).out, "student  N01 G03 points"));
    refused({"grade", "one.json", "--exercises", "exercises", "--set", "shadwo"}, {"shadwo", "camera, shadow"});
    refused({"grade", "one.json", "--exercises", "nowhere.json"}, {"nowhere.json"});
    refused({"grade", "--exercises", "exercises"}, {"no hand-in given"});
    refused({"grade", "one.json", "--html", "-"}, {"-o and --html"});
}

TEST_F(GradeCommand, SimilarFilesGetANote) {
    write("hand-ins/1.json", hand_in("1", right_items("1")));
    write("hand-ins/2.json", hand_in("2", right_items("2")));
    write("hand-ins/3.json", hand_in("3", right_items("3", "2026-11-22T09:")));
    const std::string table = grade(0, {"hand-ins"}).out;
    EXPECT_TRUE(has(table, "same attempt times as 2\n")) << table;
    EXPECT_TRUE(has(table, "same attempt times as 1\n")) << table;
    EXPECT_EQ(count_of(table, "same attempt times"), 2U) << table;
}

TEST_F(GradeCommand, ThePageHasEverythingInIt) {
    write("hand-ins/1.json", hand_in("1", right_items("1")));
    write("hand-ins/2.json", hand_in("2", item("M02-shadow", 0, answer(transposed_matrix)), "<script>&"));
    const Ended ended = grade(1, {"hand-ins", "--html", "report.html", "-o", "grades.txt"});
    EXPECT_EQ(ended.out, "");
    EXPECT_TRUE(has(read("grades.txt"), "w:M33"));
    const std::string page = read("report.html");
    for (const char* const part : {"class=\"histogram\"", "김학생", "&lt;script&gt;&amp;", "rows and columns",
                                   "Effects of wrong matrices", "entered by 1 student", "Rows are columns. (M33)"})
        EXPECT_TRUE(has(page, part)) << part;
    EXPECT_FALSE(has(page, "<script"));
    grade(1, {"hand-ins", "--html", "korean.html", "--language", "ko"});
    EXPECT_TRUE(has(read("korean.html"), "<td>정답") || has(read("korean.html"), ">정답<"));
    EXPECT_FALSE(has(read("korean.html"), "오른쪽"));
    EXPECT_EQ(count_of(page, "data:image/png;base64,iVBORw0KGgo"), 2U);
    for (const char* const tag : {"svg", "table", "details", "tr", "td", "th", "div", "p", "figure"}) {
        const std::string name = tag;
        EXPECT_EQ(count_of(page, "<" + name + ">") + count_of(page, "<" + name + " "),
                  count_of(page, "</" + name + ">"))
            << tag;
    }
}

TEST_F(GradeCommand, FoldersAreSearchedWithoutLinksAndSkippedFilesAreCounted) {
    const std::string right = hand_in("32201234", right_items("32201234"));
    for (const char* const name : {"hand-ins/b", "hand-ins/b/deep", "hand-ins/.git", "elsewhere"})
        fs::create_directory(folder() / name);
    for (const char* const name : {"hand-ins/c.json", "hand-ins/B.JSON", "hand-ins/b/deep/a.Json", "hand-ins/.c.json",
                                   "hand-ins/.git/x.json", "elsewhere/e.json"})
        write(name, right);
    for (const char* const name : {"hand-ins/notes.txt", "hand-ins/b/json", "hand-ins/b/a.json~"}) write(name, "{");
    fs::create_symlink(folder() / "elsewhere/e.json", folder() / "hand-ins/link.json");
    fs::create_symlink("..", folder() / "hand-ins/b/round");
    const std::string counted = "3 files judged, 7 skipped: 3 not JSON, 2 links, 2 hidden";
    const Ended as_text = grade(0, {"hand-ins"});
    EXPECT_TRUE(has(as_text.out, "\n\n" + counted + "\n  not JSON: hand-ins/b/a.json~\n")) << as_text.told();
    EXPECT_TRUE(has(as_text.out, "\n  not JSON: hand-ins/notes.txt\n")) << as_text.told();
    const nlohmann::json all = grade(0, {"hand-ins", "--format", "json"}).json();
    std::vector<std::string> files;
    for (const nlohmann::json& student : all["students"]) files.push_back(student["file"]);
    EXPECT_EQ(files, (std::vector<std::string>{"hand-ins/B.JSON", "hand-ins/b/deep/a.Json", "hand-ins/c.json"}));
    EXPECT_EQ(all["files"]["judged"], 3);
    EXPECT_EQ(all["files"]["skipped"].size(), 7U);
    EXPECT_EQ(all["files"]["skipped"][0], nlohmann::json({{"file", "hand-ins/.c.json"}, {"why", "hidden"}}));
    const Ended as_csv = run({"grade", "hand-ins", "--format", "csv", "--exercises", "exercises"});
    EXPECT_EQ(as_csv.err, "grade: " + counted + "\n");
    EXPECT_FALSE(has(as_csv.out, "skipped"));
    EXPECT_TRUE(has(grade(0, {"hand-ins/link.json"}).out, " 7/7 ")) << "a link named on the command line is followed";
    write("hand-ins/broken.json", "{");
    EXPECT_TRUE(has(grade(2, {"hand-ins", "--html", "page.html"}).err, "; 3 files judged, 1 not read, 7 skipped: "));
    EXPECT_TRUE(has(read("page.html"), "3 files judged, 1 not read, 7 skipped: 3 not JSON"));
    refused({"grade", "elsewhere", "-o", "elsewhere/e.json"}, {"cannot be the same file"});
}

TEST_F(GradeCommand, AFolderWithoutHandInsIsReportedInOneLine) {
    write("hand-ins/a.txt", "");
    EXPECT_TRUE(has(grade(2, {"hand-ins"}).err, "hand-ins: the folder contains no .json file; 0 files judged"));
}

TEST_F(GradeCommand, OutOfTimeWritesJudgedResultsAndMarksTheRest) {
    write("hand-ins/1.json", hand_in("1", right_items("1")));
    write("hand-ins/2.json", hand_in("2", ""));
    const Ended ended =
        grade(8, {"hand-ins", "--timeout", "0.001", "--format", "json", "-o", "grades.json", "--html", "page.html"});
    EXPECT_TRUE(has(ended.err, "the 0.001 s of --timeout; 1 of 2 hand-ins are not fully judged")) << ended.told();
    const nlohmann::json all = nlohmann::json::parse(read("grades.json"));
    ASSERT_EQ(all["students"].size(), 2U);
    EXPECT_EQ(all["students"][0]["items"][0]["standing"], "not_judged");
    EXPECT_EQ(all["students"][0]["items"][0]["trouble"], "--timeout expired");
    EXPECT_EQ(all["students"][1]["items"][0]["standing"], "missing");
    EXPECT_EQ(all["files"]["out_of_time"], 1);
    EXPECT_TRUE(has(read("page.html"), "not judged: --timeout expired"));
    EXPECT_TRUE(has(read("page.html"), "</html>"));
    const std::string csv = grade(8, {"hand-ins", "--timeout", "0.001", "--format", "csv"}).out;
    EXPECT_TRUE(has(csv, ",?,?,?,0,7,0,0,\"N01-far, M02-shadow, G03-near not judged: --timeout expired\"")) << csv;
    const std::string table = grade(8, {"hand-ins", "--timeout", "0.001"}).out;
    EXPECT_TRUE(has(table, "1 file judged, 1 not fully judged\n")) << table;
    EXPECT_TRUE(has(grade(1, {"hand-ins", "--timeout", "60"}).err, "1 of 2 hand-ins are fully correct"));
}

}  // namespace
}  // namespace cli_tests
