// When a goal is measured in pictures, the window judges it in the background, with the same result as `grade`. The
// tests need no reference pictures.
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include "app/studio.h"
#include "gl/gl_test.h"
#include "grading/grading.h"
#include "grading/state_numbers.h"
#include "lesson/exercise.h"
#include "lesson/questions/judge.h"
#include "platform/file.h"

namespace viewing {
namespace {

/// A window that shows exercise E14, in which the student fixes decals and the judge counts pixels.
class AnswerJudgeTest : public testing::GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        const Result<LoadedState> state = load_state("");
        ASSERT_TRUE(state) << state.error();
        const Result<Scene> scene = load_scene(state->params.scene, state->base, state->params.coplanar);
        ASSERT_TRUE(scene) << scene.error();
        studio_ = std::make_unique<Studio>(renderer(), Session(*state, *scene));
        Result<std::vector<Exercise>> exercises = of_set(*load_exercises({}), "E14");
        ASSERT_TRUE(exercises) << exercises.error();
        const Result<Lesson> made = sheet(*exercises, "viewing-2026", "32201234", numbers_at_start(&renderer()));
        ASSERT_TRUE(made) << made.error();
        studio_->workbench.guide.begin(*made, 0, studio_->session);
        frames_until([&] { return !studio_->session.loading_fraction() && ++settled_ > 5; });
    }
    void TearDown() override {
        studio_.reset();
        GlTest::TearDown();
    }

    /// Runs frames until the condition holds; returns false if it does not hold within five minutes.
    template <typename Done>
    bool frames_until(const Done& done) {
        const auto begun = std::chrono::steady_clock::now();
        while (std::chrono::steady_clock::now() - begun < std::chrono::minutes(5)) {
            FrameInput input;
            input.dt_s = frame_s_;
            studio_->frame({.size_px = {1280, 720}, .device_scale = 1.0, .shows_time = true, .input = input});
            if (done()) return true;
            // As in the real window, work in the background has the processor to itself until the next frame is due.
            std::this_thread::sleep_for(std::chrono::duration<double>(std::clamp(studio_->redraw_in_s(), 0.001, 0.05)));
        }
        return false;
    }
    void set_units(double units) { studio_->session.params.depth.offset.units = units; }
    bool is_checking() const { return studio_->workbench.is_checking; }
    const LessonRun& run() { return *studio_->workbench.guide.run(); }

    std::unique_ptr<Studio> studio_;
    int settled_ = 0;
    double frame_s_ = 1.0 / 60.0;
};

TEST_F(AnswerJudgeTest, ChecksInTheBackgroundAsGradeDoes) {
    EXPECT_FALSE(run().verdict()) << "nothing was changed";
    set_units(-40.0);
    ASSERT_TRUE(frames_until([&] { return is_checking(); }));
    EXPECT_FALSE(run().verdict()) << "no verdict is shown during the check";
    EXPECT_GE(studio_->redraw_in_s(), 0.0);
    ASSERT_TRUE(frames_until([&] { return !is_checking(); }));
    ASSERT_TRUE(run().verdict()) << run().trouble();
    EXPECT_EQ(run().verdict()->tag, "M14");
    Attempt attempt;
    attempt.is_goal = true;
    attempt.settings = {"depth.offset.units=-40"};
    EXPECT_EQ(*run().verdict(), *judge_attempt(run().step(), attempt, &renderer()));

    set_units(-0.75);
    ASSERT_TRUE(frames_until([&] { return run().is_revealed(); }));
    EXPECT_TRUE(run().verdict()->right);
    EXPECT_FALSE(is_checking());
}

/// A file that was changed by hand gets a reason, not only "wrong".
TEST_F(AnswerJudgeTest, SaysWhyAnAnswerIsNone) {
    const auto said = [&](const Attempt& attempt) {
        return judge_attempt(run().step(), attempt, &renderer())->say.in_english();
    };
    const auto goal = [](const std::string& setting) {
        Attempt attempt;
        attempt.is_goal = true;
        attempt.settings = {setting};
        return attempt;
    };
    EXPECT_NE(said(goal("depth.format=d32f")).find("depth.format, which the exercise does not allow"),
              std::string::npos);
    EXPECT_NE(said(goal("depth.offset.unit=1")).find("no such field"), std::string::npos)
        << said(goal("depth.offset.unit=1"));
    Attempt number;
    number.answer = {1.0};
    EXPECT_NE(said(number).find("needs a state"), std::string::npos);
}

TEST_F(AnswerJudgeTest, ForgetsObsoleteQuestions) {
    set_units(-0.75);
    ASSERT_TRUE(frames_until([&] { return is_checking(); }));
    set_units(-40.0);  // before the right answer is judged
    ASSERT_TRUE(frames_until([&] { return !is_checking() && run().verdict().has_value(); }));
    EXPECT_FALSE(run().is_revealed());
    EXPECT_EQ(run().verdict()->tag, "M14");

    set_units(-0.75);
    ASSERT_TRUE(frames_until([&] { return is_checking(); }));
    studio_->workbench.guide.leave();
    for (int frame = 0; frame < 50; ++frame)
        studio_->frame({.size_px = {1280, 720}, .device_scale = 1.0, .shows_time = true, .input = {}});
    EXPECT_FALSE(is_checking());
    EXPECT_FALSE(run().is_revealed());
    studio_->workbench.guide.resume(studio_->session);
    ASSERT_EQ(studio_->session.params.depth.offset.units, -0.75) << "unchanged since the user left the question";
    EXPECT_TRUE(frames_until([&] { return run().is_revealed(); })) << "the abandoned question is asked again";
}

