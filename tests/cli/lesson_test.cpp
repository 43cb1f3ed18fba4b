// Lessons on the command line: the list of lessons, their tests, a step as a picture, and a handout.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include "cli/program.h"

namespace cli_tests {
namespace {

class LessonCommand : public Program {};

/// Returns a lesson of one step; `claim` must hold after its answer.
std::string lesson_with(const std::string& claim, const std::string& wrong_try = "10") {
    return R"({"lesson": 1, "id": "mine", "title": "Mine", "tags": {"T": "ten"}, "steps": [{"id": "one", "say": "Look.",
        "ask": {"kind": "number", "question": "How far is z-far?", "expect": "projection.far", "tol": 0.1,
                "wrong": [{"when": "answer == 10", "try": )" +
           wrong_try + R"(, "tag": "T", "say": "That is ten."}]},
        "reveal": {"set": {"projection.near": 2}, "say": "Forty."}, "claims": [")" +
           claim + R"("]}]})";
}

TEST_F(LessonCommand, ListsTheLecture) {
    const std::string list = expect(0, {"lesson", "--list"}).out;
    EXPECT_EQ(std::count(list.begin(), list.end(), '\n'), 17);
    EXPECT_TRUE(has(list, "depth-fighting — "));
    EXPECT_TRUE(has(expect(0, {"lesson", "--names"}).out, "apply(M, p)"));
}

TEST_F(LessonCommand, ACheckThatFailsNamesLessonStepAndValues) {
    write("mine.json", lesson_with("projection.near == 2"));
    EXPECT_TRUE(has(expect(0, {"lesson", "--check", "mine.json"}).out, "1 lesson, 1 step: "));
    write("mine.json", lesson_with("projection.near == 3"));
    const std::string found = expect(1, {"lesson", "--check", "mine.json"}).out;
    EXPECT_TRUE(has(found, "mine, step one: claims[0]: projection.near == 3 does not hold; its sides are 2.0 and 3.0"))
        << found;
    write("mine.json", lesson_with("true", "11"));
    EXPECT_TRUE(has(expect(1, {"lesson", "--check", "mine.json"}).out, "ask.wrong[0] is not recognized"));
    write("mine.json", lesson_with("true", "40"));
    EXPECT_TRUE(has(expect(1, {"lesson", "--check", "mine.json"}).out, "ask.wrong[0] is accepted as right"));
}

TEST_F(LessonCommand, ACheckFindsAnAnswerOnTheScreen) {
    const auto lesson = [](const std::string& more) {
        return R"({"lesson": 1, "id": "mine", "title": "Mine", "steps": [{"id": "one", "say": "Look.", )" + more + R"(
            "state": {"preset": "opening", "set": {"light.position": [2.345, 5, 2, 1]}},
            "ask": {"kind": "number", "question": "How far to the right?", "expect": "light.position[0]", "tol": 0.1},
            "reveal": {"say": "There."}}]})";
    };
    write("mine.json", lesson(""));
    const std::string found = expect(1, {"lesson", "--check", "mine.json"}).out;
    EXPECT_TRUE(has(found, "mine, step one: the answer 2.345 can be read beforehand: 2.3")) << found;
    EXPECT_TRUE(has(found, "light/position/x")) << found;
    write("mine.json", lesson(R"("cover": ["control:light.position"],)"));
    expect(0, {"lesson", "--check", "mine.json"});
}

TEST_F(LessonCommand, ACheckTellsAllMistakesOfAFile) {
    write("mine.json", R"({"lesson": 1, "id": "mine", "minutes": 0, "steps": [
        {"id": "one", "state": {"preset": "opennig"}, "say": "Look.", "cover": ["matrix:Q", "matrix:V", "lmaps"],
         "ask": {"kind": "choice", "choices": [{"say": "a", "right": true}, {"say": "b"}, {"say": "c"}]},
         "reveal": {"set": {"projection.naer": 2}, "say": "So."}, "claims": ["near(", "true", "naer == 2"]},
        {"id": "two", "say": 3, "ask": {"kind": "chioce", "question": "Which?"}}]})");
    const std::string told = expect(2, {"lesson", "--check", "mine.json"}).out;
    for (const char* const part :
         {"title", "minutes", "opennig", "cover[0]", "cover[2]", "question", "choices[1].why", "choices[2].why",
          "projection.naer", "claims[0]", "claims[2]", "step two: say", "chioce", "step two: reveal: is missing"})
        EXPECT_TRUE(has(told, part)) << part << "\n" << told;
    EXPECT_EQ(std::count(told.begin(), told.end(), '\n'), 14) << told;
    EXPECT_EQ(lines_of(expect(2, {"lesson", "mine.json", "--handout", "-"}).err).size(), 1U) << "only the first error";
}

