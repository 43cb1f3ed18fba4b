// Lectures: their files, whose mistakes are all found in one run; their plan in the notes; and the cards at the ends of
// lessons.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>

#include "lesson/exercise.h"
#include "lesson/notes.h"
#include "state/scene.h"
#include "state/slides.h"

namespace viewing {
namespace {

const char* const small_lecture = R"({
  "lecture": 1, "id": "mine", "title": {"en": "Mine", "ko": "내 것"},
  "parts": [
    {"preset": "room", "title": "A room", "say": {"en": "Three planes.", "ko": "평면 셋."}, "minutes": 2},
    {"lesson": "rays", "steps": [3, "ray"], "minutes": 4},
    {"lesson": "lens", "end": false, "minutes": 12}
  ]
})";

Lesson lecture_from(const std::string& json) {
    Result<Lesson> lecture = parse_lesson(json, "mine.json", "");
    if (!lecture) throw std::runtime_error(lecture.error());
    return *std::move(lecture);
}

TEST(LectureFile, ItsStepsAreThoseOfItsPartsInOrder) {
    const Lesson lecture = lecture_from(small_lecture);
    const Lesson rays = *load_lesson("rays"), lens = *load_lesson("lens");
    ASSERT_TRUE(lecture.lecture);
    ASSERT_EQ(lecture.steps.size(), 3 + lens.steps.size());
    EXPECT_TRUE(lecture.steps[0].only_shows());
    EXPECT_EQ(lecture.steps[0].ask.question.in(Language::ko), "평면 셋.");
    EXPECT_EQ(lecture.steps[0].start.params.planes.size(), load_state("room")->params.planes.size());
    EXPECT_EQ(lecture.steps[1].id, rays.steps[2].id);
    EXPECT_EQ(lecture.steps[2].id, "ray");
    EXPECT_EQ(lecture.steps.back().id, lens.steps.back().id);
    EXPECT_EQ(lecture.minutes, 18);
    const std::vector<std::size_t> expected{0, 1, 1, 2, 2};
    for (std::size_t step = 0; step < expected.size(); ++step)
        EXPECT_EQ(lecture.lecture->part_of(step), expected[step]) << step;
}

/// Replaces parts of the file and returns all mistakes.
std::vector<std::string> mistakes_with(const std::vector<std::pair<std::string, std::string>>& changes) {
    std::string text = small_lecture;
    for (const auto& [part, other] : changes) {
        const std::size_t at = text.find(part);
        EXPECT_NE(at, std::string::npos) << part;
        text.replace(at, part.size(), other);
    }
    const std::filesystem::path file = std::filesystem::path(::testing::TempDir()) / "lecture_file_test.json";
    std::ofstream(file) << text;
    const Result<std::vector<std::string>> mistakes = lecture_mistakes(file.string());
    if (!mistakes) return {mistakes.error()};
    std::vector<std::string> all;
    for (const std::string& mistake : *mistakes) {
        EXPECT_TRUE(mistake.starts_with(file.string() + ": ")) << mistake;
        all.push_back(mistake.substr(file.string().size() + 2));
    }
    return all;
}

TEST(LectureFile, AllMistakesAreFoundInOneRun) {
    EXPECT_EQ(mistakes_with({}), std::vector<std::string>{});
    const std::vector<std::string> all = mistakes_with({{"room", "rom"},
                                                        {"\"minutes\": 2", "\"minutes\": 0"},
                                                        {"[3, \"ray\"]", "[9, \"rayy\"]"},
                                                        {"\"lens\"", "\"lans\""},
                                                        {"\"end\": false", "\"ends\": false"},
                                                        {", \"minutes\": 12", ""}});
    ASSERT_EQ(all.size(), 7U);
    const char* const parts[][2] = {
        {"parts[0].minutes", "1 to 600"},         {"parts[0].preset", "rom"},
        {"parts[1].steps[0]", "1 to 4"},          {"parts[1].steps[1]", "did you mean ray?"},
        {"parts[2].ends", "did you mean end?"},   {"parts[2].minutes", "is missing"},
        {"parts[2].lesson", "did you mean lens?"}};
    for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_TRUE(all[i].starts_with(parts[i][0])) << all[i];
        EXPECT_NE(all[i].find(parts[i][1]), std::string::npos) << all[i];
    }
}

