// Answers that can be read off the window before the question is answered, in texts placed by hand.
#include "lesson/questions/seen_answer.h"

#include <gtest/gtest.h>

namespace viewing {
namespace {

/// Returns a text in a 10-pixel font. Its baseline is at y = 20 × `row`, its left edge at x = 100 × `column`, in px.
SeenText text_at(const std::string& text, int row, int column = 0, const std::string& place = "there") {
    const float left = 100.0F * static_cast<float>(column);
    return {text, place, left, left + 60.0F, 20.0F * static_cast<float>(row), 10.0F};
}

LessonStep step_of(AskKind kind) {
    LessonStep step;
    step.ask.kind = kind;
    return step;
}

std::size_t found(const LessonStep& step, const Answer& right, const std::vector<SeenText>& texts) {
    return seen_answers(step, right, texts).size();
}

TEST(SeenAnswer, ANumberIsFoundWithTheDigitsShown) {
    const LessonStep step = step_of(AskKind::number);
    const Answer right{{-1.3684}, {}};
    EXPECT_EQ(seen_answers(step, right, {text_at("t = −1.368 here", 0, 0, "a/b")}),
              std::vector<std::string>{"the answer -1.3684 can be read beforehand: −1.368 in a/b"});
    EXPECT_EQ(found(step, right, {text_at("-1.37", 0)}), 1U) << "the keyboard's minus";
    EXPECT_EQ(found(step, right, {text_at("−1.4", 0)}), 0U) << "two digits are too few";
    EXPECT_EQ(found(step, right, {text_at("1.368", 0)}), 0U) << "another sign";
    EXPECT_EQ(found(step, right, {text_at("−1.369", 0)}), 0U) << "another number, although it would be accepted";
    EXPECT_EQ(found(step, right, {text_at("−1.3685·10⁻⁷", 0)}), 0U);
    EXPECT_EQ(found(step, {{230400}, {}}, {text_at("230,400", 0)}), 1U);
    EXPECT_EQ(found(step, {{240}, {}}, {text_at("d240, x_240", 0)}), 0U) << "digits in names";
    EXPECT_EQ(found(step, {{5}, {}}, {text_at("5.00", 0)}), 0U) << "zeros at the end are no significant digits";
    EXPECT_EQ(found(step, {{0.25}, {}}, {text_at("0.25", 0)}), 0U);
    EXPECT_EQ(found(step, {{0.125}, {}}, {text_at("(0.125, 0.125)", 0)}), 1U) << "reported once for each place";
}

TEST(SeenAnswer, WhatTheStepSaysAndItsOwnControlsAreNoFindings) {
    LessonStep step = step_of(AskKind::number);
    const Answer right{{255}, {}};
    const std::vector<SeenText> texts{text_at("255", 0, 0, "light/position/x")};
    EXPECT_EQ(found(step, right, texts), 1U);
    step.start.params.view.layout.controls = {"light.pos"};
    EXPECT_EQ(found(step, right, texts), 1U) << "another control";
    step.start.params.view.layout.controls = {"light.position"};
    EXPECT_EQ(found(step, right, texts), 0U);
    step.start.params.view.layout.controls = {};
    step.ask.question.by_language[0] = "Codes are 0 to 255. Which one is farthest?";
    EXPECT_EQ(found(step, right, texts), 0U);
}

TEST(SeenAnswer, AVectorIsFoundInARowOrAColumn) {
    const LessonStep step = step_of(AskKind::vector);
    const Answer right{{-2, -1, -10}, {}};
    EXPECT_EQ(found(step, right, {text_at("(−2, −1, −10)", 0)}), 1U);
    EXPECT_EQ(found(step, right, {text_at("−10.0", 0, 3), text_at("−2.0", 0, 1), text_at("−1.0", 0, 2)}), 1U);
    EXPECT_EQ(found(step, right, {text_at("−2", 1, 3), text_at("−1", 2, 3), text_at("−10", 3, 3)}), 1U);
    EXPECT_EQ(found(step, right, {text_at("−2", 1, 3), text_at("−10", 2, 3), text_at("−1", 3, 3)}), 0U);
    EXPECT_EQ(found(step, right, {text_at("−2", 1, 1), text_at("−1", 2, 2), text_at("−10", 3, 3)}), 0U);
    EXPECT_EQ(found(step, right, {text_at("−2", 0, 1), text_at("7", 0, 2), text_at("−1, −10", 0, 3)}), 0U);
    EXPECT_EQ(found(step, {{0, 1, 0}, {}}, {text_at("0, 1, 0", 0)}), 0U) << "an axis is everywhere";
    EXPECT_EQ(found(step, {{0, 4, 0}, {}}, {text_at("0, 4, 0", 0)}), 0U) << "so is a multiple of an axis";
}

TEST(SeenAnswer, AMatrixIsFoundByItsRows) {
    LessonStep step = step_of(AskKind::matrix);
    step.ask.rows = step.ask.columns = 2;
    const Answer right{{4, -3, 0, 1}, {}};
    EXPECT_EQ(found(step, right, {text_at("4", 0, 0), text_at("−3", 0, 1)}), 1U);
    EXPECT_EQ(found(step, right, {text_at("0", 0, 0), text_at("1", 0, 1)}), 0U) << "a row of the identity";
}

TEST(SeenAnswer, AChoiceIsFoundIfNoOtherIsVisible) {
    LessonStep step = step_of(AskKind::choice);
    step.ask.choices = {{{{"the torus", ""}}, true, {}, ""}, {{{"the box", ""}}, false, {}, ""}};
    EXPECT_EQ(found(step, {{}, {0}}, {text_at("the torus", 0)}), 1U);
    EXPECT_EQ(found(step, {{}, {0}}, {text_at("the torus and more", 0)}), 0U) << "part of a sentence";
    EXPECT_EQ(found(step, {{}, {0}}, {text_at("the torus", 0), text_at("or the box?", 1)}), 0U) << "a list of names";
    step.ask.choices = {{{{"at 2.25 units", ""}}, true, {}, ""}, {{{"at 4.75 units", ""}}, false, {}, ""}};
    EXPECT_EQ(found(step, {{}, {0}}, {text_at("z = 2.25", 0)}), 1U);
    EXPECT_EQ(found(step, {{}, {0}}, {text_at("z = 4.75", 0)}), 0U);
}

TEST(SeenAnswer, AnOrderIsFoundInAListOfNames) {
    LessonStep step = step_of(AskKind::order);
    step.ask.items = {{{"red", ""}}, {{"blue", ""}}, {{"green", ""}}};
    const Answer right{{}, {2, 0, 1}};
    EXPECT_EQ(found(step, right, {text_at("green", 0), text_at("far", 1), text_at("red", 2), text_at("blue", 3)}), 1U);
    EXPECT_EQ(found(step, right, {text_at("red", 0), text_at("blue", 1), text_at("green", 2)}), 0U);
}

}  // namespace
}  // namespace viewing
