// The mouse in the views: dragging handles, looking around, the observer, and picking a vertex.
#include "desk.h"

namespace viewing::test {
namespace {

class ViewsTest : public UiTest {
protected:
    ViewsTest() {
        params.lights.front().position = {0.4, 2.6, 0.6, 1.0};  // inside the picture
        desk.settle();
    }
    void expect_near(ImVec2 a, ImVec2 b, float tolerance_px) {
        EXPECT_NEAR(a.x, b.x, tolerance_px);
        EXPECT_NEAR(a.y, b.y, tolerance_px);
    }
    glm::dvec3 light() const { return glm::dvec3(params.lights.front().position); }

    /// Returns the object's vertex nearest to the eye; it is visible if the object is convex and nothing hides it.
    glm::dvec3 nearest_vertex(const SceneObject& object) const {
        glm::dvec3 nearest(0.0);
        double distance = 1e300;
        for (const auto& position : object.mesh->positions) {
            const glm::dvec3 world(object.world_from_model * glm::dvec4(position, 1.0));
            if (glm::distance(world, params.camera.position) >= distance) continue;
            distance = glm::distance(world, params.camera.position);
            nearest = world;
        }
        return nearest;
    }
    /// Clicks just inside the small box, beside its nearest vertex, and returns that vertex.
    glm::dvec3 pick_small_box() {
        const SceneObject& box = *desk.session.scene().find("small box");
        const glm::dvec3 vertex = nearest_vertex(box);
        desk.click_at(desk.in_camera_view(glm::mix(vertex, glm::dvec3(box.world_from_model[3]), 0.15)));
        return vertex;
    }
};

TEST_F(ViewsTest, TheLightFollowsItsHandleAndTheNumbersFollowTheLight) {
    const Params before = params;
    const ImVec2 from = desk.in_camera_view(light());
    desk.drag_from(from, 60.0F, -40.0F);
    EXPECT_EQ(differing_fields(before, params), Paths{"light.position"});
    EXPECT_EQ(params.lights.front().position.w, 1.0);
    expect_near(desk.in_camera_view(light()), {from.x + 60.0F, from.y - 40.0F}, 0.5F);
    EXPECT_EQ(ui.text_of("light/position/x"), number_text(light().x, 2));
    EXPECT_EQ(ui.text_of("light/position/y"), number_text(light().y, 2));
    desk.undo();
    EXPECT_EQ(params, before);
}

TEST_F(ViewsTest, HandlesBelongToTheSelectedLightAndPlane) {
    params.lights.push_back({{-1.2, 1.8, 0.4, 1.0}});
    params.planes.push_back({.equation = {0.0, 0.0, 1.0, 1.0}});
    params.view.light = params.view.plane = 2;
    desk.settle();
    const Params before = params;
    desk.drag_from(desk.in_camera_view(glm::dvec3(params.lights[1].position)), 30.0F, -20.0F);
    EXPECT_EQ(params.lights[0], before.lights[0]);
    EXPECT_NE(params.lights[1], before.lights[1]);
    EXPECT_EQ(params.planes, before.planes);
    desk.drag_from(desk.in_camera_view({0.0, 0.0, -1.0}), 40.0F, 0.0F);
    EXPECT_EQ(params.planes[0], before.planes[0]);
    EXPECT_NE(params.planes[1].equation.w, before.planes[1].equation.w);
}

TEST_F(ViewsTest, ShiftDragsTheLightOnlyVertically) {
    const glm::dvec3 before = light();
    const ImVec2 from = desk.in_camera_view(before);
    desk.hold(Key::shift);
    desk.drag_from(from, 50.0F, -60.0F);
    desk.let_go(Key::shift);
    EXPECT_GT(light().y, before.y + 0.1);
    EXPECT_EQ(light().x, before.x);
    EXPECT_EQ(light().z, before.z);
}

TEST_F(ViewsTest, AParallelLightKeepsItsLength) {
    params.lights.front().position = {0.3, 1.0, 0.2, 0.0};
    params.camera.position = {3.9, 5.0, 9.6};
    desk.settle();
    const double length = glm::length(light());
    desk.drag_from(desk.in_camera_view(glm::normalize(light()) * 5.0), 40.0F, 20.0F);
    EXPECT_NE(light(), glm::dvec3(0.3, 1.0, 0.2));
    EXPECT_EQ(params.lights.front().position.w, 0.0);
    EXPECT_NEAR(glm::length(light()), length, 1e-12);
}

TEST_F(ViewsTest, ThePlaneMovesAlongItsNormal) {
    params.planes.front().equation = {0.0, 2.0, 0.0, 0.0};
    desk.settle();
    const Params before = params;
    desk.drag_from(desk.in_camera_view({0.0, 0.0, 0.0}), 0.0F, -60.0F);
    EXPECT_EQ(differing_fields(before, params), Paths{"plane.equation"});
    EXPECT_EQ(glm::dvec3(params.planes.front().equation), glm::dvec3(0.0, 2.0, 0.0));
    EXPECT_LT(params.planes.front().equation.w, -0.2);  // the plane y = −d / 2 moved up
    EXPECT_NEAR(*widgets::ParseNumber(ui.text_of("plane/equation/d")), params.planes.front().equation.w, 0.006);
}

TEST_F(ViewsTest, TiltingKeepsTheNormalsLengthAndThePatchsCenter) {
    params.planes.front().equation = {0.0, 2.0, 0.0, -1.0};  // y = 0.5
    params.lights.front().position = {3.0, 6.0, 3.0, 1.0};
    desk.settle();
    const Params before = params;
    desk.drag_from(desk.in_camera_view({0.0, 0.5 + 1.4, 0.0}), 80.0F, 10.0F);
    EXPECT_EQ(differing_fields(before, params), Paths{"plane.equation"});
    const glm::dvec3 normal(params.planes.front().equation);
    EXPECT_GT(normal.x, 0.1);
    EXPECT_NEAR(glm::length(normal), 2.0, 1e-12);
    EXPECT_NEAR(glm::dot(normal, glm::dvec3(0.0, 0.5, 0.0)) + params.planes.front().equation.w, 0.0, 1e-12);
}

TEST_F(ViewsTest, AFlippedPlaneKeepsItsSignWhenTilted) {
    params.planes.front().equation = {0.0, -1.0, 0.0, 0.0};
    desk.settle();
    desk.drag_from(desk.in_camera_view({0.0, -1.4, 0.0}), 30.0F, 0.0F);
    EXPECT_LT(params.planes.front().equation.y, -0.5);
    EXPECT_NE(params.planes.front().equation.x, 0.0);
}

TEST_F(ViewsTest, WithoutHandlesTheMouseLooksAround) {
    desk.press(Key::h);
    ASSERT_FALSE(desk.workbench.views.handles);
    const Params before = params;
    desk.drag_from(desk.in_camera_view(light()), 60.0F, 0.0F);
    EXPECT_EQ(params.lights, before.lights);
    EXPECT_NE(params.camera.yaw, before.camera.yaw);
}

TEST_F(ViewsTest, TheObserverOrbitsAlone) {
    const Rect rect = desk.layout().lower_left;
    const Params before = params;
    desk.drag_from({rect.min.x + 20.0F, rect.max.y - 20.0F}, 50.0F, -30.0F);
    EXPECT_EQ(differing_fields(before, params), (Paths{"observer.yaw", "observer.pitch"}));
    const Params turned = params;
    desk.drag_from({rect.min.x + 20.0F, rect.max.y - 20.0F}, 30.0F, -30.0F, 5, ImGuiMouseButton_Right);
    EXPECT_EQ(differing_fields(turned, params), Paths{"observer.target"});
    const Params shifted = params;
    ui.move_to({rect.min.x + 20.0F, rect.max.y - 20.0F});
    ImGui::GetIO().MouseWheel = 1.0F;
    ui.frame();
    ImGui::GetIO().MouseWheel = 0.0F;
    ui.frames(2);
    EXPECT_EQ(differing_fields(shifted, params), Paths{"observer.distance"});
    EXPECT_LT(params.observer.distance, shifted.observer.distance);
}

TEST_F(ViewsTest, HandlesAlsoWorkInTheObserver) {
    const Params before = params;
    const ImVec2 from = desk.in_observer_view(light());
    desk.drag_from(from, 25.0F, -15.0F);
    EXPECT_EQ(differing_fields(before, params), Paths{"light.position"});
    expect_near(desk.in_observer_view(light()), {from.x + 25.0F, from.y - 15.0F}, 0.5F);
}

TEST_F(ViewsTest, MaximizingTheObserverReleasesItsHandle) {
    ui.hover("left/observer/observer view");
    desk.press(Key::m);
    ASSERT_EQ(desk.params().view.layout.big, ViewName::lower_left);
    desk.drag_from(desk.in_observer_view(light()), 25.0F, -15.0F);
    const Params before = params;
    const Rect rect = desk.layout().lower_left;
    desk.drag_from({rect.min.x + 20.0F, rect.max.y - 20.0F}, 50.0F, -30.0F);
    EXPECT_EQ(differing_fields(before, params), (Paths{"observer.yaw", "observer.pitch"}));
}

/// Returns the position of a point in any camera picture, whatever its aspect ratio, since fovy is a vertical angle.
ImVec2 seen_in(const Rect& rect, const Desk& desk, const glm::dvec3& point_world) {
    const glm::dvec3 view = desk.derived.view_from_world * glm::dvec4(point_world, 1.0);
    const double scale =
        0.5 * rect.height() / (std::tan(glm::radians(0.5 * desk.session.params.projection.fovy)) * -view.z);
    return {0.5F * (rect.min.x + rect.max.x) + static_cast<float>(scale * view.x),
            0.5F * (rect.min.y + rect.max.y) - static_cast<float>(scale * view.y)};
}

TEST_F(ViewsTest, DepthPicturesReportTheCamerasPixelUnderThePointer) {
    const glm::dvec3 point(0.9, 0.4, 1.3);
    const auto expect_pixel = [&](const Rect& rect, const char* what) {
        ASSERT_FALSE(rect.empty()) << what;
        const Rect camera = desk.layout().camera;
        const ImVec2 there = seen_in(camera, desk, point);
        ui.move_to(seen_in(rect, desk, point));
        ui.frames(2);
        const std::optional<glm::ivec2> told = desk.workbench.views.told_pixel;
        ASSERT_TRUE(told) << what;
        const double a_pixel_there = 1.5 * camera.height() / rect.height();
        EXPECT_NEAR(told->x + 0.5, there.x - camera.min.x, a_pixel_there + 0.5) << what;
        EXPECT_NEAR(told->y + 0.5, there.y - camera.min.y, a_pixel_there + 0.5) << what;
    };
    expect_pixel(desk.layout().camera, "the camera view");
    expect_pixel(desk.layout().lower_right, "the depth buffer below");
    params.view.beside.shows = Beside::depth;
    params.view.beside.layout = BesideLayout::halves;
    desk.settle();
    expect_pixel(desk.layout().beside, "the depth half");
    params.view.beside.shows = Beside::other_depth;
    desk.settle();
    expect_pixel(desk.layout().beside, "the half with another depth");
}

TEST_F(ViewsTest, AClickFollowsTheNearestVertexUntilItIsCleared) {
    const glm::dvec3 vertex = pick_small_box();
    ASSERT_TRUE(params.follow);
    EXPECT_EQ(params.follow->object, "small box");
    ui.frames(2);
    ASSERT_TRUE(desk.derived.followed);
    EXPECT_LT(glm::distance(desk.derived.followed->point_world, vertex), 1e-5);
    desk.click("matrices/Clear");
    EXPECT_FALSE(params.follow);
    pick_small_box();
    EXPECT_TRUE(params.follow);
    desk.press(Key::escape);
    EXPECT_FALSE(params.follow);
}

TEST_F(ViewsTest, DraggingPicksNothing) {
    const SceneObject& box = *desk.session.scene().find("small box");
    desk.drag_from(desk.in_camera_view(glm::dvec3(box.world_from_model[3])), 40.0F, 0.0F);
    EXPECT_FALSE(params.follow);
}

TEST_F(ViewsTest, TheHeaderSelectsWhatTheCameraShows) {
    for (const auto& [label, shows] : {std::pair{"view/depth", Shows::depth},
                                       {"view/facing", Shows::facing},
                                       {"view/stencil", Shows::stencil},
                                       {"view/color", Shows::color}}) {
        desk.click(label);
        EXPECT_EQ(params.view.shows, shows);
    }
    desk.click("view/MSAA off");
    EXPECT_EQ(params.view.samples, 0);
    desk.click("view/depth");
    ui.frames(2);
    desk.click("view/window");
    EXPECT_EQ(params.view.depth_scale, DepthScale::window);
}

/// Of five mistakes, each with a sentence and a fix, three are shown at first, and a click shows the others.
TEST_F(ViewsTest, ThreeSentencesAreToldAtOnceAndAClickTellsTheOthers) {
    const auto fixes = [] {
        const std::vector<widgets::RecordedItem>& items = widgets::CurrentContext().recorded;
        return std::count_if(items.begin(), items.end(),
                             [](const widgets::RecordedItem& item) { return item.label == "view/Fix"; });
    };
    params.shadow.stencil_once = false;
    params.reflection.reflect_light = params.reflection.flip_winding = false;
    params.cull.enabled = true;
    desk.settle();
    EXPECT_EQ(fixes(), 3);
    EXPECT_FALSE(ui.has("view/other sentences"));
    params.shadow.offset = ShadowOffset::none;
    params.projection.near = 7.0;  // cuts a box
    desk.settle();
    EXPECT_EQ(fixes(), 3);
    desk.click("view/other sentences");
    desk.settle();
    EXPECT_EQ(fixes(), 5);
    desk.click("view/other sentences");
    desk.settle();
    EXPECT_EQ(fixes(), 3);
    params.projection.near = 0.5;
    params.shadow.offset = ShadowOffset::polygon_offset;
    desk.settle();
    EXPECT_FALSE(ui.has("view/other sentences"));
}

TEST(SmallWindow, SentencesLeaveTheLowerHalfOfThePictureFree) {
    Desk desk({800, 600}, "room");  // two sentences of two lines
    const Rect camera = desk.layout().camera;
    const float below_first = desk.ui.find("view/other sentences").max.y;
    EXPECT_LT(below_first, 0.5F * (camera.min.y + camera.max.y));
    desk.click("view/other sentences");
    desk.ui.frames(2);
    EXPECT_GT(desk.ui.find("view/other sentences").max.y, below_first + 15.0F) << "both are shown";
    desk.click("view/other sentences");
    desk.ui.frames(2);
    EXPECT_EQ(desk.ui.find("view/other sentences").max.y, below_first);
}

TEST_F(ViewsTest, ABrokenSwitchCanBeFixedOverThePicture) {
    params.shadow.stencil_once = false;
    desk.settle();
    const Params broken = params;
    desk.click("view/Fix");
    EXPECT_EQ(differing_fields(broken, params), Paths{"shadow.stencil_once"});
    EXPECT_TRUE(params.shadow.stencil_once);
    desk.settle();
    EXPECT_FALSE(ui.has("view/Fix"));
    desk.undo();
    EXPECT_EQ(params, broken);
}

class WheelTest : public ViewsTest {
protected:
    void wheel() {
        ui.hover("view/camera view", 0.1F, 0.1F);
        ImGui::GetIO().MouseWheel = 1.0F;
        ui.frame();
        ImGui::GetIO().MouseWheel = 0.0F;
        ui.frames(2);
    }
};

TEST_F(WheelTest, MovesForwardInFlightAndCloserInOrbit) {
    const glm::dvec3 forward = -glm::dvec3(desk.derived.world_from_view[2]);
    const Params before = params;
    wheel();
    EXPECT_EQ(differing_fields(before, params), Paths{"camera.position"});
    const glm::dvec3 way = params.camera.position - before.camera.position;
    EXPECT_GT(glm::length(way), 0.1);
    EXPECT_NEAR(glm::dot(glm::normalize(way), forward), 1.0, 1e-9);
    desk.undo();
    EXPECT_EQ(params, before);

    params.camera.navigation = Navigation::walk;
    desk.settle();
    wheel();
    EXPECT_EQ(params.camera.position.y, before.camera.position.y) << "along the ground";
    EXPECT_NE(params.camera.position, before.camera.position);

    params.camera.navigation = Navigation::orbit;
    desk.settle();
    const double distance = glm::distance(params.camera.position, params.camera.target);
    wheel();
    EXPECT_NEAR(glm::distance(params.camera.position, params.camera.target), distance * 0.88, 1e-9);
}

TEST_F(WheelTest, EnlargesAnOrthographicPicture) {
    params.projection.type = ProjectionType::orthographic;
    desk.settle();
    const Params before = params;
    wheel();
    EXPECT_EQ(differing_fields(before, params), Paths{"projection.height"});
    EXPECT_NEAR(params.projection.height, before.projection.height * 0.88, 1e-9);
}

TEST_F(WheelTest, WithCtrlChangesOnlyTheSpeed) {
    const Params before = params;
    const double speed = desk.session.speed();
    desk.hold(Key::ctrl);
    wheel();
    desk.let_go(Key::ctrl);
    EXPECT_NEAR(desk.session.speed(), 1.2 * speed, 1e-9);
    EXPECT_EQ(params, before);
    desk.drag("camera/speed", -30.0F);
    EXPECT_LT(desk.session.speed(), speed);
    EXPECT_EQ(params, before);
}

TEST_F(ViewsTest, FrameAllShowsTheLightUnlessItIsFarAway) {
    const auto is_shown = [&](const glm::dvec3& point) {
        const ImVec2 at = desk.in_camera_view(point);
        const Rect rect = desk.layout().camera;
        return at.x > rect.min.x && at.x < rect.max.x && at.y > rect.min.y && at.y < rect.max.y;
    };
    params.lights.front().position = {-9.0, 11.0, 4.0, 1.0};
    desk.settle();
    EXPECT_FALSE(is_shown(light()));
    desk.press(Key::g);
    desk.settle();
    EXPECT_TRUE(is_shown(light()));
    EXPECT_TRUE(is_shown({4.0, 0.0, 4.0})) << "a corner of the floor";
    const glm::dvec3 near_by = params.camera.position;
    params.lights.front().position = {-900.0, 1100.0, 400.0, 1.0};
    desk.settle();
    desk.press(Key::g);
    desk.settle();
    EXPECT_LT(glm::length(params.camera.position), glm::length(near_by)) << "otherwise the scene is a speck";
}

TEST_F(ViewsTest, TheFirstDragInFlyKeepsTheHorizon) {
    const Rect rect = desk.layout().camera;
    const ImVec2 corner{rect.min.x + 12.0F, rect.max.y - 80.0F};
    for (const int button : {0, 1}) {
        const Params before = params;
        desk.drag_from(corner, 120.0F, -70.0F, 5, button);
        EXPECT_EQ(differing_fields(before, params), (Paths{"camera.yaw", "camera.pitch"})) << "button " << button;
        EXPECT_LT(params.camera.yaw, before.camera.yaw) << "a drag to the right turns right";
        EXPECT_GT(params.camera.pitch, before.camera.pitch);
        desk.undo();
    }
    desk.workbench.views.mouse.keeps_horizon = false;
    desk.drag_from(corner, 120.0F, -70.0F);
    EXPECT_GT(std::abs(params.camera.roll), 0.1) << "about the camera's own axes";
}

TEST_F(ViewsTest, SensitivityAndInvertedYChangeADrag) {
    const Rect rect = desk.layout().camera;
    const ImVec2 corner{rect.min.x + 12.0F, rect.max.y - 80.0F};
    const CameraParams start = params.camera;
    desk.drag_from(corner, 40.0F, -30.0F);
    const double yaw = params.camera.yaw - start.yaw, pitch = params.camera.pitch - start.pitch;
    desk.undo();
    desk.workbench.views.mouse.sensitivity = 2.0;
    desk.workbench.views.mouse.inverts_y = true;
    desk.drag_from(corner, 40.0F, -30.0F);
    EXPECT_NEAR(params.camera.yaw - start.yaw, 2.0 * yaw, 1e-9);
    EXPECT_NEAR(params.camera.pitch - start.pitch, -2.0 * pitch, 1e-9);
}

TEST_F(ViewsTest, SensitivityAndInvertedYChangeADragInTheObserversView) {
    const Rect rect = desk.layout().lower_left;
    const ImVec2 corner{rect.min.x + 12.0F, rect.max.y - 12.0F};
    params.observer.pitch = -30.0;
    const ObserverParams start = params.observer;
    desk.drag_from(corner, 20.0F, -15.0F);
    const double yaw = params.observer.yaw - start.yaw, pitch = params.observer.pitch - start.pitch;
    EXPECT_LT(yaw, -1.0);
    EXPECT_GT(pitch, 1.0);
    params.observer = start;
    desk.workbench.views.mouse.sensitivity = 2.0;
    desk.workbench.views.mouse.inverts_y = true;
    desk.drag_from(corner, 20.0F, -15.0F);
    EXPECT_NEAR(params.observer.yaw - start.yaw, 2.0 * yaw, 1e-9);
    EXPECT_NEAR(params.observer.pitch - start.pitch, -2.0 * pitch, 1e-9);
}

TEST_F(ViewsTest, AnUnsteadyRightClickDoesNotTurnTheCamera) {
    const CameraParams before = params.camera;
    desk.drag_from(desk.in_camera_view({0.0, 0.0, 2.5}), 2.0F, 1.0F, 2, ImGuiMouseButton_Right);
    EXPECT_EQ(params.camera, before);
}

TEST_F(ViewsTest, InOrbitTheRightDragPans) {
    params.camera.navigation = Navigation::orbit;
    desk.settle();
    const Params before = params;
    desk.drag_from(desk.in_camera_view({0.0, 0.0, 2.5}), 50.0F, 20.0F, 5, ImGuiMouseButton_Right);
    EXPECT_EQ(differing_fields(before, params), (Paths{"camera.position", "camera.target"}));
}

TEST_F(ViewsTest, MiddleDragOrbitsAboutThePointThere) {
    const glm::dvec3 corner{1.0, 0.0, 1.0};
    params.follow = std::nullopt;
    const ImVec2 from = desk.in_camera_view({0.0, 0.0, 2.5});  // on the floor, in front of the objects
    const Params before = params;
    desk.drag_from(from, 70.0F, 20.0F, 5, 2);
    EXPECT_EQ(differing_fields(before, params), (Paths{"camera.position", "camera.yaw", "camera.pitch"}));
    desk.settle();
    const ImVec2 after = desk.in_camera_view({0.0, 0.0, 2.5});
    EXPECT_NEAR(after.x, from.x, 1.5F) << "the center stays in place in the picture";
    EXPECT_NEAR(after.y, from.y, 1.5F);
    EXPECT_NE(desk.in_camera_view(corner).x, from.x);
}

TEST_F(ViewsTest, MiddleAndRightDragMoveThePictureWithThePointerIfTheyPan) {
    for (const int button : {1, 2}) {
        desk.workbench.views.mouse.right_pans = desk.workbench.views.mouse.middle_pans = true;
        const ImVec2 from = desk.in_camera_view({1.4, 1.3, 0.0});  // on the blue box, or near it
        const Params before = params;
        desk.drag_from(from, 60.0F, 30.0F, 5, button);
        EXPECT_EQ(differing_fields(before, params), Paths{"camera.position"});
        const glm::dvec3 way = params.camera.position - before.camera.position;
        EXPECT_NEAR(glm::dot(way, glm::dvec3(desk.derived.world_from_view[2])), 0.0, 1e-9) << "parallel to the picture";
        EXPECT_LT(glm::dot(way, glm::dvec3(desk.derived.world_from_view[0])), 0.0) << "the picture follows the hand";
        EXPECT_GT(glm::dot(way, glm::dvec3(desk.derived.world_from_view[1])), 0.0);
        desk.undo();
        EXPECT_EQ(params, before);
    }
}

TEST_F(ViewsTest, ClickingTheBackgroundReleasesTheFollowedPoint) {
    params.follow = Follow{"box", 0};
    desk.settle();
    const Rect rect = desk.layout().camera;
    desk.click_at({rect.min.x + 12.0F, rect.max.y - 80.0F});
    EXPECT_FALSE(params.follow);
    desk.undo();
    EXPECT_TRUE(params.follow);
}

TEST_F(ViewsTest, KeysAndButtonsLeadToKnownViews) {
    const CameraParams home = params.camera;
    params.camera.roll = 12.0;
    params.camera.position = {30.0, 4.0, 50.0};
    desk.settle();
    const Params lost = params;
    desk.press(Key::l);
    EXPECT_EQ(differing_fields(lost, params), Paths{"camera.roll"});
    EXPECT_EQ(params.camera.roll, 0.0);
    desk.undo();
    desk.press(Key::g);
    EXPECT_EQ(differing_fields(lost, params), (Paths{"camera.position", "camera.target"}));
    const auto is_in_picture = [this](const glm::dvec3& point) {
        return desk.layout().camera.contains(desk.in_camera_view(point));
    };
    const Bounds& all = desk.session.scene().bounds_world;
    EXPECT_TRUE(is_in_picture(all.min) && is_in_picture(all.max) && is_in_picture(all.center()));
    desk.press(Key::home);
    EXPECT_EQ(params.camera, home);
    desk.undo();
    desk.undo();
    EXPECT_EQ(params, lost);

    desk.click("camera/Home");
    EXPECT_EQ(params.camera, home);
    const double distance = glm::distance(home.position, home.target);
    const Key keys[] = {Key::x, Key::y, Key::z};
    const char* const labels[] = {"camera/x", "camera/y", "camera/z"};
    for (int axis = 0; axis < 3; ++axis) {
        const auto offset = [&] { return params.camera.position - params.camera.target; };
        desk.press(keys[axis]);
        EXPECT_NEAR(offset()[axis], distance, 1e-9) << labels[axis];
        EXPECT_NEAR(-glm::dvec3(desk.derived.world_from_view[2])[axis], -1.0, 1e-9);
        desk.click(labels[axis]);
        EXPECT_NEAR(offset()[axis], -distance, 1e-9) << labels[axis] << ", from behind";
    }
    EXPECT_FALSE(ui.find("camera/Level").enabled);
}

class ObserverHandles : public ViewsTest {
protected:
    ObserverHandles() { desk.settle(); }
    HandlePlaces::Camera places() const { return *observer_handle_places(params, desk.derived).camera; }
    void drag(const glm::dvec3& from, float dx, float dy) { desk.drag_from(desk.in_observer_view(from), dx, dy); }
};

TEST_F(ObserverHandles, MoveTheCamera) {
    const Params before = params;
    const ImVec2 at = desk.in_observer_view(places().eye);
    drag(places().eye, -60.0F, 25.0F);
    EXPECT_EQ(differing_fields(before, params), Paths{"camera.position"});
    const ImVec2 now = desk.in_observer_view(places().eye);
    EXPECT_NEAR(now.x - at.x, -60.0F, 1.0F);
    EXPECT_NEAR(now.y - at.y, 25.0F, 1.0F);
    desk.undo();
    EXPECT_EQ(params, before);
}

TEST_F(ObserverHandles, TurnItsDirection) {
    params.camera.roll = 5.0;
    desk.settle();
    const Params before = params;
    const glm::dvec3 tip = places().direction_tip;
    const ImVec2 at = desk.in_observer_view(tip);
    drag(tip, 0.0F, -30.0F);
    EXPECT_EQ(differing_fields(before, params), (Paths{"camera.yaw", "camera.pitch"}));
    EXPECT_LT(desk.in_observer_view(places().direction_tip).y, at.y - 5.0F);
}

TEST_F(ObserverHandles, MoveNearAndFarAlongTheView) {
    params.projection.far = 12.0;
    params.projection.near = 2.0;
    desk.settle();
    const Params before = params;
    const glm::dvec3 near = places().near[0];
    const ImVec2 eye = desk.in_observer_view(places().eye), from = desk.in_observer_view(near);
    drag(near, 0.5F * (from.x - eye.x), 0.5F * (from.y - eye.y));  // away from the eye along the frustum's edge
    EXPECT_EQ(differing_fields(before, params), Paths{"projection.near"});
    EXPECT_GT(params.projection.near, 2.2);
    EXPECT_LT(params.projection.near, 4.5);
    desk.undo();
    const ImVec2 far = desk.in_observer_view(places().far[4]);
    drag(places().far[4], 0.3F * (eye.x - far.x), 0.3F * (eye.y - far.y));
    EXPECT_EQ(differing_fields(before, params), Paths{"projection.far"});
    EXPECT_LT(params.projection.far, 11.0);
    EXPECT_GT(params.projection.far, 4.0);
}

TEST_F(ObserverHandles, MoveTheEdgesOfAWindow) {
    params.projection.type = ProjectionType::frustum;
    params.projection.left = params.projection.bottom = -1.5;
    params.projection.right = params.projection.top = 1.0;
    params.projection.near = 4.0;
    desk.settle();
    const Params before = params;
    static constexpr const char* paths[] = {"projection.bottom", "projection.right", "projection.top",
                                            "projection.left"};
    double ProjectionParams::*const edges[] = {&ProjectionParams::bottom, &ProjectionParams::right,
                                               &ProjectionParams::top, &ProjectionParams::left};
    for (const ProjectionType type : {ProjectionType::frustum, ProjectionType::orthographic_window})
        for (std::size_t edge = 0; edge < 4; ++edge) {
            params = before;
            params.projection.type = type;
            desk.settle();
            const Params start = params;
            const ImVec2 middle = desk.in_observer_view(places().near[4]);
            const ImVec2 from = desk.in_observer_view(places().near[edge]);
            drag(places().near[edge], 0.4F * (from.x - middle.x), 0.4F * (from.y - middle.y));
            EXPECT_EQ(differing_fields(start, params), Paths{paths[edge]});
            // The window's size is 2.5, so the edge moves by 0.4 · 2.5 / 2, except for the effect of the observer's
            // perspective.
            const double moved = params.projection.*edges[edge] - start.projection.*edges[edge];
            EXPECT_NEAR(std::abs(moved), 0.5, 0.15) << paths[edge];
            EXPECT_EQ(moved > 0.0, start.projection.*edges[edge] > 0.0) << "away from the middle";
            desk.undo();
            EXPECT_EQ(params, start);
        }
    // An edge dragged past the opposite edge stops before it.
    params = before;
    desk.settle();
    const ImVec2 left = desk.in_observer_view(places().near[3]), right = desk.in_observer_view(places().near[1]);
    drag(places().near[3], 2.0F * (right.x - left.x), 2.0F * (right.y - left.y));
    EXPECT_LT(params.projection.left, params.projection.right);
    EXPECT_GT(params.projection.left, 0.9);
    EXPECT_EQ(params.projection.right, before.projection.right);
}

TEST_F(ViewsTest, TheFollowedPointIsDragged) {
    params.follow = Follow{.object = "", .point = glm::dvec3(1.5, 1.2, 1.5)};
    desk.settle();
    const Params before = params;
    const ImVec2 from = desk.in_camera_view(*params.follow->point);
    desk.drag_from(from, 50.0F, -30.0F);
    EXPECT_EQ(differing_fields(before, params), Paths{"follow"});
    expect_near(desk.in_camera_view(*params.follow->point), {from.x + 50.0F, from.y - 30.0F}, 0.5F);
    desk.undo();
    EXPECT_EQ(params, before);
    const ImVec2 outside = desk.in_observer_view(*params.follow->point);
    desk.drag_from(outside, 20.0F, 10.0F);
    EXPECT_EQ(differing_fields(before, params), Paths{"follow"});
    expect_near(desk.in_observer_view(*params.follow->point), {outside.x + 20.0F, outside.y + 10.0F}, 0.5F);
}

TEST_F(ViewsTest, AVertexBecomesAPointOfItsOwnByTypingOrDragging) {
    const glm::dvec3 vertex = pick_small_box();
    ASSERT_TRUE(params.follow && !params.follow->point);
    desk.click("matrices/Type p");
    ASSERT_TRUE(params.follow && params.follow->point);
    EXPECT_LT(glm::distance(*params.follow->point, vertex), 1e-9);
    desk.enter("matrices/p/x", "-1.25");
    EXPECT_EQ(params.follow->point->x, -1.25);
    desk.click("matrices/Clear");
    EXPECT_FALSE(params.follow);
    pick_small_box();
    desk.drag_from(desk.in_camera_view(vertex), 30.0F, 0.0F);
    ASSERT_TRUE(params.follow && params.follow->point);
    EXPECT_GT(glm::distance(*params.follow->point, vertex), 0.01);
}

TEST_F(ViewsTest, AClickOnTheFollowedVertexKeepsIt) {
    const glm::dvec3 vertex = pick_small_box();
    desk.click_at(desk.in_camera_view(vertex));
    ASSERT_TRUE(params.follow && !params.follow->point) << "a click is not a drag";
    EXPECT_EQ(params.follow->object, "small box");
}

/// Returns the color drawn last at a position in the window; 0 if there is none.
ImU32 color_at(ImVec2 at) {
    const auto side = [&](const ImVec2& a, const ImVec2& b) {
        return (b.x - a.x) * (at.y - a.y) - (b.y - a.y) * (at.x - a.x);
    };
    ImU32 color = 0;
    const ImDrawData* data = ImGui::GetDrawData();
    for (int i = 0; i < data->CmdListsCount; ++i) {
        const ImDrawList& list = *data->CmdLists[i];
        for (const ImDrawCmd& command : list.CmdBuffer)
            for (unsigned first = command.IdxOffset; first + 2 < command.IdxOffset + command.ElemCount; first += 3) {
                const auto corner = [&](unsigned at_corner) -> const ImDrawVert& {
                    const auto index = list.IdxBuffer[static_cast<int>(first + at_corner)];
                    return list.VtxBuffer[static_cast<int>(command.VtxOffset + index)];
                };
                const ImDrawVert &a = corner(0), &b = corner(1), &c = corner(2);
                const float ab = side(a.pos, b.pos), bc = side(b.pos, c.pos), ca = side(c.pos, a.pos);
                const bool is_inside = (ab > 0.0F && bc > 0.0F && ca > 0.0F) || (ab < 0.0F && bc < 0.0F && ca < 0.0F);
                if (is_inside) color = a.col;
            }
    }
    return color;
}

TEST_F(ViewsTest, ALegendIsDrawnOverAHandle) {
    params.view.shows = Shows::facing;
    desk.settle();
    const Rect view = desk.layout().camera;
    const ImVec2 at(view.min.x + 12.5F, view.max.y - 14.5F);  // on the legend's plate, beside its letters
    const ImVec2 beside(at.x + 1.3F, at.y + 0.6F);            // away from the seams between a disk's triangles
    const ImU32 plate = color_at(beside);
    EXPECT_EQ(plate >> IM_COL32_A_SHIFT, 255U);
    const glm::dvec4 clip(2.0 * (at.x - view.min.x) / view.width() - 1.0,
                          1.0 - 2.0 * (at.y - view.min.y) / view.height(), 0.9, 1.0);
    const glm::dvec4 world = glm::inverse(desk.derived.clip_from_world) * clip;
    params.lights.front().position = glm::dvec4(glm::dvec3(world) / world.w, 1.0);
    desk.settle();
    expect_near(desk.in_camera_view(light()), at, 0.1F);
    EXPECT_EQ(color_at(beside), plate) << "not the lamp's";
    params.view.shows = Shows::color;
    desk.settle();
    EXPECT_NE(color_at(beside), plate) << "the lamp's";
}

TEST_F(ViewsTest, ALightOutsideThePictureIsAnArrowAtItsEdge) {
    const Rect rect{{100.0F, 50.0F}, {500.0F, 350.0F}};
    const glm::dmat4 clip_from_world = clip_from_view({}, 4.0 / 3.0);  // looks along −z
    const auto edge_of = [&](const glm::dvec3& point) -> std::optional<ImVec2> {
        ImGui::NewFrame();
        ImDrawList list(ImGui::GetDrawListSharedData());
        list._ResetForNewFrame();
        list.PushClipRect({0.0F, 0.0F}, {1000.0F, 1000.0F});
        list.PushTextureID(ImGui::GetIO().Fonts->TexID);
        std::optional<ImVec2> tip;
        {
            Overlay overlay(&list, rect, clip_from_world);
            if (overlay.arrow_at_edge(point, "l", IM_COL32_WHITE)) tip = list.VtxBuffer[0].pos;
        }
        ImGui::EndFrame();
        return tip;
    };
    EXPECT_FALSE(edge_of({0.0, 0.0, -5.0})) << "it is in the picture";
    const std::optional<ImVec2> above = edge_of({0.0, 9.0, -5.0}), right_behind = edge_of({9.0, 0.0, 5.0});
    ASSERT_TRUE(above && right_behind);
    EXPECT_NEAR(above->x, 300.0F, 3.0F);
    EXPECT_LT(above->y, 70.0F);
    EXPECT_GT(right_behind->x, 480.0F) << "a light behind the eye on the right is to the right";
    EXPECT_NEAR(right_behind->y, 200.0F, 3.0F);
    EXPECT_TRUE(edge_of({0.0, 0.0, 5.0})) << "a point straight behind the eye";
}

}  // namespace
}  // namespace viewing::test
