// The hidden-surface methods in the panel and in the pictures: selecting methods, stepping, searching and picking.
#include <chrono>
#include <thread>

#include "desk.h"
#include "topics/hidden/methods/difference.h"

namespace viewing::test {
namespace {

class HiddenPanel : public UiTest {
protected:
    HiddenPanel() : HiddenPanel("cyclic-overlap") {}
    explicit HiddenPanel(const std::string& scene) {
        params.scene = scene;
        desk.settle();
    }
    void choose(const char* method) {
        desk.choose("depth/method", std::string("depth/method/") + method);
        desk.settle();
    }
    const HiddenResult& result() { return *desk.answer()->camera; }
};

TEST_F(HiddenPanel, EveryMethodIsSelectedByNameAndShowsItsOptions) {
    struct Case {
        const char* name;
        VisibilityMethod method;
        std::vector<const char*> options;
    };
    const Case cases[] = {
        {"painter", VisibilityMethod::painter, {"depth/sort key"}},
        {"Newell", VisibilityMethod::newell, {"depth/epsilon"}},
        {"BSP tree", VisibilityMethod::bsp, {"depth/splitter", "depth/walk", "depth/epsilon"}},
        {"soft. z-buffer", VisibilityMethod::software_depth_buffer, {}},
        {"ray casting", VisibilityMethod::ray_cast, {"depth/Exact curves"}},
    };
    for (const Case& each : cases) {
        choose(each.name);
        EXPECT_EQ(params.visibility.method, each.method);
        for (const char* option : each.options) EXPECT_TRUE(ui.has(option)) << each.name << ": " << option;
        EXPECT_FALSE(ui.find("depth/Depth test").enabled) << each.name;
        EXPECT_GT(result().step_count, 0) << each.name;
    }
    choose("GL depth buffer");
    EXPECT_TRUE(ui.find("depth/Depth test").enabled);
}

TEST_F(HiddenPanel, OptionsSetTheirFields) {
    choose("painter");
    desk.choose("depth/sort key", "depth/sort key/centroid");
    EXPECT_EQ(params.visibility.sort_key, PainterKey::centroid);
    desk.click("depth/Numbers");
    EXPECT_TRUE(params.visibility.numbers);
    choose("BSP tree");
    desk.choose("depth/splitter", "depth/splitter/balanced");
    EXPECT_EQ(params.visibility.splitter, BspSplitter::balanced);
    desk.choose("depth/walk", "depth/walk/front to back");
    EXPECT_EQ(params.visibility.walk, BspOrder::front_to_back);
    desk.enter("depth/epsilon", "0.001");
    EXPECT_EQ(params.visibility.epsilon, 0.001);
    choose("ray casting");
    desk.click("depth/Exact curves");
    EXPECT_TRUE(params.visibility.exact_curves);
    params.view.shows = Shows::difference;
    desk.settle();
    desk.choose("depth/compare", "depth/compare/painter");
    EXPECT_EQ(params.visibility.compare_with, VisibilityMethod::painter);
    ASSERT_TRUE(desk.answer()->other);  // found in software; in the program, GL draws the painter's order
    EXPECT_GT(difference(desk.answer()->camera->image, desk.answer()->other->image).different, 0);
}

TEST_F(HiddenPanel, ControlsBelowStayInPlaceWhateverAMethodCounts) {
    params.visibility.step = 0;
    choose("painter");
    const float top = ui.find("Depth buffer").min.y;
    for (const char* method : {"Newell", "BSP tree", "soft. z-buffer", "ray casting", "GL depth buffer"})
        for (const bool culls : {false, true}) {
            params.cull.enabled = culls;
            choose(method);
            EXPECT_EQ(ui.find("Depth buffer").min.y, top) << method << (culls ? ", culled" : "");
        }
}

TEST_F(HiddenPanel, TheDepthBufferAlsoHasSteps) {
    desk.click("depth/Steps");
    desk.settle();
    EXPECT_EQ(params.visibility.step, 0);
    EXPECT_EQ(result().drawn, 0);
    EXPECT_EQ(result().step_count, 36);
    params.visibility.step = 7;
    desk.settle();
    EXPECT_EQ(result().drawn, 7);
}

TEST_F(HiddenPanel, TheLowerViewFollowsTheMethod) {
    EXPECT_EQ(topic_of(desk.params(), Slot::right), Topic::depth);
    choose("BSP tree");
    EXPECT_EQ(topic_of(desk.params(), Slot::right), Topic::tree);
    choose("Newell");
    EXPECT_EQ(topic_of(desk.params(), Slot::right), Topic::order);
    choose("none");
    EXPECT_EQ(topic_of(desk.params(), Slot::right), Topic::depth);
}

TEST_F(HiddenPanel, AClickPicksTheVisiblePolygon) {
    choose("Newell");
    // Try the middle of each polygon that the picture shows as visible.
    int picked = 0;
    for (const int index : result().order) {
        const Polygon polygon = (*result().fragments)[static_cast<std::size_t>(index)];
        const ImVec2 middle = desk.in_camera_view(centroid(polygon));
        const Rect view = desk.layout().camera;
        const int x = static_cast<int>(middle.x - view.min.x), y = static_cast<int>(middle.y - view.min.y);
        const IdImage& image = result().image;
        if (x < 0 || y < 0 || x >= image.width || y >= image.height || image.id(x, y) != polygon.source) continue;
        desk.click_at(middle);
        const int selected = desk.workbench.views.hidden.links.now.selected_fragment;
        ASSERT_GE(selected, 0);
        EXPECT_EQ((*result().fragments)[static_cast<std::size_t>(selected)].source, polygon.source);
        ++picked;
    }
    EXPECT_GT(picked, 5);
}

TEST_F(HiddenPanel, PlayingTheStepsIsOneUndoStep) {
    choose("painter");
    params.visibility.step = 0;
    ui.frames(1);
    widgets::StepPlayer& player = desk.workbench.views.hidden.panel.player;
    player.playing = true;
    player.steps_per_s = 1000.0F;
    for (int frame = 0; frame < 100 && player.playing; ++frame) ui.frames(1);
    EXPECT_FALSE(player.playing);
    desk.settle();
    EXPECT_EQ(result().drawn, static_cast<int>(result().order.size()));
    desk.undo();
    EXPECT_EQ(params.visibility.step, 0);
}

class FailureSearchTest : public HiddenPanel {
protected:
    FailureSearchTest() : HiddenPanel("sort-key-farthest") {}
};

TEST_F(FailureSearchTest, MovesTheCameraToAViewWhereTheKeyFails) {
    choose("painter");
    const glm::dvec3 before = params.camera.position;
    desk.click("depth/Find a view where this key fails");
    for (int frame = 0; frame < 12'000 && desk.workbench.views.hidden.panel.failure.search.is_running(); ++frame) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        ui.frames(1);
    }
    desk.settle();
    EXPECT_NE(params.camera.position, before);
    EXPECT_FALSE(desk.session.message.text.empty());
    params.view.shows = Shows::difference;
    desk.settle();
    EXPECT_GT(difference(desk.answer()->other->image, desk.answer()->camera->image).different, 100);
    desk.undo();
}

}  // namespace
}  // namespace viewing::test
