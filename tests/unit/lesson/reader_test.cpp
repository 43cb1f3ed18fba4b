// Lesson files: the parsed steps, and the error for each possible fault.
#include <gtest/gtest.h>

#include "lesson/lesson.h"
#include "state/file/document.h"

namespace viewing {
namespace {

const char* const small = R"({
  "lesson": 1, "id": "mine", "title": {"en": "Mine", "ko": "내 것"}, "slides": [2, 3], "minutes": 5,
  "tags": {"M01": "C used for V"},
  "steps": [
    {
      "id": "first",
      "state": {"preset": "opening", "set": {"camera.yaw": 10}},
      "layout": {"lower_left": "depth", "target": {"point": [1, 2, 3], "label": "here"}},
      "say": "Look.", "cover": ["matrix:V"], "highlight": ["control:camera.yaw"],
      "ask": {"kind": "number", "question": "How far?", "expect": "camera.yaw", "tol": 0.5,
              "wrong": [{"when": "answer == -10", "try": -10, "tag": "M01", "say": "The sign."}], "hints": ["Look at yaw."]},
      "reveal": {"set": {"camera.yaw": 40}, "over_s": 2, "highlight": ["matrix:V[0][0]"], "say": "So far."},
      "claims_before": ["camera.yaw == 10"], "claims": ["camera.yaw == 40"], "note": "Slowly."
    },
    {
      "id": "second", "say": "Now you.",
      "ask": {"kind": "goal", "question": "Turn.", "until": "camera.yaw > 90", "allow": ["camera.yaw"], "model": {"camera.yaw": 100}},
      "reveal": {"set": {"camera.pitch": -5}, "say": "Turned."}
    }
  ]
})";

TEST(LessonReader, StepIsCompleteByItself) {
    const Result<Lesson> lesson = parse_lesson(small, "mine.json", "");
    ASSERT_TRUE(lesson) << lesson.error();
    EXPECT_EQ(lesson->title.in(Language::ko), "내 것");
    EXPECT_EQ(lesson->slides, (std::vector{2, 3}));
    ASSERT_EQ(lesson->steps.size(), 2U);
    const LessonStep& first = lesson->steps[0];
    EXPECT_EQ(first.start.params.camera.yaw, 10.0);
    EXPECT_EQ(first.start.params.view.lower_left, Topic::depth);
    EXPECT_EQ(first.revealed.camera.yaw, 40.0);
    EXPECT_EQ(first.target->label.in_english(), "here");
    EXPECT_EQ(first.target->point_world, glm::dvec3(1, 2, 3));
    EXPECT_EQ(first.ask.wrong[0].sample.numbers, std::vector{-10.0});
    const LessonStep& second = lesson->steps[1];
    EXPECT_EQ(second.start.params.camera, Params{}.camera);
    EXPECT_EQ(second.revealed.camera.yaw, 100.0) << "a reveal adds to the goal's model";
    EXPECT_EQ(second.revealed.camera.pitch, -5.0);
}

/// Replaces one part of the file and returns the error.
std::string lesson_trouble(const std::string& part, const std::string& other) {
    std::string text = small;
    const std::size_t at = text.find(part);
    EXPECT_NE(at, std::string::npos) << part;
    text.replace(at, part.size(), other);
    const Result<Lesson> lesson = parse_lesson(text, "mine.json", "");
    EXPECT_FALSE(lesson) << other;
    return lesson ? "" : lesson.error();
}

