// Fields for answers: formulas, texts that are no numbers, Enter; and what an unsolved question does not give away.
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
    EXPECT_EQ(ui.text_of(x), "4 over 2") << "nothing is thrown away";
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
    EXPECT_NE(desk.session.message.text.find("stays covered"), std::string::npos);
    desk.workbench.guide.run()->reveal();
    ui.frames(3);
    EXPECT_TRUE(ui.has("matrices/S/r0c0")) << "a solved exercise covers nothing";
    desk.workbench.guide.run()->cover();
    ui.frames(3);
    EXPECT_FALSE(ui.has("matrices/S/r0c0"));
    desk.workbench.guide.close();
    ui.frames(3);
    EXPECT_TRUE(ui.has("matrices/S/r0c0"));
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