TEST(LectureFile, AnEmptyOrMistakenFormIsRefused) {
    EXPECT_NE(mistakes_with({{"\"lecture\": 1", "\"lecture\": 2"}}).front().find("must be 1"), std::string::npos);
    EXPECT_NE(mistakes_with({{"\"lecture\": 1", "\"lesson\": 1"}}).front().find("is not a lecture"), std::string::npos);
    EXPECT_NE(mistakes_with({{"\"lesson\": \"rays\"", "\"lesson\": \"viewing-75\""}}).front().find("is a lecture"),
              std::string::npos);
    EXPECT_NE(mistakes_with({{"\"lesson\": \"rays\", ", ""}}).front().find("either"), std::string::npos);
    EXPECT_NE(mistakes_with({{"[3, \"ray\"]", "[]"}}).front().find("at least one step"), std::string::npos);
}

TEST(LectureFile, TheProgramsLectureTakes75Minutes) {
    ASSERT_EQ(lectures().size(), 1U);
    EXPECT_EQ(lectures().front().minutes, 75);
    const Lesson lecture = *load_lesson("viewing-75");
    EXPECT_EQ(lecture.minutes, 75);
    std::vector<bool> has_slide(25);
    for (const LessonStep& step : lecture.steps)
        for (const int slide : step.slides) has_slide[static_cast<std::size_t>(slide)] = true;
    for (std::size_t slide = 2; slide <= 24; ++slide) EXPECT_TRUE(has_slide[slide]) << "slide " << slide;
}

TEST(LectureFile, TheNotesTellThePartAndTheClock) {
    LessonRun run(lecture_from(small_lecture), 2);  // planned from 4 min to 6 min
    const auto place_at = [&](double minutes) { return notes_of(run, StepPhase::asks, {}, minutes * 60.0).place; };
    EXPECT_EQ(place_at(5), "part 2 / 3, 4 min · step 2 / 2 · asking · 5 of 18 min, 13 left · on time");
    EXPECT_TRUE(place_at(1).ends_with("3 min ahead")) << place_at(1);
    EXPECT_TRUE(place_at(9).ends_with("3 min behind")) << place_at(9);
    EXPECT_FALSE(notes_of(run, StepPhase::asks, {}, 7.5 * 60.0).is_late);
    EXPECT_TRUE(notes_of(run, StepPhase::asks, {}, 8.5 * 60.0).is_late);
    EXPECT_EQ(notes_of(run, StepPhase::asks, {}, 0.0).parts.back().text.substr(0, 22), "perspective(45, 1, 0.1");
}

TEST(LessonEnds, EachLessonEndsWithThreeSentencesInBothLanguagesAndAnExercise) {
    for (const LessonFile& file : lessons()) {
        const Lesson lesson = *load_lesson(file.path.string());
        ASSERT_EQ(lesson.end.says.size(), 3U) << lesson.id;
        for (const LessonText& said : lesson.end.says) {
            EXPECT_LE(said.in_english().size(), 110U) << said.in_english();
            EXPECT_TRUE(said.in_english().ends_with('.')) << said.in_english();
            EXPECT_NE(said.in(Language::ko), said.in_english());
        }
        EXPECT_FALSE(exercise_title(lesson.end.exercise).empty()) << lesson.end.exercise;
    }
}

