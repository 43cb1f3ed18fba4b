// Answer fields: formulas, texts that are not numbers, and Enter. Also tests what an unsolved question hides.
#include <gtest/gtest.h>

#include "exercise_desk.h"

namespace viewing::test {
namespace {

class AnswerFields : public ::testing::Test {
protected:
    void type(const char* field, const char* text) {
        ui.double_click(field);
        ui.type(text);
        ui.key(ImGuiKey_Tab);
        ui.key(ImGuiKey_Escape);  // leaves the next field
        ui.frames(2);
    }
    std::string told() { return ui.has("lesson strip/trouble") ? ui.text_of("lesson strip/trouble") : ""; }

    ExerciseSheetDesk desk{{1600, 900}};
    widgets::test::Harness& ui = desk.ui;
};

TEST_F(AnswerFields, TakeFormulas) {
    desk.begin("E17-shadow-point");
    type("lesson strip/answers/answer/x", "4/2.5");
    type("lesson strip/answers/answer/y", "-sqrt(16)");
    EXPECT_EQ(desk.run().answer().numbers[0], 1.6);
    EXPECT_EQ(desk.run().answer().numbers[1], -4.0);
    desk.begin("E16-shadow-matrix");
    type("lesson strip/answers/answer/r1c2", "9/4");
    EXPECT_EQ(desk.run().answer().numbers[6], 2.25);
}

TEST_F(AnswerFields, SayWhatCannotBeReadAndAreNotJudged) {
    desk.begin("E17-shadow-point");
    const char* const x = "lesson strip/answers/answer/x";
    type(x, "4 over 2");
    EXPECT_EQ(ui.text_of(x), "4 over 2") << "the typed text stays";
    EXPECT_TRUE(ui.has("lesson strip/trouble"));
    EXPECT_EQ(desk.run().first_unread(), "4 over 2");
    bool is_judged = false;
    const auto press_check = [&] {
        ui.hover("lesson strip/Check");
        ui.press(0);
        is_judged |= desk.requests.check_answer;
        ui.release(0);
        is_judged |= desk.requests.check_answer;
    };
    press_check();
    EXPECT_FALSE(is_judged);
    type(x, "4/2");
    EXPECT_EQ(desk.run().answer().numbers[0], 2.0);
    EXPECT_FALSE(ui.has("lesson strip/trouble"));
    press_check();
    EXPECT_TRUE(is_judged);
}

TEST_F(AnswerFields, CheckOnEnterInTheLastOne) {
    desk.begin("E17-shadow-point");
    const std::size_t count = desk.run().answer().numbers.size();
    ASSERT_EQ(count, 3U);
    const auto checks_after = [&](const char* field, const char* text) {
        ui.double_click(field);
        ui.type(text);
        widgets::test::key_down(ImGuiKey_Enter) = true;
        ui.frame();
        const bool is_checked = desk.requests.check_answer;
        widgets::test::key_down(ImGuiKey_Enter) = false;
        ui.frames(2);
        return is_checked;
    };
    EXPECT_FALSE(checks_after("lesson strip/answers/answer/x", "1"));
    EXPECT_TRUE(checks_after("lesson strip/answers/answer/z", "1"));
    EXPECT_FALSE(checks_after("lesson strip/answers/answer/z", "one"));
}

TEST_F(AnswerFields, TroubleWithPastedNumbersEndsWithItsExercise) {
    desk.begin("E16-shadow-matrix");
    desk.clipboard = "1 2 3";
    desk.press_with(Key::ctrl, Key::v);
    EXPECT_NE(desk.run().trouble().find("3 numbers"), std::string::npos);
    EXPECT_TRUE(ui.has("lesson strip/trouble"));
    EXPECT_EQ(desk.session.message.text.find("numbers"), std::string::npos);
    desk.press(Key::page_down);
    desk.settle();
    EXPECT_FALSE(ui.has("lesson strip/trouble"));
    desk.press(Key::page_up);
    desk.settle();
    EXPECT_FALSE(ui.has("lesson strip/trouble"));
}

TEST_F(AnswerFields, ExploringAnUnsolvedExerciseUncoversNothing) {
    desk.begin("E16-shadow-matrix");
    ASSERT_EQ(ui.text_of("matrices/S"), "?");
    desk.click("lesson strip/Explore freely");
    ui.frames(3);
    ASSERT_FALSE(desk.workbench.guide.is_shown());
    EXPECT_FALSE(ui.has("matrices/S/r0c0"));
    EXPECT_EQ(ui.text_of("matrices/S"), "?");
    EXPECT_NE(desk.session.message.text.find("stay hidden"), std::string::npos);
    desk.workbench.guide.run()->reveal();
    ui.frames(3);
    EXPECT_TRUE(ui.has("matrices/S/r0c0")) << "a solved exercise hides nothing";
    desk.workbench.guide.run()->cover();
    ui.frames(3);
    EXPECT_FALSE(ui.has("matrices/S/r0c0"));
    desk.workbench.guide.close();
    ui.frames(3);
    EXPECT_TRUE(ui.has("matrices/S/r0c0"));
}

TEST_F(AnswerFields, AGoalShowsItsNumbers) {
    desk.begin("E04-place-the-camera");
    desk.run().progress().numbers = {"(0.2, 0, −6.1)"};
    ui.frames(2);
    ASSERT_TRUE(ui.has("lesson strip/progress"));
    const LessonStep& step = desk.run().step();
    ASSERT_EQ(step.ask.progress.size(), 1U);
    EXPECT_EQ(step.ask.progress[0].needed.in_english().substr(0, 10), "(0, 0, −");
    EXPECT_LE(ui.find("lesson strip/progress").max.y, desk.layout().strip.max.y);
}

TEST(ALessonsButtons, AHintMovesNothing) {
    Desk desk({1600, 900});
    desk.workbench.guide.begin(*load_lesson("view-is-the-inverse"), 7, desk.session);
    desk.settle();
    desk.apply_looks();
    desk.ui.frames(3);
    EXPECT_TRUE(desk.ui.has("camera/position/x")) << "the id does not depend on the label";
    const float top = desk.layout().strip.min.y, button = desk.ui.find("lesson strip/All steps").min.y;
    while (desk.ui.has("lesson strip/Hint")) {
        desk.ui.click("lesson strip/Hint");
        desk.ui.frames(30);
    }
    EXPECT_EQ(desk.layout().strip.min.y, top);
    EXPECT_EQ(desk.ui.find("lesson strip/All steps").min.y, button);
    EXPECT_LE(desk.ui.find("lesson strip/hint").max.y, desk.layout().strip.max.y);
}

TEST(ALessonsButtons, AWalkersLampsRefuseTheKeysOfFlying) {
    Desk desk({1600, 900});
    desk.session.params.camera.navigation = Navigation::walk;
    desk.hold(Key::r);
    desk.ui.frame();
    EXPECT_EQ(desk.ui.text_of("camera/degrees of freedom/up/down"), "refused");
    desk.let_go(Key::r);
    desk.ui.frames(2);
    EXPECT_EQ(desk.ui.text_of("camera/degrees of freedom/up/down"), "absent");
    desk.hold(Key::w);
    desk.ui.frame();
    EXPECT_EQ(desk.ui.text_of("camera/degrees of freedom/forward"), "active");
    desk.let_go(Key::w);
}

TEST(ALessonsButtons, TilesMoveAndDoNotSwap) {
    Desk lesson_desk({1600, 900});
    lesson_desk.workbench.guide.begin(*load_lesson("rays"), 3, lesson_desk.session);
    lesson_desk.settle();
    lesson_desk.apply_looks();
    lesson_desk.ui.frames(3);
    LessonRun& run = *lesson_desk.workbench.guide.run();
    ASSERT_EQ(run.step().ask.kind, AskKind::order);
    ASSERT_EQ(run.answer().items, (std::vector<int>{0, 1, 2}));
    const RecordedItem from = lesson_desk.ui.find("lesson strip/answers/item 1");
    const RecordedItem to = lesson_desk.ui.find("lesson strip/answers/item 3");
    const ImVec2 begin((from.min.x + from.max.x) * 0.5F, (from.min.y + from.max.y) * 0.5F);
    lesson_desk.drag_from(begin, (to.min.x + to.max.x) * 0.5F - begin.x, (to.min.y + to.max.y) * 0.5F - begin.y, 8);
    EXPECT_EQ(run.answer().items, (std::vector<int>{1, 2, 0}));
}

TEST(ALessonsButtons, ADoubleClickOnNextDoesNotAnswerTheNextStep) {
    Desk desk({1600, 900});
    desk.workbench.guide.begin(*load_lesson("view-is-the-inverse"), 0, desk.session);
    desk.workbench.guide.moves = false;
    desk.workbench.guide.run()->reveal();
    desk.settle();
    desk.apply_looks();
    desk.ui.frames(60);
    desk.ui.double_click("lesson strip/Next ▸");
    desk.settle();
    EXPECT_EQ(desk.workbench.guide.run()->index(), 1U);
    EXPECT_FALSE(desk.workbench.guide.run()->is_revealed());
    desk.ui.frames(60);
    desk.ui.click("lesson strip/Show the answer");
    desk.settle();
    EXPECT_TRUE(desk.workbench.guide.run()->is_revealed());
}

}  // namespace
}  // namespace viewing::test
