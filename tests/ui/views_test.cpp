// What the mouse does in the views: handles, looking, the observer, picking a vertex.
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

    /// The vertex of an object that is nearest to the eye: visible when the object is convex and nothing stands before
    /// it.
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

TEST_F(ViewsTest, HandlesBelongToTheChosenLightAndPlane) {
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

TEST_F(ViewsTest, ShiftDragsTheLightUpAndDownOnly) {
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
    EXPECT_LT(params.planes.front().equation.w, -0.2);  // y = −d / 2 went up
    EXPECT_NEAR(*widgets::ParseNumber(ui.text_of("plane/equation/d")), params.planes.front().equation.w, 0.006);
}

TEST_F(ViewsTest, TiltingKeepsTheNormalsLengthAndThePatchsCentre) {
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

TEST_F(ViewsTest, WithoutHandlesTheMouseLooks) {
    desk.press(Key::b);
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

TEST_F(ViewsTest, HandlesWorkInTheObserverToo) {
    const Params before = params;
    const ImVec2 from = desk.in_observer_view(light());
    desk.drag_from(from, 25.0F, -15.0F);
    EXPECT_EQ(differing_fields(before, params), Paths{"light.position"});
    expect_near(desk.in_observer_view(light()), {from.x + 25.0F, from.y - 15.0F}, 0.5F);
}

TEST_F(ViewsTest, AMaximisedObserverLetsGoOfItsHandle) {
    ui.hover("left/observer/observer view");
    desk.press(Key::m);
    ASSERT_EQ(desk.workbench.arrangement.maximised, ViewName::lower_left);
    desk.drag_from(desk.in_observer_view(light()), 25.0F, -15.0F);
    const Params before = params;
    const Rect rect = desk.layout().lower_left;
    desk.drag_from({rect.min.x + 20.0F, rect.max.y - 20.0F}, 50.0F, -30.0F);
    EXPECT_EQ(differing_fields(before, params), (Paths{"observer.yaw", "observer.pitch"}));
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

TEST_F(ViewsTest, ADragPicksNothing) {
    const SceneObject& box = *desk.session.scene().find("small box");
    desk.drag_from(desk.in_camera_view(glm::dvec3(box.world_from_model[3])), 40.0F, 0.0F);
    EXPECT_FALSE(params.follow);
}

TEST_F(ViewsTest, HeaderChoosesWhatTheCameraShows) {
    for (const auto& [label, shows] : {std::pair{"view/depth", Shows::depth},
                                       {"view/facing", Shows::facing},
                                       {"view/stencil", Shows::stencil},
                                       {"view/colour", Shows::color}}) {
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

TEST_F(ViewsTest, ABrokenSwitchIsMendedOverThePicture) {
    params.shadow.stencil_once = false;
    desk.settle();
    const Params broken = params;
    desk.click("view/Mend");
    EXPECT_EQ(differing_fields(broken, params), Paths{"shadow.stencil_once"});
    EXPECT_TRUE(params.shadow.stencil_once);
    desk.settle();
    EXPECT_FALSE(ui.has("view/Mend"));
    desk.undo();
    EXPECT_EQ(params, broken);
}

TEST_F(ViewsTest, TheWheelChangesSpeedInFlightAndDistanceInOrbit) {
    const auto wheel = [this] {
        ui.hover("view/camera view", 0.1F, 0.1F);
        ImGui::GetIO().MouseWheel = 1.0F;
        ui.frame();
        ImGui::GetIO().MouseWheel = 0.0F;
        ui.frames(2);
    };
    const Params before = params;
    const double speed = desk.session.speed();
    wheel();
    EXPECT_GT(desk.session.speed(), speed);
    EXPECT_EQ(params, before);
    params.camera.navigation = Navigation::orbit;
    desk.settle();
    const double distance = glm::distance(params.camera.position, params.camera.target);
    wheel();
    EXPECT_NEAR(glm::distance(params.camera.position, params.camera.target), distance * 0.88, 1e-9);
}

}  // namespace
}  // namespace viewing::test
