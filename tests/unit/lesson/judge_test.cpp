// Answers that are right, wrong in a known way, or just wrong; and one student's run through a lesson.
#include "lesson/questions/judge.h"

#include <gtest/gtest.h>

#include "lesson/lesson_run.h"

namespace viewing {
namespace {

Surroundings yaw_of(double yaw) {
    Surroundings result;
    result.look_up = [yaw](const std::string&, std::span<const double>) -> Result<Json> {
        return Json{{"yaw", yaw}, {"position", {1, 2, 4}}};
    };
    return result;
}

Verdict judged(const Ask& ask, const Answer& answer, double yaw = 10.0) {
    const Result<Verdict> verdict = judge(ask, answer, yaw_of(yaw));
    EXPECT_TRUE(verdict) << (verdict ? "" : verdict.error());
    return verdict ? *verdict : Verdict{};
}

TEST(Judge, NumberIsRightWithinItsTolerance) {
    Ask ask;
    ask.kind = AskKind::number;
    ask.expect = "camera.yaw";
    ask.tolerance = 0.5;
    ask.wrong.push_back({"answer == -camera.yaw", {"the sign", ""}, "M02", {}, {}});
    EXPECT_TRUE(judged(ask, {{10.49}, {}}).right);
    EXPECT_FALSE(judged(ask, {{10.51}, {}}).right);
    EXPECT_EQ(judged(ask, {{-10.0}, {}}).tag, "M02");
    EXPECT_TRUE(judged(ask, {{7.0}, {}}).say.empty());
    EXPECT_FALSE(judged(ask, {{std::nan("")}, {}}).right);
    EXPECT_FALSE(judged(ask, {}).right) << "no number was entered";
    ask.tolerance = 0.0;
    ask.relative_tolerance = 0.1;
    EXPECT_TRUE(judged(ask, {{10.9}, {}}).right);
    EXPECT_FALSE(judged(ask, {{11.1}, {}}).right);
}

TEST(Judge, VectorMayBeRightUpToAFactor) {
    Ask ask;
    ask.kind = AskKind::vector;
    ask.rows = 3;
    ask.expect = "camera.position";
    EXPECT_TRUE(judged(ask, {{1, 2, 4}, {}}).right);
    EXPECT_FALSE(judged(ask, {{2, 4, 8}, {}}).right);
    ask.up_to_factor = true;
    EXPECT_TRUE(judged(ask, {{-2, -4, -8}, {}}).right);
    EXPECT_FALSE(judged(ask, {{0, 0, 0}, {}}).right);
    EXPECT_FALSE(judged(ask, {{2, 4, 9}, {}}).right);
}

TEST(Judge, TilesCountInOrderOrAsASet) {
    Ask ask;
    ask.kind = AskKind::product;
    ask.items = {{"A", ""}, {"B", ""}, {"C", ""}};
    ask.expected_items = {{2, 0, 1}, {2, 1, 0}};
    ask.wrong.push_back({"", {"the other way", ""}, "M03", {{}, {1, 0, 2}}, {}});
    EXPECT_TRUE(judged(ask, {{}, {2, 0, 1}}).right);
    EXPECT_TRUE(judged(ask, {{}, {2, 1, 0}}).right);
    EXPECT_EQ(judged(ask, {{}, {1, 0, 2}}).tag, "M03");
    ask.kind = AskKind::subset;
    EXPECT_TRUE(judged(ask, {{}, {1, 2, 0}}).right);
    EXPECT_FALSE(judged(ask, {{}, {1, 2}}).right);
}

TEST(Judge, AWrongNumberIsRelatedToTheRightOne) {
    Ask ask;
    ask.kind = AskKind::number;
    ask.tolerance = 0.01;
    const auto told = [&](double typed) { return judged(ask, {{typed}, {}}).near; };
    ask.expect = "30";
    EXPECT_EQ(told(15), Near::half);
    EXPECT_EQ(told(60), Near::twice);
    EXPECT_EQ(told(0.0333), Near::reciprocal);
    EXPECT_EQ(told(0.5236), Near::radians) << "π/6";
    EXPECT_EQ(told(300), Near::decimal);
    EXPECT_EQ(told(0.3), Near::decimal);
    EXPECT_EQ(told(-30), Near::sign);
    EXPECT_EQ(told(0), Near::nothing);
    EXPECT_EQ(told(15.1), Near::nothing) << "nearly half of it is not half of it";
    EXPECT_EQ(told(61), Near::nothing);
    ask.expect = "0.5236";
    EXPECT_EQ(told(30), Near::degrees);
    ask.expect = "0";
    EXPECT_EQ(told(7), Near::nothing);
}

TEST(Judge, AnUnknownWrongAnswerHasRightParts) {
    Ask ask;
    ask.kind = AskKind::vector;
    ask.rows = 3;
    ask.expect = "camera.position";  // (1, 2, 4)
    const auto told = [&](const Answer& answer) {
        const Verdict verdict = judged(ask, answer);
        return std::pair(verdict.near, verdict.places);
    };
    const auto is = [](Near near, std::vector<int> places) { return std::pair(near, std::move(places)); };
    EXPECT_EQ(told({{1, 2, -4}, {}}), is(Near::sign, {3}));
    EXPECT_EQ(told({{-1, 2, -4}, {}}), is(Near::sign, {1, 3}));
    EXPECT_EQ(told({{1, 7, 4}, {}}), is(Near::right_parts, {1, 3}));
    EXPECT_EQ(told({{3, 6, 12}, {}}), is(Near::factor, {}));
    EXPECT_EQ(told({{5, 6, 7}, {}}), is(Near::nothing, {}));
    ask.up_to_factor = true;
    EXPECT_EQ(told({{2, 4, 9}, {}}), is(Near::right_parts, {1, 2}));
    ask = {};
    ask.kind = AskKind::matrix;
    ask.rows = ask.columns = 2;
    ask.expect = "{{1, 2}, {3, 4}}";
    EXPECT_EQ(told({{1, 2, 3, 5}, {}}), is(Near::right_parts, {1}));
    EXPECT_EQ(told({{1, -2, 3, 4}, {}}), is(Near::sign, {1}));
    ask = {};
    ask.kind = AskKind::number;
    ask.expect = "5";
    EXPECT_EQ(told({{-5}, {}}), is(Near::sign, {1}));
    EXPECT_EQ(told({{7}, {}}), is(Near::nothing, {}));
    ask = {};
    ask.kind = AskKind::order;
    ask.items = {{"A", ""}, {"B", ""}, {"C", ""}, {"D", ""}};
    ask.expected_items = {{2, 0, 1, 3}, {2, 3, 1, 0}};
    EXPECT_EQ(told({{}, {2, 3, 0, 1}}), is(Near::first_items, {2}));
    EXPECT_EQ(told({{}, {0, 1, 2, 3}}), is(Near::first_wrong, {}));
    ask.kind = AskKind::subset;
    ask.expected_items = {{1, 2}};
    EXPECT_EQ(told({{}, {2}}), is(Near::incomplete, {}));
    EXPECT_EQ(told({{}, {1, 3, 2}}), is(Near::too_many, {}));
    EXPECT_EQ(told({{}, {1, 3}}), is(Near::some_items, {1}));
    EXPECT_EQ(told({{}, {0, 3}}), is(Near::no_items, {}));
    EXPECT_EQ(told({{}, {}}), is(Near::nothing, {}));
    ask = {};
    ask.kind = AskKind::vector;
    ask.rows = 4;
    ask.expect = "{2, 4, 3, 1}";
    ask.up_to_factor = true;
    EXPECT_EQ(told({{5, 7, 9, 11}, {}}), is(Near::nothing, {})) << "any single number fits some factor";
    EXPECT_EQ(told({{4, 8, 9, 11}, {}}), is(Near::right_parts, {1, 2}));
    EXPECT_EQ(told({{2, 7, 9, 11}, {}}), is(Near::right_parts, {1})) << "right without a factor";
}

TEST(Judge, AGoalTellsItsNumbers) {
    Ask ask;
    ask.kind = AskKind::goal;
    ask.until = "camera.yaw > 90";
    ask.progress = {{{"yaw", ""}, "camera.yaw", {"more than 90", ""}},
                    {{"p", ""}, "camera.position", {"", ""}},
                    {{"none", ""}, "camera.position[7]", {"", ""}}};
    EXPECT_EQ(judged(ask, {}, 12.3456).progress, (std::vector<std::string>{"12.3", "(1, 2, 4)", "—"}));
}

TEST(Judge, GoalDependsOnTheStateAlone) {
    Ask ask;
    ask.kind = AskKind::goal;
    ask.until = "camera.yaw > 90";
    ask.wrong.push_back({"camera.yaw < 0", {"the other way", ""}, "", {}, {}});
    EXPECT_TRUE(judged(ask, {}, 91.0).right);
    EXPECT_EQ(judged(ask, {}, -5.0).say.in_english(), "the other way");
    EXPECT_TRUE(judged(ask, {}, 50.0).say.empty());
    ask.until = "camera.yaw";
    EXPECT_FALSE(judge(ask, {}, yaw_of(1.0)));
}

Lesson of_three() {
    Lesson lesson;
    lesson.steps.resize(3);
    for (LessonStep& step : lesson.steps) {
        step.ask.choices = {{{"no", ""}, false, {"because", ""}, "M01"}, {{"yes", ""}, true, {}, ""}};
        step.ask.hints = {{"one", ""}, {"two", ""}};
    }
    return lesson;
}

TEST(LessonRun, RemembersWrongChoices) {
    LessonRun run(of_three());
    run.answer().items = {0};
    run.take({});
    run.answer().items = {1};
    EXPECT_TRUE(run.is_tried(0));
    EXPECT_FALSE(run.is_tried(1));
    run.go_to(1);
    EXPECT_FALSE(run.is_tried(0));
}

TEST(LessonRun, RightAnswerRevealsAndWrongAnswerExplains) {
    LessonRun run(of_three());
    run.answer().items = {0};
    run.take(judged(run.step().ask, run.answer()));
    EXPECT_FALSE(run.is_revealed());
    EXPECT_EQ(run.verdict()->tag, "M01");
    EXPECT_EQ(run.verdict()->say.in_english(), "because");
    run.answer().items = {1};
    run.take(judged(run.step().ask, run.answer()));
    EXPECT_TRUE(run.is_revealed());
    EXPECT_TRUE(run.is_done(0));
    EXPECT_FALSE(run.is_done(1));
}

TEST(LessonRun, EachStepKeepsItsAnswer) {
    LessonRun run(of_three(), 99);
    EXPECT_TRUE(run.is_last()) << "a step beyond the end is clamped to the last";
    run.go_to(0);
    run.answer().items = {0};
    for (int i = 0; i < 5; ++i) run.show_hint();
    EXPECT_EQ(run.hints_shown(), 2);
    run.go_to(1);
    EXPECT_TRUE(run.answer().empty());
    EXPECT_EQ(run.hints_shown(), 0);
    run.go_to(0);
    EXPECT_EQ(run.answer().items, std::vector{0});
}

}  // namespace
}  // namespace viewing
