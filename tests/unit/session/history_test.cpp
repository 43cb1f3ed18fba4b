// Undo and redo: all changes between two pauses are one step.
#include "session/history.h"

#include <gtest/gtest.h>

#include "state/params.h"

namespace viewing {
namespace {

Params with_yaw(double yaw) {
    Params params;
    params.camera.yaw = yaw;
    return params;
}

TEST(History, StartsWithNothingToUndo) {
    History history(with_yaw(0));
    EXPECT_FALSE(history.can_undo());
    EXPECT_FALSE(history.can_redo());
    EXPECT_FALSE(history.undo());
    EXPECT_FALSE(history.redo());
    EXPECT_FALSE(history.rest(with_yaw(0))) << "a pause without a change is not a step";
    EXPECT_FALSE(history.can_undo());
}

TEST(History, GoesBackAndForth) {
    History history(with_yaw(0));
    EXPECT_TRUE(history.rest(with_yaw(1)));
    EXPECT_TRUE(history.rest(with_yaw(2)));
    EXPECT_EQ(history.undo(), with_yaw(1));
    EXPECT_EQ(history.undo(), with_yaw(0));
    EXPECT_FALSE(history.undo());
    EXPECT_EQ(history.redo(), with_yaw(1));
    EXPECT_EQ(history.redo(), with_yaw(2));
    EXPECT_FALSE(history.redo());
}

TEST(History, ForgetsRedoOnlyWhenAStepIsMade) {
    History history(with_yaw(0));
    history.rest(with_yaw(1));
    history.undo();
    EXPECT_FALSE(history.rest(with_yaw(0))) << "a pause after an undo keeps redo";
    EXPECT_TRUE(history.can_redo());
    EXPECT_TRUE(history.rest(with_yaw(5)));
    EXPECT_FALSE(history.can_redo());
    EXPECT_EQ(history.undo(), with_yaw(0));
    EXPECT_EQ(history.redo(), with_yaw(5));
}

TEST(History, KeepsTheLast500Steps) {
    History history(with_yaw(0));
    for (int i = 1; i <= 600; ++i) {
        EXPECT_TRUE(history.rest(with_yaw(i)));
    }
    int undone = 0;
    std::optional<Params> oldest;
    while (std::optional<Params> params = history.undo()) {
        oldest = params;
        ++undone;
    }
    EXPECT_EQ(undone, 500);
    EXPECT_EQ(oldest, with_yaw(100));
}

}  // namespace
}  // namespace viewing