TEST_F(LessonCommand, ACheckRefusesTheTextsOfASavedStep) {
    std::string lesson = lesson_with("true");
    lesson.replace(lesson.find("\"Look.\""), 7, "\"What the picture shows.\"");
    write("mine.json", lesson);
    const std::string told = expect(1, {"lesson", "--check", "mine.json"}).out;
    EXPECT_TRUE(has(told, "mine, step one: say is still the template's text \"What the picture shows.\"")) << told;
}

TEST_F(LessonCommand, ABrokenFileIsReportedInOneSentence) {
    write("mine.json", lesson_with("projection.naer == 2 and"));
    EXPECT_TRUE(has(expect(2, {"lesson", "--check", "mine.json"}).err, "mine.json: step one: claims[0]: "));
    expect(2, {"lesson", "--check", "nowhere.json"});
    EXPECT_TRUE(has(expect(2, {"lesson", "depht-fighting", "--check"}).err, "did you mean depth-fighting?"));
    expect(2, {"lesson", "--present"});
    expect(2, {"lesson", "--answers", "lens"});
    expect(2, {"lesson", "--check", "--list"});
}

/// Decodes the QR codes in a picture with a different library from the one that draws them.
TEST_F(LessonCommand, ThePhoneReadsTheStagesCode) {
    if (std::system("command -v zbarimg >/dev/null") != 0) GTEST_SKIP() << "no zbarimg (package zbar-tools)";
    const std::string address = "https://cg.example.edu/viewing/";
    for (const char* const size : {"1920x1080", "1024x768"})
        for (const char* const theme : {"dark", "projector"}) {
            expect(0, {"snapshot", "--lesson", "depth-fighting", "--step", "2", "--present", "--code", address, "--set",
                       std::string("ui.theme=") + theme, "--size", size, "-o", "stage.png"});
            const std::string command =
                "cd '" + folder().string() + "' && zbarimg --quiet --raw stage.png >read 2>said && rm said stage.png";
            EXPECT_EQ(std::system(command.c_str()), 0) << size << " " << theme;
            EXPECT_EQ(read("read"), address + "#lesson=depth-fighting&step=2\n") << size << " " << theme;
        }
    refused({"snapshot", "--lesson", "lens", "--code", address, "-o", "stage.png"}, {"--code needs --present"});
}

TEST_F(LessonCommand, HiddenFunctionsInExpressionsAreRefused) {
    const std::string bomb =
        "(function() local t={1,1,1,1,1,1,1,1,1,1} for i=1,13 do t={t,t,t,t,t,t,t,t,t,t} end return t end)()";
    for (const std::string& hidden : {bomb, "(--'\\n" + bomb + " --'\\n) == 1"}) {
        write("mine.json", lesson_with(hidden));
        const Ended ended = expect(2, {"lesson", "--check", "mine.json"}, {.limits = {{RLIMIT_CPU, 10}}});
        EXPECT_TRUE(has(ended.err, "mine.json: step one: claims[0]: function is not allowed")) << ended.told();
    }
}

/// The cost of a call such as visibility_counts() grows with the scene, so even a single call can cost too much.
TEST_F(LessonCommand, MeasuringALargeSceneIsRefusedBeforeItBegins) {
    std::string spheres;
    for (int i = 0; i < 200; ++i)
        spheres += std::string(i == 0 ? "" : ", ") + R"({"name": "s)" + std::to_string(i) + R"(", "shape": "sphere"})";
    std::string text = lesson_with("visibility_counts() ~= 1");
    const std::string set = R"("projection.near": 2)";
    text.replace(text.find(set), set.size(), R"("scene": {"objects": [)" + spheres + "]}");
    write("mine.json", text);
    const Ended ended = expect(1, {"lesson", "--check", "mine.json"}, {.limits = {{RLIMIT_CPU, 10}}});
    EXPECT_TRUE(has(ended.out, "visibility_counts() takes scenes of at most 20,000 polygons, but this one has "))
        << ended.told();
}

