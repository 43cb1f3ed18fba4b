// The tree and the drawing order in the lower right: they are linked with the pictures in both directions, and each
// step has a sentence.
#include <algorithm>
#include <fstream>
#include <map>
#include <set>

#include "hidden_desk.h"
#include "topics/hidden/shown/order_rows.h"
#include "topics/hidden/shown/polygon_names.h"
#include "topics/hidden/shown/step_text.h"

namespace viewing::test {
namespace {

// ---- the tree --------------------------------------------------------------------------------------

TEST_F(HiddenViews, TheTreeIsOfferedWhenAnotherMethodIsSelected) {
    show(Topic::tree, VisibilityMethod::painter);
    EXPECT_TRUE(says("Only the BSP tree method has a tree to show."));
    ui.click("lower/Use the BSP tree");
    ui.frames(3);
    EXPECT_EQ(params.visibility.method, VisibilityMethod::bsp);
    EXPECT_TRUE(ui.has("lower/tree/0"));
    EXPECT_TRUE(says(std::to_string(result().tree->nodes.size()) + " nodes, "));
}

TEST_F(HiddenViews, ANodeUnderThePointerIsLinkedAndDescribed) {
    show(Topic::tree, VisibilityMethod::bsp);
    ui.hover("lower/tree/2");
    ui.frame();
    EXPECT_EQ(hidden().links.now.hovered_node, 2);
    EXPECT_TRUE(says("node 3: plane of "));
    ui.move_to({1.0F, 1.0F});
    ui.frame();
    EXPECT_EQ(hidden().links.now.hovered_node, -1);
}

TEST_F(HiddenViews, ClickingANodeSelectsItsPolygonUntilTheBackgroundIsClicked) {
    show(Topic::tree, VisibilityMethod::bsp);
    ui.click("lower/tree/1");
    ui.frames(10);
    EXPECT_EQ(hidden().links.now.selected_node, 1);
    EXPECT_EQ(node_that_holds(hidden().links.now.selected_fragment), 1);
    const RecordedItem view = ui.find("lower/tree/view");
    desk.click_at({view.min.x + 4.0F, view.max.y - 4.0F});
    ui.frames(2);
    EXPECT_EQ(hidden().links.now.selected_node, -1);
    EXPECT_EQ(hidden().links.now.selected_fragment, -1);
}

TEST_F(HiddenViews, SelectingAPolygonElsewhereSelectsItsNode) {
    show(Topic::tree, VisibilityMethod::bsp);
    const int count = static_cast<int>(result().fragments->size());
    for (int fragment = 0; fragment < count; ++fragment) {
        const int node = node_that_holds(fragment);
        ASSERT_GE(node, 0);
        hidden().links.next.selected_fragment = fragment;
        ui.move_to({1.0F, 1.0F});
        ui.frames(3);
        EXPECT_TRUE(says("node " + std::to_string(node + 1) + ": ")) << "fragment " << fragment;
        EXPECT_TRUE(ui.has("lower/tree/" + std::to_string(node))) << "the tree must scroll to the node";
    }
}

TEST_F(HiddenViews, HoveringAPolygonInTheCameraViewHighlightsItsNode) {
    show(Topic::tree, VisibilityMethod::bsp);
    const Polygon& polygon = result().fragments->front();
    ui.move_to(desk.in_camera_view(centroid(polygon)));
    ui.frames(3);
    const int hovered = hidden().links.now.hovered_fragment;
    ASSERT_GE(hovered, 0);
    EXPECT_TRUE(says("node " + std::to_string(node_that_holds(hovered) + 1) + ": "));
}

TEST_F(HiddenViews, MovingTheCameraChangesOnlyTheWalk) {
    show(Topic::tree, VisibilityMethod::bsp);
    const auto places = node_places();
    const std::uint64_t revision = hidden().links.tree.revision();
    ASSERT_FALSE(places.empty());
    const auto marks = [this] {
        std::vector<int> found;
        for (const widgets::TreeNode& node : hidden().links.tree.nodes()) found.push_back(node.mark);
        return found;
    };
    std::set<std::vector<int>> walks;
    const glm::dvec3 from = params.camera.position;
    for (int turn = 0; turn < 8; ++turn) {
        params.camera.position = {from.x * std::cos(turn), from.y * std::cos(2.0 * turn),
                                  from.z * std::cos(0.7 * turn)};
        desk.settle();
        EXPECT_EQ(node_places(), places);
        EXPECT_EQ(hidden().links.tree.revision(), revision);
        walks.insert(marks());
    }
    EXPECT_GT(walks.size(), 2U);
    params.visibility.splitter = BspSplitter::first;
    desk.settle();
    EXPECT_EQ(hidden().links.tree.revision(), revision + 1);
}

TEST_F(HiddenViews, MarksShowTheProgressOfTheWalk) {
    show(Topic::tree, VisibilityMethod::bsp);
    const auto nodes = static_cast<int>(result().tree->nodes.size());
    for (const int step : {0, 1, nodes, nodes + 1, nodes + 5, 2 * nodes - 1, -1}) {
        show(Topic::tree, VisibilityMethod::bsp, step);
        const int visited = step < 0 ? nodes : std::max(0, step - nodes);
        std::multiset<int> marks, expected;
        for (const widgets::TreeNode& node : hidden().links.tree.nodes()) {
            if (node.mark >= 0) marks.insert(node.mark);
            EXPECT_TRUE(node.mark > 0 || node.eye_side == 0);
        }
        for (int place = 1; place <= visited; ++place) expected.insert(place);
        EXPECT_EQ(marks, expected) << "step " << step;
        for (int place = 0; place < visited; ++place) {
            const BspVisit& visit = result().walk->visits[static_cast<std::size_t>(place)];
            const widgets::TreeNode& node = hidden().links.tree.nodes()[static_cast<std::size_t>(visit.node)];
            EXPECT_EQ(node.mark, place + 1);
            EXPECT_EQ(node.eye_side, visit.eye_side);
        }
    }
}

TEST_F(HiddenViews, ANodesSentenceSaysWhichSideIsDrawnFirst) {
    for (const BspOrder walk : {BspOrder::back_to_front, BspOrder::front_to_back}) {
        params.visibility.walk = walk;
        show(Topic::tree, VisibilityMethod::bsp);
        const glm::dvec3 eye = params.camera.position;
        for (std::size_t i = 0; i < result().tree->nodes.size(); ++i) {
            const std::string told = node_sentence(result(), static_cast<int>(i), hidden().links.tree);
            const glm::dvec4 plane = result().tree->nodes[i].plane;
            const bool in_front = glm::dot(glm::dvec3(plane), eye) + plane.w > 0.0;
            const bool front_first = in_front == (walk == BspOrder::front_to_back);
            EXPECT_NE(told.find(in_front ? "the eye is in front" : "the eye is behind"), std::string::npos) << told;
            EXPECT_NE(told.find(front_first ? "front side is drawn first" : "back side is drawn first"),
                      std::string::npos)
                << told;
        }
    }
    EXPECT_EQ(node_sentence(result(), -1, hidden().links.tree), "");
    EXPECT_EQ(node_sentence(result(), 1'000'000, hidden().links.tree), "");
}

// ---- the order -------------------------------------------------------------------------------------

TEST_F(HiddenViews, TheOrderIsOfferedWhenGlDrawsByItself) {
    show(Topic::order, VisibilityMethod::depth_buffer);
    ui.click("lower/Show their numbers");
    ui.frames(3);
    EXPECT_TRUE(params.visibility.numbers);
    EXPECT_TRUE(says("GL receives the polygons in scene order."));
    EXPECT_TRUE(says("1 "));
}

TEST_F(HiddenViews, TheListMarksTheProgressOfTheStep) {
    params.visibility.numbers = true;  // request the order even though GL draws by itself
    for (const VisibilityMethod method : {VisibilityMethod::none, VisibilityMethod::painter, VisibilityMethod::bsp}) {
        show(Topic::order, method, 0);
        const int first = method == VisibilityMethod::bsp ? static_cast<int>(result().tree->nodes.size()) : 0;
        for (const int step : {first, first + 1, first + 4}) {
            show(Topic::order, method, step);
            const OrderRows rows(result(), hidden().links.tree);
            ASSERT_EQ(rows.count(), static_cast<int>(result().fragments->size()));
            for (int place = 0; place < rows.count(); ++place) {
                EXPECT_EQ(rows.row(place).is_reached, place < result().drawn);
                EXPECT_EQ(rows.row(place).is_current, place == result().drawn - 1);
                EXPECT_EQ(rows.row(place).fragment, result().order[static_cast<std::size_t>(place)]);
            }
            EXPECT_EQ(rows.current(), result().drawn - 1);
        }
        show(Topic::order, method);
        const OrderRows all(result(), hidden().links.tree);
        EXPECT_EQ(all.current(), -1);
        EXPECT_TRUE(all.row(all.count() - 1).is_reached);
        EXPECT_EQ(all.row(all.count()).fragment, -1);
        EXPECT_EQ(all.row(-1).fragment, -1);
    }
}

TEST_F(HiddenViews, ThePaintersListShowsTheKeyDistanceOfEachPolygon) {
    params.visibility.sort_key = PainterKey::nearest;
    show(Topic::order, VisibilityMethod::painter);
    const OrderRows rows(result(), hidden().links.tree);
    EXPECT_STREQ(rows.detail_title(), "nearest vertex");
    for (int place = 0; place < rows.count(); ++place) {
        const Polygon& polygon = (*result().fragments)[static_cast<std::size_t>(rows.row(place).fragment)];
        double nearest = 1e300;
        for (const glm::dvec3& vertex : polygon.vertices)
            nearest = std::min(nearest, -(result().request.viewpoint.view_from_world * glm::dvec4(vertex, 1.0)).z);
        EXPECT_EQ(rows.row(place).detail, number_text(nearest, 3));
    }
}

TEST_F(HiddenViews, RowsAreLinkedWithTheirPolygons) {
    show(Topic::order, VisibilityMethod::painter);
    const std::string third = "lower/3 " + OrderRows(result(), hidden().links.tree).row(2).name;
    ui.hover(third);
    ui.frame();
    EXPECT_EQ(hidden().links.now.hovered_fragment, result().order[2]);
    ui.click(third);
    ui.frames(3);
    EXPECT_EQ(hidden().links.now.selected_fragment, result().order[2]);
    EXPECT_EQ(hidden().links.now.selected_node, -1);
    ui.click(third);
    EXPECT_EQ(hidden().links.now.selected_fragment, -1);

    show(Topic::order, VisibilityMethod::bsp);
    const OrderRows rows(result(), hidden().links.tree);
    ui.click("lower/2 " + rows.row(1).name);
    EXPECT_EQ(hidden().links.now.selected_fragment, result().order[1]);
    EXPECT_EQ(hidden().links.now.selected_node, node_that_holds(result().order[1]));
}

class LargeHiddenViews : public HiddenViews {
protected:
    LargeHiddenViews() : HiddenViews("opening") {}
};

TEST_F(LargeHiddenViews, LongListsBuildOnlyVisibleRowsAndScrollOnceToTheSelection) {
    show(Topic::order, VisibilityMethod::painter);
    ASSERT_GT(result().order.size(), 2000U);
    const OrderRows rows(result(), hidden().links.tree);
    const int far_down = rows.count() - 100;
    const std::string label = "lower/" + std::to_string(far_down + 1) + " " + rows.row(far_down).name;
    EXPECT_FALSE(ui.has(label));
    EXPECT_LT(std::ranges::count_if(
                  desk.recorded(),
                  [](const RecordedItem& item) { return item.label.find(", polygon ") != std::string::npos; }),
              60);
    hidden().links.next.selected_fragment = rows.row(far_down).fragment;
    ui.frames(4);
    ASSERT_TRUE(ui.has(label));
    const RecordedItem& row = ui.find(label);
    const Rect rect = desk.layout().lower_right;
    EXPECT_GE(row.min.y, rect.min.y);
    EXPECT_LE(row.max.y, rect.max.y);
    // Once the row is in view, the wheel can scroll away from it.
    ui.hover(label);
    for (int i = 0; i < 60; ++i) {
        ImGui::GetIO().MouseWheel = 5.0F;
        ui.frame();
    }
    ImGui::GetIO().MouseWheel = 0.0F;
    ui.frames(3);
    EXPECT_FALSE(ui.has(label));
}

TEST_F(LargeHiddenViews, TheCurrentRowIsScrolledTo) {
    show(Topic::order, VisibilityMethod::painter, 1);
    show(Topic::order, VisibilityMethod::painter, 1500);
    EXPECT_TRUE(says("1500 "));
    show(Topic::order, VisibilityMethod::painter, 700);
    EXPECT_TRUE(says("700 "));
}

// ---- the details of the step -----------------------------------------------------------------------

class CycleHiddenViews : public HiddenViews {
protected:
    CycleHiddenViews() : HiddenViews("cyclic-overlap") {}
};

TEST_F(CycleHiddenViews, TheLadderCrossesOutFailedTestsAndShowsTheDecidingOne) {
    show(Topic::order, VisibilityMethod::newell);
    const auto steps = static_cast<int>(result().newell->steps.size());
    ASSERT_GT(steps, 10);
    EXPECT_TRUE(says("apart in depth: "));
    EXPECT_FALSE(newell_ladder(result()));
    int cuts = 0, draws = 0;
    for (int step = 1; step < steps; step += 1 + steps / 150) {
        params.visibility.step = step;
        ui.frame();
        const NewellStep& taken = result().newell->steps[static_cast<std::size_t>(step - 1)];
        const std::optional<Ladder> ladder = newell_ladder(result());
        ASSERT_TRUE(ladder);
        EXPECT_TRUE(says(ladder->action));
        EXPECT_EQ(ladder->q.empty(), taken.q < 0);
        const auto decided = std::ranges::count(ladder->rungs, RungState::decided);
        const auto failed = std::ranges::count(ladder->rungs, RungState::failed);
        const auto* place = std::ranges::find(ladder->rungs, RungState::decided);
        cuts += taken.action == NewellAction::splits;
        draws += taken.action == NewellAction::draws;
        if (taken.q < 0) {
            EXPECT_EQ(decided + failed, 0);
        } else if (taken.decided_by == NewellTest::none) {
            EXPECT_EQ(failed, static_cast<std::ptrdiff_t>(ladder->rungs.size()));
        } else {
            EXPECT_EQ(decided, 1);
            EXPECT_EQ(place - ladder->rungs.begin(), failed);
            EXPECT_EQ(failed, static_cast<int>(taken.decided_by));
            EXPECT_TRUE(says(std::string("decided: ") + newell_test_text(taken.decided_by)));
        }
        EXPECT_EQ(ladder->action.find(" cuts A.") != std::string::npos, taken.action == NewellAction::splits);
    }
    EXPECT_GT(cuts, 0) << "this scene cannot be sorted without a cut";
    EXPECT_GT(draws, 0);
    params.visibility.step = 0;
    ui.frames(2);
    EXPECT_TRUE(says("The polygons are sorted by farthest vertex"));
}

TEST_F(HiddenViews, TheCompareOfTheDepthBufferIsShown) {
    show(Topic::order, VisibilityMethod::software_depth_buffer);
    const int steps = result().step_count;
    int kept = 0, written = 0;
    for (int step = 1; step < steps; step += std::max(1, steps / 40)) {
        params.visibility.step = step;
        ui.frame();
        const RasterStep& taken = *result().compare;
        const std::string told = compare_sentence(result());
        EXPECT_TRUE(told.starts_with("pixel (" + std::to_string(taken.x) + ", " + std::to_string(taken.y) + "): "))
            << told;
        EXPECT_EQ(told.ends_with("→ written"), taken.written) << told;
        EXPECT_TRUE(!taken.written || told.find(" < stored ") != std::string::npos) << told;
        EXPECT_TRUE(says(told));
        (taken.written ? written : kept) += 1;
        const OrderRows rows(result(), hidden().links.tree);
        ASSERT_GE(rows.current(), 0);
        EXPECT_EQ(rows.row(rows.current()).fragment, taken.polygon);
        EXPECT_TRUE(rows.current() + 1 == rows.count() || !rows.row(rows.current() + 1).is_reached);
    }
    EXPECT_GT(kept, 0);
    EXPECT_GT(written, 0);
    show(Topic::order, VisibilityMethod::software_depth_buffer, 0);
    EXPECT_EQ(OrderRows(result(), hidden().links.tree).current(), -1);
    EXPECT_FALSE(OrderRows(result(), hidden().links.tree).row(0).is_reached);
}

TEST_F(HiddenViews, ARayIsShownWithAllItsHitsAndTheFirstIsMarked) {
    show(Topic::order, VisibilityMethod::ray_cast);
    EXPECT_TRUE(says("One ray went through each pixel."));
    const IdImage image = result().image;
    std::size_t most = 0;
    for (const int y : {image.height / 3, image.height / 2, 2 * image.height / 3})
        for (int x = 0; x < image.width; x += std::max(1, image.width / 24)) {
            params.visibility.step = y * image.width + x + 1;
            ui.frames(2);
            ASSERT_TRUE(result().traced);
            const std::vector<RayHitRow> rows = ray_rows(result());
            EXPECT_TRUE(says(ray_sentence(result())));
            EXPECT_TRUE(std::ranges::is_sorted(rows, {}, &RayHitRow::distance));
            EXPECT_EQ(rows.empty() ? IdImage::background : rows.front().source, image.id(x, y));
            EXPECT_TRUE(rows.empty() || says("1 " + listed_name(result().surface.get(), rows.front().source)));
            most = std::max(most, rows.size());
        }
    EXPECT_GT(most, 1U);
}

TEST_F(HiddenViews, PolygonsAreNamedByObjectAndCountedFromOne) {
    show(Topic::order, VisibilityMethod::painter);
    const SceneSurface& surface = *result().surface;
    const std::string& first = surface.scene.objects[0].description.name;
    EXPECT_EQ(polygon_name(&surface, 0), "polygon 1 of " + first);
    EXPECT_EQ(listed_name(&surface, 1), first + ", polygon 2");
    const std::string& second = surface.scene.objects[1].description.name;
    EXPECT_EQ(listed_name(&surface, surface.first_source[1]), second + ", polygon 1");
    for (const int source : {-1, -1000, surface.source_count(), 1'000'000}) {
        EXPECT_EQ(polygon_name(&surface, source), "");
        EXPECT_EQ(polygon_color(&surface, source), 0U);
    }
    EXPECT_EQ(listed_name(nullptr, 0), "");
}

// ---- empty and outdated results ---------------------------------------------------------------------

TEST_F(HiddenViews, IndicesOfAnotherResultAreIgnored) {
    const PolygonLink links[] = {{1'000'000, 1'000'000, 1'000'000, 1'000'000}, {-7, -7, -7, -7}, {0, 20, 20, 0}};
    for (const Topic topic : {Topic::tree, Topic::order, Topic::growth})
        for (const PolygonLink& link : links)
            for (int method = 0; method < 7; ++method)
                for (const int step : {-1, 0, 20}) {
                    params.visibility.method = static_cast<VisibilityMethod>(method);
                    params.visibility.step = step;
                    for (int frame = 0; frame < 2; ++frame) {
                        desk.params().view.lower_right = topic;
                        hidden().links.now = hidden().links.next = link;
                        ui.frame();
                    }
                }
}

TEST(HiddenViewsEmpty, AnEmptySceneDrawsNothing) {
    const TemporaryFolder folder;
    std::ofstream("empty.json") << R"({"version": 1, "scene": {"objects": []}})";
    Desk desk({1600, 900}, "empty.json");
    for (const Topic topic : {Topic::tree, Topic::order, Topic::growth})
        for (int method = 0; method < 7; ++method)
            for (const int step : {-1, 0, 3}) {
                desk.params().visibility.method = static_cast<VisibilityMethod>(method);
                desk.params().visibility.step = step;
                desk.ui.frame();
                desk.params().view.lower_right = topic;
                desk.ui.frames(2);
            }
    desk.params().visibility.method = VisibilityMethod::painter;
    desk.params().visibility.step = -1;
    desk.ui.frame();
    desk.params().view.lower_right = Topic::order;
    desk.ui.frames(3);
    EXPECT_TRUE(desk.ui.has("lower/Nothing to draw."));
}

TEST(HiddenViewsLayout, TheTreeAndItsSentencesStayInPlaceAtEverySize) {
    for (const ImVec2 size : {ImVec2(1600, 900), ImVec2(800, 600), ImVec2(1280, 720)})
        for (const double scale : {1.0, 2.0})
            for (const Theme theme : {Theme::dark, Theme::light, Theme::projector}) {
                Desk desk(size, "bsp-walk");
                desk.params().ui.scale = scale;
                desk.params().ui.theme = theme;
                desk.apply_looks();
                desk.params().view.lower_right = Topic::tree;
                desk.params().visibility.step = 20;
                desk.settle();
                const Rect rect = desk.layout().lower_right;
                if (rect.height() < 60.0F * desk.workbench.widgets.scale) continue;
                const RecordedItem view = desk.ui.find("lower/tree/view");
                EXPECT_GE(view.min.y, rect.min.y);
                EXPECT_LE(view.max.x, rect.max.x + 0.5F);
                EXPECT_LE(view.max.y, rect.max.y + 0.5F);
                for (const RecordedItem& item : desk.recorded()) {
                    const bool is_sentence =
                        item.label.starts_with("lower/node ") || item.label.find(" deep, ") != std::string::npos;
                    if (!is_sentence) continue;
                    EXPECT_TRUE(item.max.y <= view.min.y + 0.5F || item.min.y >= view.max.y - 0.5F) << item.label;
                    EXPECT_LE(item.max.y, rect.max.y + 0.5F) << item.label;
                    EXPECT_LE(item.max.x, rect.max.x + 0.5F) << item.label;
                }
            }
}

}  // namespace
}  // namespace viewing::test