TEST(LessonReader, ReportsFaultsWithFileStepAndField) {
    EXPECT_EQ(lesson_trouble("\"hints\"", "\"hint\""),
              "mine.json: step first: ask.hint: no such field; did you mean hints?");
    EXPECT_EQ(lesson_trouble("\"number\"", "\"numbr\"").substr(0, 40), "mine.json: step first: ask.kind: must be");
    EXPECT_EQ(lesson_trouble("\"expect\": \"camera.yaw\"", "\"expect\": \"camra.yaw\""),
              "mine.json: step first: ask.expect: unknown name camra; did you mean camera?");
    EXPECT_NE(lesson_trouble("camera.yaw == 40", "camera.yaw == ").find("mine.json: step first: claims[0]: "),
              std::string::npos);
    EXPECT_NE(lesson_trouble("{\"camera.yaw\": 10}", "{\"camera.yow\": 10}")
                  .find("mine.json: step first: state.set: camera.yow"),
              std::string::npos);
    EXPECT_NE(lesson_trouble("\"preset\": \"opening\"", "\"preset\": \"openning\"").find("did you mean opening?"),
              std::string::npos);
    EXPECT_NE(lesson_trouble("[\"matrix:V\"]", "[\"matrix:W\"]").find("mine.json: step first: cover[0]: "),
              std::string::npos);
    EXPECT_NE(lesson_trouble("\"minutes\": 5", "\"minutes\": \"five\"").find("mine.json: minutes: must be"),
              std::string::npos);
    EXPECT_NE(lesson_trouble("\"lesson\": 1", "\"lesson\": 2").find("mine.json: lesson: must be 1"), std::string::npos);
    EXPECT_NE(lesson_trouble("\"id\": \"second\"", "\"id\": \"first\"").find("another step has the id"),
              std::string::npos);
    EXPECT_NE(lesson_trouble("\"say\": \"Look.\"", "\"say\": [1]").find("mine.json: step first: say: must be a string"),
              std::string::npos);
    EXPECT_NE(
        lesson_trouble("\"allow\": [\"camera.yaw\"]", "\"allow\": [\"camera.yawn\"]").find("did you mean camera.yaw?"),
        std::string::npos);
    EXPECT_NE(lesson_trouble("\"try\": -10", "\"try\": [1, 2]").find("must have 1 numbers"), std::string::npos);
    EXPECT_NE(lesson_trouble("\"over_s\": 2", "\"over_s\": 1e9").find("reveal.over_s: must be"), std::string::npos);
    EXPECT_NE(lesson_trouble("\"model\": {\"camera.yaw\": 100}", "\"model\": {}").find("ask.model: is missing"),
              std::string::npos);
    EXPECT_NE(lesson_trouble("\"reveal\": {\"set\": {\"camera.pitch\": -5}, \"say\": \"Turned.\"}", "\"note\": \"x\"")
                  .find("step second: reveal: is missing"),
              std::string::npos);
}

TEST(LessonReader, AMistakeThatFollowsFromAnotherIsNotReported) {
    const auto mistakes = [](const std::string& ask, const std::string& more = "") {
        return lesson_mistakes(R"({"lesson": 1, "id": "a", "title": "A", "steps": [{"id": "one", "say": "x", )" + more +
                                   "\"ask\": " + ask + R"(, "reveal": {"say": "y"}}]})",
                               "a.json", "");
    };
    EXPECT_EQ(mistakes(R"({"kind": "order", "question": "q", "items": ["a", 1], "expect": [0, 1],
                           "wrong": [{"value": [1, 0], "say": "w"}]})"),
              (std::vector<std::string>{
                  R"(a.json: step one: ask.items[1]: must be a string or {"en": …, "ko": …}, got the number 1)"}));
    EXPECT_EQ(mistakes(R"({"kind": "number", "question": "q", "expect": "k"})", R"("let": {"and": 1}, )").size(), 1U);
    const std::vector<std::string> two =
        mistakes(R"({"kind": "numbr", "question": "", "expect": "k", "wrong": [{"say": "w"}]})");
    ASSERT_EQ(two.size(), 2U) << two.front();
    EXPECT_NE(two[0].find("ask.kind: must be one of"), std::string::npos) << two[0];
    EXPECT_NE(two[1].find("ask.question: must not be empty"), std::string::npos) << two[1];
}

TEST(LessonReader, TruncatedFileNeverCrashes) {
    const std::string whole = small;
    for (std::size_t length = 0; length < whole.size(); length += 7)
        EXPECT_FALSE(parse_lesson(std::string_view(whole).substr(0, length), "cut.json", ""));
}

TEST(LessonReader, ShippedLessonsFollowTheLecture) {
    const std::vector<LessonFile> files = lessons();
    ASSERT_EQ(files.size(), 17U);
    EXPECT_EQ(files.front().id, "view-is-the-inverse");
    EXPECT_EQ(files.back().id, "why-this-pixel");
    int steps = 0;
    for (const LessonFile& file : files) {
        const Result<Lesson> lesson = load_lesson(file.id);
        EXPECT_TRUE(lesson) << (lesson ? "" : lesson.error());
        steps += file.steps;
    }
    EXPECT_EQ(steps, 116);
    EXPECT_NE(load_lesson("veiw-is-the-inverse").error().find("view-is-the-inverse"), std::string::npos);
}

TEST(LessonReader, CardShowsItsOwnStateOrTheFirstStep) {
    const Result<Lesson> without = load_lesson("orders"), with = load_lesson("fly-and-walk");
    ASSERT_TRUE(without && with);
    EXPECT_FALSE(without->picture);
    ASSERT_TRUE(with->picture);
    EXPECT_EQ(with->picture->params.scene, SceneSource("walkthrough"));
    const Result<Lesson> broken = parse_lesson(R"({"lesson": 1, "id": "a", "title": "t", "picture": {"scene": "room"},
        "steps": [{}]})",
                                               "mine.json", "");
    ASSERT_FALSE(broken);
    EXPECT_EQ(broken.error().find("mine.json: picture.scene: "), 0U) << broken.error();
}

}  // namespace
}  // namespace viewing