TEST_F(LessonCommand, DrawsAStepBeforeAndAfterItsAnswer) {
    write("mine.json", lesson_with("true"));
    const auto draw = [&](const std::string& file, std::vector<std::string> more) {
        std::vector<std::string> all{"snapshot", "--lesson", "mine.json", "--size", "480x360", "-o", file};
        all.insert(all.end(), more.begin(), more.end());
        expect(0, all);
    };
    draw("asks.png", {});
    draw("again.png", {"--step", "1"});
    draw("answered.png", {"--revealed"});
    draw("stage.png", {"--present"});
    expect(0, {"compare", "asks.png", "again.png", "--worst", "0", "--share", "0"});
    EXPECT_EQ(run({"compare", "asks.png", "answered.png"}).status, 1);
    EXPECT_EQ(run({"compare", "asks.png", "stage.png"}).status, 1);
    expect(2, {"snapshot", "--lesson", "mine.json", "--step", "2", "-o", "x.png"});
    expect(2, {"snapshot", "--step", "1", "-o", "x.png"});
    expect(2, {"snapshot", "room", "--lesson", "mine.json", "-o", "x.png"});
}

TEST_F(LessonCommand, HandoutHasAPageForEachStepAndAnswersOnRequest) {
    write("mine.json", lesson_with("true"));
    const std::string page = expect(0, {"lesson", "mine.json", "--handout", "-"}).out;
    EXPECT_TRUE(has(page, "How far is z-far?"));
    EXPECT_TRUE(has(page, "data:image/png;base64,iVBORw0KGgo"));
    EXPECT_FALSE(has(page, "Forty."));
    EXPECT_TRUE(has(expect(0, {"lesson", "mine.json", "--handout", "-", "--answers"}).out, "Forty."));
    expect(0, {"lesson", "mine.json", "--handout", "/dev/null"});  // a device or a pipe needs no ending
}

TEST_F(LessonCommand, AHandoutIsAPageAndHasAllSteps) {
    for (const char* const command : {"lesson", "lecture"}) {
        const std::vector<std::string> words{command, command == std::string("lesson") ? "gl-depth" : "viewing"};
        const auto with = [&](std::vector<std::string> more) {
            more.insert(more.begin(), words.begin(), words.end());
            return more;
        };
        refused(with({"--handout", "page.pdf"}), {"--handout", ".html", "page.pdf"});
        refused(with({"--handout", "page.html", "--step", "2"}), {"--handout", "--step"});
        refused(with({"--handout", "page.html", "--present"}), {"--handout", "--present"});
        EXPECT_FALSE(exists("page.pdf") || exists("page.html"));
    }
}

TEST_F(LessonCommand, ALessonGivenAsAStateIsReported) {
    write("mine.json", lesson_with("true"));
    EXPECT_TRUE(has(expect(2, {"state", "mine.json"}).err, "viewing-sandbox lesson mine.json"));
}

TEST_F(LessonCommand, ALectureIsCheckedAndHandedOut) {
    EXPECT_TRUE(has(expect(0, {"lecture", "--list"}).out, "viewing-75 "));
    EXPECT_TRUE(has(expect(0, {"lecture", "--check"}).out, "36 steps, 75 minutes\n"));
    write("mine.json", R"({"lecture": 1, "id": "mine", "title": "Mine", "parts": [
        {"preset": "room", "title": "A room", "say": "Three planes.", "minutes": 2},
        {"lesson": "rays", "steps": [1], "minutes": 4}]})");
    EXPECT_TRUE(has(expect(0, {"lecture", "mine.json", "--check"}).out, "2 parts, 2 steps, 6 minutes\n"));
    const std::string page = expect(0, {"lecture", "mine.json", "--handout", "-"}).out;
    for (const char* part : {"Three planes.", "A ray through each pixel", "keep-all", "Student number"})
        EXPECT_TRUE(has(page, part)) << part;
    write("mine.json", R"({"lecture": 1, "id": "mine", "title": "Mine", "parts": [
        {"lesson": "rayz", "minutes": 4}, {"lesson": "rays", "minutes": 0}]})");
    const Ended broken = expect(2, {"lecture", "--check", "mine.json"});
    EXPECT_TRUE(has(broken.out, "parts[0].lesson: ") && has(broken.out, "parts[1].minutes: ")) << broken.out;
    EXPECT_TRUE(has(broken.err, "2 mistakes"));
    EXPECT_TRUE(has(expect(2, {"lecture", "rays"}).err, "is a lesson, not a lecture"));
}

}  // namespace
}  // namespace cli_tests
