// The JSON Schemas of lectures, lessons, exercises and hand-ins, and their readers, accept the same files: the
// program's own, and those with one random change.
#include <gtest/gtest.h>

#include "agreement.h"
#include "lesson/exercise.h"
#include "lesson/hand_in.h"
#include "lesson/lesson.h"

namespace viewing {
namespace {

TEST(LessonSchemas, OfALectureAcceptsWhatTheReaderAccepts) {
    if (!has_validator()) GTEST_SKIP() << no_validator;
    const Json small = Json::parse(R"({"lecture": 1, "id": "mine", "title": {"en": "My lecture", "ko": "내 강의"},
      "parts": [{"preset": "room", "title": "A room", "say": {"en": "Three mirrors.", "ko": "거울 셋."}, "minutes": 2},
                {"lesson": "depth-fighting", "steps": [1, 2, "near"], "minutes": 8},
                {"lesson": "rays", "end": false, "minutes": 10}]})");
    const auto complaint = [](const std::string& text) {
        const Result<Lesson> read = parse_lesson(text, "a.json", "");
        return read ? "" : read.error();
    };
    // Only the reader checks whether a lesson, a step of it, or a preset exists.
    const std::vector<std::string> only_reader{"neither a file nor a lesson or lecture",
                                               "no such preset",
                                               "has no step",
                                               "must be a whole number from 1 to",
                                               "must be a lesson's id",
                                               "is a lecture",
                                               "must be the name of a preset"};
    expect_agreement(lecture_schema(), {small}, 100, 71, complaint, only_reader);
    expect_agreement(lecture_schema(), files_of("lectures"), 8, 74, complaint, only_reader);
}

TEST(LessonSchemas, OfALessonAcceptsWhatTheReaderAccepts) {
    if (!has_validator()) GTEST_SKIP() << no_validator;
    const auto complaint = [](const std::string& text) {
        const Result<Lesson> read = parse_lesson(text, "a.json", "");
        return read ? "" : read.error();
    };
    // Only the reader checks paths and values of settings, expressions, numbers of items and entries, and names of
    // targets, presets, fields and exercises.
    const std::vector<std::string> only_reader{".set: ",
                                               ".model: ",
                                               ".try",
                                               ".value",
                                               ".when: ",
                                               ".until: ",
                                               "expect",
                                               "factors",
                                               "claims",
                                               "nothing in the window has this name",
                                               "neither a file nor a preset",
                                               "no such field; did you mean",
                                               "there is no exercise",
                                               "another step has the id",
                                               "must be the name of a preset"};
    expect_agreement(lesson_schema(), files_of("lessons"), 12, 75, complaint, only_reader);
}

TEST(LessonSchemas, OfAnExerciseAcceptsWhatTheReaderAccepts) {
    if (!has_validator()) GTEST_SKIP() << no_validator;
    const auto complaint = [](const std::string& text) {
        const Result<Exercise> read = parse_exercise(text, "a.json", "");
        return read ? "" : read.error();
    };
    // Only the reader checks expressions, combinations, and the constants of each stored variant. The step depends
    // on the constants, so it is read separately for each variant.
    expect_agreement(exercise_schema(), files_of("exercises"), 30, 76, complaint,
                     {"require", "combination", "deployed[", "is not a valid name"});
}

TEST(LessonSchemas, OfAHandInAcceptsWhatTheReaderAccepts) {
    if (!has_validator()) GTEST_SKIP() << no_validator;
    const std::vector<Json> documents{Json::parse(
        R"({"answers": 1, "program": "0.1.0", "course": "viewing-2026", "student": "32201234", "name": "김학생",
          "items": [{"exercise": "E16-shadow-matrix", "variant": 0, "draft": [1, 2, 3], "attempts": [
            {"at": "2026-11-21T10:03:12", "answer": [[4, -1, 0, 0], [0, 0, 0, 0], [0, -1, 4, 0], [0, -1, 0, 4]],
             "told": "no"}, {"at": "2026-11-21T10:04:00", "hint": 1}]},
           {"exercise": "E18-place-the-light", "variant": 0, "draft_set": {"camera.yaw": 1},
            "replay": [{"after_s": 1.5, "set": {"camera.yaw": 2}}],
            "attempts": [{"at": "2026-11-21T10:05:00", "set": {"light.position": [1, 4, 1, 1]}, "told": "right"}]}]})")};
    const auto complaint = [](const std::string& text) {
        const Result<HandIn> read = parse_hand_in(text, "a.json");
        return read ? "" : read.error();
    };
    expect_agreement(hand_in_schema(), documents, 800, 72, complaint, {"appears twice", "has more than 64 numbers"});
}

}  // namespace
}  // namespace viewing
