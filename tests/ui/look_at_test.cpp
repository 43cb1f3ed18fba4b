// The camera as eye, center and up in the panel: one camera, written in two ways.
#include <glm/gtc/matrix_transform.hpp>

#include "desk.h"

namespace viewing::test {
namespace {

constexpr const char* by_points = "camera/pose/Look at";

TEST(LookAtTab, ShowsTheCameraThatTheAnglesDescribe) {
    Desk desk;
    const Params before = desk.params();
    desk.click(by_points);
    desk.settle();
    EXPECT_EQ(desk.params(), before) << "looking at the other tab edits nothing";
    EXPECT_EQ(desk.ui.find("camera/eye/x").text, "3.90");
    EXPECT_EQ(desk.ui.find("camera/up/y").text, "1.00");
    desk.params().camera.look({{0, 2, 5}, {0, 2, 0}, {0, 1, 0}});
    desk.settle();
    EXPECT_EQ(desk.ui.find("camera/eye/z").text, "5.00");
    EXPECT_EQ(desk.ui.find("camera/center/x").text, "0.00");
}

TEST(LookAtTab, EditsTurnTheCameraInOneUndoStep) {
    Desk desk;
    desk.click(by_points);
    desk.settle();
    const Params before = desk.params();
    desk.drag("camera/center/x", 40.0F);
    desk.settle();
    const CameraParams& camera = desk.params().camera;
    EXPECT_EQ(camera.position, before.camera.position);
    EXPECT_LT(camera.yaw, before.camera.yaw) << "a center farther right turns the camera to the right";
    EXPECT_EQ(camera.roll, 0.0);
    const double center_x = *widgets::ParseNumber(desk.ui.find("camera/center/x").text);
    EXPECT_GT(center_x, 0.3);
    desk.undo();
    EXPECT_EQ(desk.params(), before);
}

TEST(LookAtTab, KeepsWhatIsTypedWhileItIsTheCamera) {
    Desk desk;
    desk.params().camera.look({{0, 0, 5}, {0, 0, 0}, {0, 1, 0}});
    desk.click(by_points);
    desk.settle();
    desk.enter("camera/up/z", "3");  // an up that is not perpendicular to the view gives the same camera
    desk.settle();
    EXPECT_EQ(desk.ui.find("camera/up/z").text, "3.00");
    EXPECT_EQ(desk.params().camera.angles(), Angles{});
    desk.params().camera.roll = 90.0;
    desk.settle();
    EXPECT_EQ(desk.ui.find("camera/up/z").text, "0.00");
    EXPECT_EQ(desk.ui.find("camera/up/x").text, "−1.00");
}

TEST(LookAtTab, ADegenerateOneIsACameraAndASentence) {
    Desk desk;
    desk.params().camera.look({{0, 5, 0}, {0, 5, -1}, {0, 1, 0}});
    desk.click(by_points);
    desk.settle();
    desk.enter("camera/center/x", "0");
    desk.enter("camera/center/y", "0");
    desk.enter("camera/center/z", "0");
    desk.settle();
    EXPECT_EQ(desk.params().camera.angles(), (Angles{0, -90, 0}));
    const auto says = [&](const std::string& start) {
        return std::any_of(desk.recorded().begin(), desk.recorded().end(),
                           [&](const RecordedItem& item) { return item.text.starts_with(start); });
    };
    EXPECT_TRUE(says("up is zero or parallel to the view"));
    desk.enter("camera/center/y", "5");
    desk.settle();
    EXPECT_EQ(desk.params().camera.angles(), Angles{});
    EXPECT_TRUE(says("center = eye"));
}

TEST(LookAtTab, CopiesTheCallsOfOtherPrograms) {
    Desk desk;
    desk.params().camera.look({{0, 2, 5}, {0, 2, 0}, {0, 1, 0}});
    desk.params().camera.target = {0, 2, 0};
    desk.click(by_points);
    desk.settle();
    desk.click("camera/glm::lookAt");
    EXPECT_EQ(desk.clipboard, "glm::lookAt(glm::dvec3(0, 2, 5), glm::dvec3(0, 2, 0), glm::dvec3(0, 1, 0))");
    desk.click("camera/gluLookAt");
    EXPECT_EQ(desk.clipboard, "gluLookAt(0, 2, 5, 0, 2, 0, 0, 1, 0);");
    desk.click("camera/three.js");
    EXPECT_EQ(desk.clipboard, "camera.position.set(0, 2, 5);\ncamera.up.set(0, 1, 0);\ncamera.lookAt(0, 2, 0);");
}

}  // namespace
}  // namespace viewing::test
