// Undo and redo in use: a drag, a flight or a typed number counts as one step.
#include "desk.h"
#include "trials.h"

namespace viewing::test {
namespace {

class HistoryTest : public UiTest {};

TEST_F(HistoryTest, ADragIsOneStep) {
    const Params before = params;
    desk.drag("projection/z-near", 40.0F, 0.0F, 10);
    const Params after = params;
    ASSERT_NE(after, before);
    desk.undo();
    EXPECT_EQ(params, before);
    EXPECT_FALSE(desk.session.can_undo());
    desk.redo();
    EXPECT_EQ(params, after);
    EXPECT_FALSE(desk.session.can_redo());
}

TEST_F(HistoryTest, AFlightBetweenTwoPausesIsOneStep) {
    const Params before = params;
    const glm::dvec3 forward(-desk.derived.world_from_view[2]);
    desk.hold(Key::w);
    ui.frames(20);
    EXPECT_TRUE(desk.session.moving_freedoms().forward);
    EXPECT_EQ(ui.text_of("camera/degrees of freedom/forward"), "active");
    desk.let_go(Key::w);
    desk.settle();
    ASSERT_FALSE(desk.session.is_moving());
    const glm::dvec3 moved = params.camera.position - before.camera.position;
    EXPECT_GT(glm::length(moved), 0.3);
    EXPECT_NEAR(glm::dot(glm::normalize(moved), forward), 1.0, 1e-12);
    desk.undo();
    EXPECT_EQ(params, before);
    EXPECT_FALSE(desk.session.can_undo());
}

TEST_F(HistoryTest, LookingAroundWithTheMouseIsOneStep) {
    const Params before = params;
    desk.drag_from(desk.in_camera_view({-3.0, 2.5, -3.0}), 80.0F, 30.0F, 8);
    EXPECT_EQ(differing_fields(before, params), (Paths{"camera.yaw", "camera.pitch"}));
    desk.undo();
    EXPECT_EQ(params, before);
    EXPECT_FALSE(desk.session.can_undo());
}

/// The first click of a double-click sets the slider; the second reverts that and opens the number for typing.
TEST_F(HistoryTest, AClickRevertedByADoubleClickIsNoStep) {
    const Params before = params;
    ui.click("projection/z-near");
    ASSERT_NE(params, before) << "the knob must not be in the middle";
    desk.settle();
    desk.undo();
    ASSERT_EQ(params, before);
    ui.double_click("projection/z-near");
    ui.key(ImGuiKey_Escape);
    desk.settle();
    EXPECT_EQ(params, before);
    EXPECT_FALSE(desk.session.can_undo());
}

TEST_F(HistoryTest, ButtonsShowWhatCanBeUndone) {
    EXPECT_FALSE(ui.find("top/Undo").enabled);
    desk.click("depth/Depth test");
    ui.frame();
    ASSERT_TRUE(ui.find("top/Undo").enabled);
    desk.click("top/Undo");
    EXPECT_TRUE(params.depth.test);
    ui.frame();
    EXPECT_FALSE(ui.find("top/Undo").enabled);
    desk.click("top/Redo");
    EXPECT_FALSE(params.depth.test);
}

TEST_F(HistoryTest, ResetAllCanBeUndone) {
    desk.click("depth/Cull face");
    desk.enter("camera/position/x", "1");
    const Params before = params;
    desk.choose("top/File", "top/Reset all");
    EXPECT_EQ(params, Params{});
    desk.undo();
    EXPECT_EQ(params, before);
}

TEST_F(HistoryTest, IdleFramesChangeNothing) {
    const Params before = params;
    ui.frames(30);
    EXPECT_EQ(params, before);
    for (const char* label : {"projection/z-near", "light/position/x", "matrices/S/r0c0", "view/camera view"}) {
        ui.hover(label);
        ui.frames(10);
    }
    EXPECT_EQ(params, before);
    EXPECT_FALSE(desk.session.can_undo());
}

TEST(History, ShowingAPresetDoesNotChangeIt) {
    std::size_t index = 0;
    for (const NamedFile& preset : presets()) {
        if (!testing::takes(index++)) continue;
        Desk desk({1280, 720}, preset.name);
        const Params before = load_state(preset.name)->params;
        desk.ui.frames(30);
        EXPECT_EQ(differing_fields(before, desk.params()), Paths{}) << preset.name;
        EXPECT_FALSE(desk.session.can_undo()) << preset.name;
    }
}

}  // namespace
}  // namespace viewing::test
