// Saving states as steps of a lesson, and the changes that a goal allows.
#include "lesson/append.h"

#include <gtest/gtest.h>

#include "lesson/allowed.h"
#include "lesson/lesson.h"

namespace viewing {
namespace {

TEST(SaveAsStep, TwoStepsReadBackToBothStates) {
    Params first, second;
    first.projection.near = 0.25;
    first.lights.front().position = {1, 2, 3, 0};
    second.view.lower_left = Topic::fighting;
    second.follow = Follow{"box", 7};
    second.ui.theme = Theme::projector;
    const Result<std::string> one = with_step("", "mine.json", first, "");
    ASSERT_TRUE(one) << one.error();
    const Result<std::string> two = with_step(*one, "mine.json", second, "opening");
    ASSERT_TRUE(two) << two.error();
    const Result<Lesson> lesson = parse_lesson(*two, "mine.json", "");
    ASSERT_TRUE(lesson) << lesson.error() << *two;
    EXPECT_EQ(lesson->id, "mine");
    ASSERT_EQ(lesson->steps.size(), 2U);
    EXPECT_EQ(lesson->steps[0].start.params, first);
    second.ui = {};  // theme and scale belong to the user
    EXPECT_EQ(lesson->steps[1].start.params, second);
}

TEST(SaveAsStep, RefusesOtherFiles) {
    EXPECT_NE(with_step("{}", "state.json", {}, "").error().find("state.json: is not a lesson"), std::string::npos);
    EXPECT_FALSE(with_step("{", "state.json", {}, ""));
    EXPECT_FALSE(with_step("[]", "state.json", {}, ""));
}

TEST(Allowed, GoalAllowsAnyLookButOnlyTheListedFields) {
    Params before, after;
    after.projection.near = 1.0;
    after.observer.yaw = 3.0;
    after.view.lower_left = Topic::depth;
    EXPECT_TRUE(changed_without_leave(before, after, {"projection.near"}).empty());
    EXPECT_TRUE(changed_without_leave(before, after, {"projection"}).empty());
    EXPECT_TRUE(changed_without_leave(before, after, {}).empty());
    EXPECT_EQ(changed_without_leave(before, after, {"projection.far"}), std::vector<std::string>{"projection.near"});
    EXPECT_EQ(changed_fields(before, before).size(), 0U);
    EXPECT_EQ(changed_fields(before, after).size(), 3U);
}

}  // namespace
}  // namespace viewing