TEST(LessonEnds, ACardFollowsTheLastStepAndEachLessonOfALecture) {
    LessonRun lesson(*load_lesson("rays"));
    EXPECT_EQ(lesson.end(), nullptr);
    lesson.show_end(true);
    EXPECT_FALSE(lesson.shows_end()) << "no card follows the first step";
    lesson.go_to(3);
    ASSERT_NE(lesson.end(), nullptr);
    lesson.show_end(true);
    EXPECT_TRUE(lesson.shows_end());
    lesson.go_to(0);
    EXPECT_FALSE(lesson.shows_end());
    LessonRun lecture(lecture_from(small_lecture));
    std::vector<bool> ends;
    for (std::size_t step = 0; step < lecture.lesson().steps.size(); ++step) {
        lecture.go_to(step);
        ends.push_back(lecture.end() != nullptr);
    }
    EXPECT_EQ(std::count(ends.begin(), ends.end(), true), 1) << "a preset has no card, and the last part asks for none";
    EXPECT_TRUE(ends[2]);
}

TEST(LessonEnds, AnUnknownExerciseOrAMissingSentenceIsRefused) {
    const auto trouble = [](const std::string& end) {
        const std::string text = R"({"lesson": 1, "id": "a", "title": "A", "end": )" + end + R"(, "steps": []})";
        return parse_lesson(text, "a.json", "").error();
    };
    EXPECT_EQ(trouble(R"({"says": ["A.", "B."]})"), "a.json: end.says: must have three sentences");
    EXPECT_EQ(trouble(R"({"says": ["A.", "B.", ""]})"), "a.json: end.says[2]: must not be empty");
    EXPECT_EQ(trouble(R"({"says": ["A.", "B.", "C."], "exercise": "E01-view-matrx"})"),
              "a.json: end.exercise: there is no exercise E01-view-matrx; did you mean E01-view-matrix?");
}

TEST(Slides, EachSlideHasAPresetAndASlideWithContentHasASearch) {
    const std::vector<NamedFile> all_presets = presets();
    const std::vector<LessonFile> all_lessons = lessons();
    for (int slide = 2; slide <= 24; ++slide) {
        const auto is_there = [slide](const std::vector<int>& slides) {
            return std::find(slides.begin(), slides.end(), slide) != slides.end();
        };
        const bool has_preset = std::any_of(all_presets.begin(), all_presets.end(),
                                            [&](const NamedFile& preset) { return is_there(preset.slides); });
        const bool has_step = std::any_of(all_lessons.begin(), all_lessons.end(), [&](const LessonFile& lesson) {
            return std::any_of(lesson.listed_steps.begin(), lesson.listed_steps.end(),
                               [&](const LessonFile::Step& step) { return is_there(step.slides); });
        });
        EXPECT_TRUE(has_preset || has_step) << "slide " << slide;
        const std::set<int> needs_preset = {5, 15, 16, 19, 23};
        EXPECT_TRUE(has_preset || !needs_preset.contains(slide)) << "slide " << slide;
    }
    EXPECT_EQ(searched_slide("s12"), 12);
    EXPECT_EQ(searched_slide("Slide 7"), 7);
    for (const char* other : {"shadow", "s", "s12b", "12", "", "s 1234"}) EXPECT_FALSE(searched_slide(other)) << other;
}

/// The mirror cuts no object, so slide 23's three matrices can be shown one by one.
TEST(Slides, TheCoordinatePlanesCutNoObject) {
    const char* const names[] = {"mirror-yz", "mirror-xz", "mirror-xy"};
    for (int axis = 0; axis < 3; ++axis) {
        const Result<LoadedState> state = load_state(names[axis]);
        ASSERT_TRUE(state) << state.error();
        const Scene scene = *load_scene(state->params.scene, state->base);
        EXPECT_EQ(state->params.planes.front().equation[axis], 1.0);
        EXPECT_EQ(state->params.planes.front().equation.w, 0.0);
        EXPECT_GT(scene.bounds_world.min[axis], 0.0) << names[axis];
        EXPECT_GT(state->params.camera.position[axis], 0.0) << "the eye is on the objects' side";
    }
}

}  // namespace
}  // namespace viewing
