// The keys: each has its effect, but none has an effect while the user types or a dialog is open.
#include "desk.h"

namespace viewing::test {
namespace {

class KeysTest : public UiTest {};

TEST_F(KeysTest, EveryFlyKeyMovesItsDegreeOfFreedom) {
    struct Case {
        Key key;
        glm::dvec3 view_direction;  ///< of the motion, in the camera's frame; zero for a rotation
    };
    for (const Case& one : {Case{Key::w, {0, 0, -1}}, Case{Key::s, {0, 0, 1}}, Case{Key::a, {-1, 0, 0}},
                            Case{Key::d, {1, 0, 0}}, Case{Key::r, {0, 1, 0}}, Case{Key::f, {0, -1, 0}}}) {
        const glm::dvec3 before = params.camera.position;
        desk.hold(one.key);
        ui.frames(5);
        desk.let_go(one.key);
        desk.settle();
        const glm::dmat3 axes(desk.derived.world_from_view);
        const glm::dvec3 moved = glm::transpose(axes) * (params.camera.position - before);
        ASSERT_GT(glm::length(moved), 0.01);
        EXPECT_NEAR(glm::dot(glm::normalize(moved), one.view_direction), 1.0, 1e-9);
    }
    const Params level = params;
    desk.press(Key::left);
    desk.settle();
    EXPECT_GT(params.camera.yaw, level.camera.yaw);
    desk.undo();
    desk.press(Key::up);
    desk.settle();
    EXPECT_GT(params.camera.pitch, level.camera.pitch);
    desk.undo();
    desk.press(Key::q);
    desk.settle();
    EXPECT_GT(params.camera.roll, level.camera.roll);
}

TEST_F(KeysTest, TypingMovesNothing) {
    const Params before = params;
    desk.reveal("camera/position/x");
    ui.double_click("camera/position/x");
    ASSERT_TRUE(ImGui::GetIO().WantTextInput);
    for (const auto& [key, letter] :
         {std::pair{Key::w, 'w'}, {Key::n, 'n'}, {Key::b, 'b'}, {Key::m, 'm'}, {Key::r, 'r'}})
        desk.press_letter(key, letter);
    desk.hold(Key::s);
    ui.frames(10);
    desk.let_go(Key::s);
    EXPECT_EQ(params, before);
    EXPECT_TRUE(desk.workbench.views.handles);
    EXPECT_EQ(desk.params().view.layout.big, ViewName::none);
    desk.press(Key::escape);
    desk.settle();
    EXPECT_EQ(params, before);
    EXPECT_FALSE(desk.session.is_moving());
}

TEST_F(KeysTest, EscapeEndsTypingAndNothingElse) {
    params.follow = Follow{"box", 0};
    desk.settle();
    ui.double_click("camera/position/x");
    ui.type("77");
    desk.press(Key::escape);
    EXPECT_EQ(params.camera.position.x, 3.9);
    EXPECT_TRUE(params.follow);
}

TEST_F(KeysTest, FoldKeysFoldTheColumns) {
    desk.press(Key::f2);
    EXPECT_TRUE(desk.layout().panel.empty());
    EXPECT_FALSE(ui.has("Camera"));
    desk.press(Key::f3);
    EXPECT_TRUE(desk.layout().matrices.empty());
    EXPECT_FALSE(ui.has("matrices/S/r0c0"));
    desk.press(Key::f2);
    desk.press(Key::f3);
    EXPECT_TRUE(ui.has("Camera"));
    EXPECT_TRUE(ui.has("matrices/S/r0c0"));
}

TEST_F(KeysTest, MMaximizesTheViewUnderThePointer) {
    for (const auto& [label, view] : {std::pair{"view/camera view", ViewName::camera},
                                      {"left/observer/observer view", ViewName::lower_left},
                                      {"lower/lower view", ViewName::lower_right}}) {
        ui.hover(label);
        desk.press(Key::m);
        EXPECT_EQ(params.view.layout.big, view);
        EXPECT_GT(ui.find(label).max.x - ui.find(label).min.x, 1500.0F);
        EXPECT_FALSE(ui.has("Camera"));
        desk.press(Key::escape);
        EXPECT_EQ(desk.params().view.layout.big, ViewName::none);
    }
}

TEST_F(KeysTest, MMaximizesTheMatrices) {
    ui.hover("matrices/S/r0c0");
    desk.press(Key::m);
    EXPECT_EQ(desk.params().view.layout.big, ViewName::matrices);
    EXPECT_GT(desk.layout().matrices.width(), 1500.0F);
    EXPECT_TRUE(desk.layout().camera.empty());
    EXPECT_TRUE(ui.has("matrices/S/r0c0") && ui.has("matrices/R/r0c0"));
}

TEST_F(KeysTest, MaximizedCodeIsBesideItsMatrices) {
    params.view.lower_left = Topic::lecture_code;
    desk.settle();
    const Rect code = desk.layout().lower_left;
    ui.move_to({0.5F * (code.min.x + code.max.x), 0.5F * (code.min.y + code.max.y)});
    desk.press(Key::m);
    ASSERT_EQ(desk.params().view.layout.big, ViewName::lower_left);
    EXPECT_FALSE(desk.layout().matrices.empty());
    EXPECT_TRUE(ui.has("matrices/R/r0c0"));
    EXPECT_GT(desk.layout().lower_left.width(), 1000.0F);
}

TEST_F(KeysTest, NCyclesThroughTheNavigationModes) {
    for (const Navigation mode : {Navigation::walk, Navigation::orbit, Navigation::fly}) {
        desk.press(Key::n);
        EXPECT_EQ(params.camera.navigation, mode);
    }
}

TEST_F(KeysTest, HHidesHandlesAndLabels) {
    ASSERT_TRUE(ui.has("view/n"));
    desk.press(Key::h);
    EXPECT_FALSE(ui.has("view/n"));
    desk.press(Key::h);
    EXPECT_TRUE(ui.has("view/n"));
}

TEST_F(KeysTest, HelpOpensAndCloses) {
    desk.press(Key::f1);
    EXPECT_TRUE(ui.has("keys/Close"));
    desk.press(Key::f1);
    EXPECT_FALSE(ui.has("keys/Close"));
    desk.click("top/?");
    ui.frames(2);
    ASSERT_TRUE(ui.has("keys/Close"));
    ui.click("keys/Close");
    EXPECT_FALSE(ui.has("keys/Close"));
}

TEST_F(KeysTest, HelpShowsTheManualByTopics) {
    desk.press(Key::f1);
    EXPECT_FALSE(ui.has("keys/Presenting a lesson"));
    ui.click("keys/Lessons");
    ui.frames(2);
    EXPECT_TRUE(ui.has("keys/Presenting a lesson"));
    ui.click("keys/Keys");
    ui.frames(2);
    EXPECT_FALSE(ui.has("keys/Presenting a lesson"));
    ui.click("keys/Close");
}

TEST_F(KeysTest, WhileTheHelpIsOpenOnlyEscapeWorks) {
    params.follow = Follow{"box", 0};
    desk.settle();
    const Params before = params;
    desk.press(Key::f1);
    for (const Key key : {Key::w, Key::n, Key::b, Key::m}) desk.press(key);
    EXPECT_EQ(params, before);
    EXPECT_TRUE(desk.workbench.views.handles);
    EXPECT_EQ(desk.params().view.layout.big, ViewName::none);
    desk.press(Key::escape);
    EXPECT_FALSE(ui.has("keys/Close"));
    EXPECT_EQ(params, before);
}

TEST_F(KeysTest, CtrlWithALetterDoesNotMove) {
    const Params before = params;
    desk.hold(Key::ctrl);
    desk.hold(Key::d);
    ui.frames(10);
    desk.let_go(Key::d);
    desk.let_go(Key::ctrl);
    desk.settle();
    EXPECT_EQ(params, before);
}

TEST_F(KeysTest, AShortcutRightAfterTypingWorks) {
    ui.double_click("camera/position/x");
    ASSERT_TRUE(ImGui::GetIO().WantTextInput);
    desk.hold(Key::escape);
    desk.input.pressed = {{Key::ctrl, true, false}, {Key::c, true, false}};
    ui.frame();
    EXPECT_TRUE(parse_state(desk.clipboard, "clipboard"));
}

TEST_F(KeysTest, AShortcutWithinOneFrameWorks) {
    desk.click("depth/Depth test");
    ASSERT_FALSE(params.depth.test);
    desk.input.pressed = {{Key::ctrl, true, false}, {Key::z, true, false}};
    ui.frame();
    EXPECT_TRUE(params.depth.test);
}

TEST_F(KeysTest, SnapshotAndFullScreenAreRequestedOnce) {
    desk.hold(Key::f12);
    EXPECT_TRUE(desk.requests.snapshot);
    desk.let_go(Key::f12);
    EXPECT_FALSE(desk.requests.snapshot);
    desk.hold(Key::f11);
    EXPECT_TRUE(desk.requests.toggle_full_screen);
    desk.let_go(Key::f11);
    EXPECT_FALSE(desk.requests.toggle_full_screen);
}

}  // namespace
}  // namespace viewing::test