/// A change soon after a save is saved later. The window must wake for that, since perhaps no input wakes it.
TEST_F(AnswerJudgeTest, TheWindowWakesToSaveChanges) {
    std::string folder = (std::filesystem::temp_directory_path() / "viewing-answers-XXXXXX").string();
    ASSERT_NE(mkdtemp(folder.data()), nullptr);
    ExerciseDesk& exercises = studio_->workbench.exercises.desk;
    exercises.keep_in(folder, "test");
    exercises.sit_down({"viewing-2026", "32201234", "Kim"});
    const std::filesystem::path file = std::filesystem::path(folder) / answers_file_name(exercises.student());
    const auto is_written = [&](const std::string& number) {
        const Result<std::string> text = read_text_file(file);
        return text && text->find(number) != std::string::npos;
    };
    frame_s_ = 1e-4;
    set_units(-40.5);
    ASSERT_TRUE(frames_until([&] { return is_written("-40.5"); }));
    set_units(-41.5);
    EXPECT_TRUE(frames_until([&] { return !is_checking() && studio_->redraw_in_s() > 0.1; }));
    EXPECT_LE(studio_->redraw_in_s(), 0.3) << "these frames took none of the window's time";
    EXPECT_TRUE(exercises.finish());
    std::filesystem::remove_all(folder);
}

/// The product of the tiles depends on their order and on the state; tiles in the right order multiply to C.
TEST_F(AnswerJudgeTest, TheProductOfTilesFollowsTheirOrderAndTheState) {
    Guide& guide = studio_->workbench.guide;
    const Result<Lesson> walk = load_lesson("fly-and-walk");
    ASSERT_TRUE(walk) << walk.error();
    guide.begin(*walk, walk->steps.size() - 1, studio_->session);
    const auto is_told = [&] {
        return run().products().at == studio_->session.params && !run().products().matrices.empty();
    };
    const auto off_camera = [&](const glm::dmat4& product) {
        const glm::dmat4 c =
            world_from_view(studio_->session.params.camera.position, studio_->session.params.camera.angles());
        double off = 0.0;
        for (int i = 0; i < 16; ++i) off = std::max(off, std::abs(product[i / 4][i % 4] - c[i / 4][i % 4]));
        return off;
    };
    ASSERT_TRUE(frames_until(is_told));
    ASSERT_EQ(run().products().matrices.size(), 4U);
    EXPECT_GT(off_camera(run().products().matrices.back()), 0.1) << "the tiles start in a wrong order";
    guide.run()->answer().items = {3, 1, 0, 2};
    ASSERT_TRUE(frames_until([&] { return run().products().items == guide.run()->answer().items; }));
    EXPECT_LT(off_camera(run().products().matrices.back()), 1e-12);
    studio_->session.params.camera.yaw = -70.0;
    ASSERT_TRUE(frames_until(is_told));
    EXPECT_LT(off_camera(run().products().matrices.back()), 1e-12);
}

class AnswerJudgeSlowTest : public AnswerJudgeTest {};

/// A revealed question shows its own right answer, even if the right answer of the question that the user has just left
/// is still being measured.
TEST_F(AnswerJudgeSlowTest, RevealedQuestionsGetTheirRightAnswer) {
    Guide& guide = studio_->workbench.guide;
    const auto reveal = [&](const Lesson& lesson, std::size_t step) {
        guide.begin(lesson, step, studio_->session);
        frames_until([&] { return !studio_->session.loading_fraction(); });
        guide.reveal(studio_->session);
    };
    const auto has_model = [&] { return guide.run()->model().has_value(); };
    const Result<Lesson> camera = load_lesson("view-is-the-inverse");
    ASSERT_TRUE(camera) << camera.error();
    reveal(*camera, 1);
    ASSERT_TRUE(frames_until(has_model));
    EXPECT_EQ(guide.run()->model()->numbers, (std::vector<double>{-2, -1, -10}));

    const Result<Lesson> rays = load_lesson("rays"), sides = load_lesson("two-sides");
    ASSERT_TRUE(rays && sides);
    ASSERT_TRUE(is_measured(rays->steps[0].ask) && is_measured(sides->steps[1].ask));
    reveal(*rays, 0);
    frames_until([] { return true; });
    EXPECT_FALSE(has_model()) << "it is being measured";
    reveal(*sides, 1);
    ASSERT_TRUE(frames_until(has_model));
    EXPECT_EQ(guide.run()->model()->numbers, std::vector<double>{2012}) << "not the rays'";
}

/// For an offscreen picture, the judge blocks until it has a verdict, so the strip shows it from the first frame on.
TEST_F(AnswerJudgeTest, APictureHasTheVerdictImmediately) {
    set_units(-40.0);
    studio_->frame({.size_px = {1280, 720}, .input = {}});
    EXPECT_FALSE(is_checking());
    ASSERT_TRUE(run().verdict());
    EXPECT_EQ(run().verdict()->tag, "M14");
}

}  // namespace
}  // namespace viewing
