// The tree diagram: properties of the layout for every kind of tree, and pan, zoom, folding and selection under real
// input.
#include <cmath>
#include <random>

#include "ui/letters.h"
#include "widget_test.h"
#include "widgets/diagrams.h"

namespace widgets::test {
namespace {

void link(std::vector<TreeNode>& nodes, int parent, int child, bool front) {
    (front ? nodes[static_cast<std::size_t>(parent)].front : nodes[static_cast<std::size_t>(parent)].back) = child;
    nodes[static_cast<std::size_t>(child)].parent = parent;
}

/// Returns a tree of nodes that were inserted one after the other at random places.
std::vector<TreeNode> random_tree(int count, unsigned seed) {
    std::mt19937 random(seed);
    std::vector<TreeNode> nodes(static_cast<std::size_t>(count));
    for (int i = 1; i < count; ++i) {
        int parent = 0;
        for (;;) {
            const bool front = random() % 3 != 0;
            TreeNode& node = nodes[static_cast<std::size_t>(parent)];
            const int child = front ? node.front : node.back;
            if (child < 0) {
                link(nodes, parent, i, front);
                break;
            }
            parent = child;
        }
    }
    return nodes;
}

/// Returns a chain of nodes; `front_at` decides on which side of the previous node each one hangs.
template <class FrontAt>
std::vector<TreeNode> chain(int count, FrontAt front_at) {
    std::vector<TreeNode> nodes(static_cast<std::size_t>(count));
    for (int i = 1; i < count; ++i) link(nodes, i - 1, i, front_at(i));
    return nodes;
}

std::vector<TreeNode> complete_tree(int levels) {
    std::vector<TreeNode> nodes((std::size_t{1} << levels) - 1);
    for (int i = 1; i < static_cast<int>(nodes.size()); ++i) link(nodes, (i - 1) / 2, i, i % 2 == 1);
    return nodes;
}

/// Returns a complete tree with a chain below each leaf. All rows from the ninth on are equally wide, so the tree is
/// both wide and tall.
std::vector<TreeNode> hanging_chains() {
    std::vector<TreeNode> nodes = complete_tree(9);
    const int leaves = 256, length = 200;
    const int first_leaf = static_cast<int>(nodes.size()) - leaves;
    nodes.resize(nodes.size() + static_cast<std::size_t>(leaves * length));
    for (int i = 0; i < leaves * length; ++i) {
        const int node = first_leaf + leaves + i;
        link(nodes, node - leaves, node, (i / leaves) % 2 == 0);
    }
    return nodes;
}

/// Checks the properties that every layout must have, node by node.
void expect_tidy(const std::vector<TreeNode>& nodes, const TreeLayout& layout, std::size_t shown) {
    ASSERT_EQ(layout.order.size(), shown);
    ASSERT_EQ(layout.level.size(), nodes.size());
    constexpr double rounding = 1e-6;
    int wrong = 0;
    for (int level = 0; level < layout.LevelCount(); ++level) {
        const std::span<const int> row = layout.Level(level);
        for (std::size_t i = 0; i < row.size(); ++i) {
            const auto node = static_cast<std::size_t>(row[i]);
            if (layout.level[node] != level) ++wrong;
            if (i > 0 && layout.x[node] - layout.x[static_cast<std::size_t>(row[i - 1])] < 1.0 - rounding) ++wrong;
            if (layout.x[node] < layout.min_x || layout.x[node] > layout.max_x) ++wrong;
        }
    }
    EXPECT_EQ(wrong, 0) << "nodes of one level are at least 1 apart, in order";
    for (const int index : layout.order) {
        const TreeNode& node = nodes[static_cast<std::size_t>(index)];
        const double x = layout.x[static_cast<std::size_t>(index)];
        const int level = layout.level[static_cast<std::size_t>(index)];
        const auto shown_child = [&](int child) {
            return child >= 0 && layout.level[static_cast<std::size_t>(child)] >= 0;
        };
        if (shown_child(node.front)) {
            EXPECT_LT(layout.x[static_cast<std::size_t>(node.front)], x) << "the front is on the left of " << index;
            EXPECT_EQ(layout.level[static_cast<std::size_t>(node.front)], level + 1);
        }
        if (shown_child(node.back)) {
            EXPECT_GT(layout.x[static_cast<std::size_t>(node.back)], x) << "the back is on the right of " << index;
            EXPECT_EQ(layout.level[static_cast<std::size_t>(node.back)], level + 1);
        }
        if (shown_child(node.front) && shown_child(node.back)) {
            EXPECT_NEAR(layout.x[static_cast<std::size_t>(node.front)] + layout.x[static_cast<std::size_t>(node.back)],
                        2.0 * x, rounding)
                << "a parent is above the middle of its children";
        }
    }
}

TEST(TreeLayoutTest, RandomTreesAreTidy) {
    for (unsigned seed = 1; seed <= 40; ++seed) {
        const std::vector<TreeNode> nodes = random_tree(static_cast<int>(seed) * 7, seed);
        expect_tidy(nodes, LayOutTree(nodes), nodes.size());
    }
}

TEST(TreeLayoutTest, ACompleteTreeIsAsWideAsItsLeaves) {
    const std::vector<TreeNode> nodes = complete_tree(6);
    const TreeLayout layout = LayOutTree(nodes);
    expect_tidy(nodes, layout, 63);
    EXPECT_EQ(layout.LevelCount(), 6);
    EXPECT_NEAR(layout.max_x - layout.min_x, 31.0, 1e-9);
}

TEST(TreeLayoutTest, ADeepNarrowSubtreeFitsBesideAShallowOne) {
    // Tests a threaded contour: the front subtree ends at level 2, and the back one continues to the left below it.
    std::vector<TreeNode> nodes(9);
    link(nodes, 0, 1, true);
    link(nodes, 1, 2, false);
    link(nodes, 0, 3, false);
    link(nodes, 3, 4, true);
    for (int i = 4; i < 8; ++i) link(nodes, i, i + 1, true);
    expect_tidy(nodes, LayOutTree(nodes), nodes.size());
}

TEST(TreeLayoutTest, DegenerateSizes) {
    EXPECT_EQ(LayOutTree({}).LevelCount(), 0);
    const std::vector<TreeNode> one(1);
    expect_tidy(one, LayOutTree(one), 1);

    const auto down_left = chain(2000, [](int) { return true; });
    expect_tidy(down_left, LayOutTree(down_left), 2000);
    EXPECT_NEAR(LayOutTree(down_left).min_x, -999.5, 1e-6);
    const auto zigzag = chain(2000, [](int i) { return i % 2 == 0; });
    expect_tidy(zigzag, LayOutTree(zigzag), 2000);
    EXPECT_NEAR(LayOutTree(zigzag).max_x - LayOutTree(zigzag).min_x, 0.5, 1e-6);

    const std::vector<TreeNode> large = random_tree(100'000, 3);
    const TreeLayout layout = LayOutTree(large);
    expect_tidy(large, layout, large.size());
    EXPECT_EQ(layout.subtree_size[0], 100'000);
}

TEST(TreeLayoutTest, LinksThatFormNoTreeAreIgnored) {
    std::vector<TreeNode> nodes = random_tree(10, 1);
    nodes[9].front = 0;              // back to the root: a cycle
    nodes[9].back = 9;               // to itself
    nodes[8].back = 1000;            // out of range
    nodes[7].front = -7;             // negative
    nodes[0].back = nodes[0].front;  // the same child twice
    const TreeLayout layout = LayOutTree(nodes);
    const int reached = static_cast<int>(layout.order.size());
    EXPECT_EQ(layout.subtree_size[0], reached);
    EXPECT_GE(reached, 2);
    EXPECT_LE(reached, 10);

    std::vector<TreeNode> strangers(3);  // nodes without a parent
    EXPECT_EQ(LayOutTree(strangers).order.size(), 1U);
    EXPECT_EQ(LayOutTree(strangers).level[2], -1);
}

TEST(TreeLayoutTest, AFoldedNodeKeepsItsSizeAndHidesItsDescendants) {
    const std::vector<TreeNode> nodes = complete_tree(4);
    const TreeLayout layout = LayOutTree(nodes, {1, 99, -3});
    expect_tidy(nodes, layout, 15 - 6);
    EXPECT_EQ(layout.level[1], 1);
    EXPECT_EQ(layout.level[3], -1);
    EXPECT_EQ(layout.subtree_size[1], 7);
}

class TreeDiagramTest : public WidgetTest {
protected:
    std::vector<TreeNode> nodes = complete_tree(4);
    TreeDiagramState state;
    int selected = -1;
    std::uint64_t revision = 1;
    TreeDiagramStyle style{.size = ImVec2(560, 400)};

    void start_diagram() {
        start([this] { return TreeDiagram("tree", nodes, revision, state, selected, style); });
    }
    ImVec2 center(const char* label) const {
        const RecordedItem& item = ui.find(label);
        return ImVec2(0.5F * (item.min.x + item.max.x), 0.5F * (item.min.y + item.max.y));
    }
    void wheel(float notches) {
        ImGui::GetIO().MouseWheel = notches;
        ui.frame();
        ui.frame();
    }
    static int vertices() { return ImGui::GetDrawData()->TotalVtxCount; }
};

TEST_F(TreeDiagramTest, FitsAtFirstAndThenStaysStill) {
    start_diagram();
    const RecordedItem view = ui.find("tree/view");
    for (const char* label : {"tree/0", "tree/7", "tree/14"}) {
        EXPECT_GE(ui.find(label).min.x, view.min.x) << label;
        EXPECT_LE(ui.find(label).max.x, view.max.x) << label;
        EXPECT_LE(ui.find(label).max.y, view.max.y) << label;
    }
    const ImVec2 root = center("tree/0"), leaf = center("tree/11");
    for (TreeNode& node : nodes) node.mark = 3;
    for (TreeNode& node : nodes) node.eye_side = -1;
    style.current = 5;
    ui.frames(5);
    EXPECT_EQ(center("tree/0").x, root.x);
    EXPECT_EQ(center("tree/11").y, leaf.y);
    style.shown_count = 4;
    ui.frames(2);
    EXPECT_EQ(center("tree/0").x, root.x);
    EXPECT_FALSE(ui.has("tree/4"));
    EXPECT_EQ(changes, 0);
}

TEST_F(TreeDiagramTest, AClickSelectsAndTheBackgroundDeselects) {
    start_diagram();
    ui.click("tree/4");
    EXPECT_EQ(selected, 4);
    EXPECT_EQ(state.hovered, 4);
    EXPECT_EQ(changes, 1);
    ui.click("tree/4");
    EXPECT_EQ(changes, 1);
    ui.hover("tree/view", 0.02F, 0.97F);
    ui.press();
    ui.release();
    EXPECT_EQ(selected, -1);
    EXPECT_EQ(state.hovered, -1);
    EXPECT_EQ(changes, 2);
}

TEST_F(TreeDiagramTest, DraggingMovesTheTreeAndSelectsNothing) {
    start_diagram();
    const ImVec2 before = center("tree/6");
    ui.drag("tree/2", 37, -21);
    EXPECT_NEAR(center("tree/6").x - before.x, 37.0, 0.01);
    EXPECT_NEAR(center("tree/6").y - before.y, -21.0, 0.01);
    EXPECT_EQ(selected, -1);
    ui.drag("tree/2", -30000, -30000);
    const RecordedItem view = ui.find("tree/view");
    EXPECT_GT(center("tree/14").x, view.min.x) << "some of the tree stays in the view";
    EXPECT_GT(center("tree/14").y, view.min.y);
    ui.click("tree/fit");
    ui.frame();
    EXPECT_NEAR(center("tree/6").x, before.x, 0.01);
}

TEST_F(TreeDiagramTest, TheWheelZoomsAboutTheMouse) {
    start_diagram();
    ui.hover("tree/4");
    const ImVec2 fixed = center("tree/4");
    const float apart = center("tree/5").x - fixed.x;
    wheel(1.0F);
    EXPECT_NEAR(center("tree/4").x, fixed.x, 0.01);
    EXPECT_NEAR(center("tree/4").y, fixed.y, 0.01);
    EXPECT_NEAR((center("tree/5").x - center("tree/4").x) / apart, 1.2, 1e-4);
    wheel(-1.0F);
    EXPECT_NEAR(center("tree/5").x - center("tree/4").x, apart, 0.01);
    wheel(-500.0F);
    EXPECT_GT(state.zoom, 0.0);
    wheel(500.0F);
    EXPECT_LT(state.zoom, 10.0);
}

TEST_F(TreeDiagramTest, TheWheelDoesNotScrollTheSurroundingWindow) {
    float scrolled = 0.0F;
    start([&] {
        ImGui::BeginChild("panel", ImVec2(580, 300));
        TreeDiagram("tree", nodes, revision, state, selected, style);
        ImGui::Dummy(ImVec2(10, 2000));
        scrolled = ImGui::GetScrollY();
        ImGui::EndChild();
        return false;
    });
    ui.hover("tree/1");
    const double zoom = state.zoom;
    wheel(-3.0F);
    EXPECT_LT(state.zoom, zoom);
    EXPECT_EQ(scrolled, 0.0F);
}

TEST_F(TreeDiagramTest, ADoubleClickFoldsInPlace) {
    start_diagram();
    const ImVec2 before = center("tree/1");
    ui.double_click("tree/1");
    EXPECT_FALSE(ui.has("tree/3"));
    EXPECT_FALSE(ui.has("tree/10"));
    EXPECT_TRUE(ui.has("tree/5"));
    EXPECT_EQ(ui.text_of("tree/1"), "folded");
    EXPECT_NEAR(center("tree/1").x, before.x, 0.01);
    ui.double_click("tree/1");
    EXPECT_TRUE(ui.has("tree/10"));
    EXPECT_NEAR(center("tree/1").x, before.x, 0.01);
    ui.double_click("tree/9");
    EXPECT_TRUE(state.collapsed.empty()) << "a leaf has nothing to fold";
}

TEST_F(TreeDiagramTest, TheTriangleBelowANodeFoldsWithoutSelecting) {
    start_diagram();
    ui.hover("tree/2");
    ui.frame();
    const RecordedItem node = ui.find("tree/2");
    ui.move_to(ImVec2(0.5F * (node.min.x + node.max.x), node.max.y + 6.0F));
    EXPECT_EQ(state.hovered, 2);
    ui.press();
    ui.release();
    ui.frame();
    EXPECT_TRUE(state.collapsed.contains(2));
    EXPECT_FALSE(ui.has("tree/6"));
    EXPECT_EQ(selected, -1);
    ui.frame(1.0F);
    ui.press();
    ui.release();
    ui.frame();
    EXPECT_FALSE(state.collapsed.contains(2));
}

TEST_F(TreeDiagramTest, ADoubleClickOnTheBackgroundFits) {
    start_diagram();
    const ImVec2 before = center("tree/0");
    ui.drag("tree/0", 60, 30);
    ui.hover("tree/view", 0.02F, 0.97F);
    ui.frame(1.0F);
    for (int i = 0; i < 2; ++i) {
        ui.press();
        ui.release();
    }
    ui.frame();
    EXPECT_NEAR(center("tree/0").x, before.x, 0.01);
}

TEST_F(TreeDiagramTest, ANewRevisionUnfoldsAndFits) {
    start_diagram();
    ui.double_click("tree/1");
    ui.drag("tree/0", 60, 30);
    nodes = complete_tree(3);
    ++revision;
    ui.frames(2);
    EXPECT_TRUE(state.collapsed.empty());
    EXPECT_TRUE(ui.has("tree/6"));
    EXPECT_FALSE(ui.has("tree/7"));
    nodes.clear();  // although the revision number stays the same
    ui.frames(2);
    EXPECT_FALSE(ui.has("tree/0"));
    EXPECT_EQ(state.hovered, -1);
}

TEST_F(TreeDiagramTest, RevealUnfoldsAndScrollsToTheNode) {
    nodes = chain(2000, [](int) { return false; });
    start_diagram();
    EXPECT_TRUE(ui.has("tree/0")) << "a tree too large to read at once shows its top";
    EXPECT_FALSE(ui.has("tree/1999"));
    state.collapsed = {3, 500, 1998};
    ui.frame();
    state.reveal_next = 1999;
    ui.frames(2);
    ASSERT_TRUE(ui.has("tree/1999"));
    const RecordedItem view = ui.find("tree/view");
    EXPECT_GE(ui.find("tree/1999").min.x, view.min.x);
    EXPECT_LE(ui.find("tree/1999").max.y, view.max.y);
    EXPECT_TRUE(state.collapsed.empty());
    state.reveal_next = 5000;
    ui.frames(2);
    EXPECT_TRUE(ui.has("tree/1999")) << "there is no such node: nothing happens";
}

TEST_F(TreeDiagramTest, OnlyVisiblePartsAreDrawnAtAnySizeAndZoom) {
    // ImGui uses 16-bit indices here, so it could not draw many more vertices.
    constexpr int most = 60'000;
    for (std::vector<TreeNode> tree : {std::vector<TreeNode>{}, random_tree(1, 9), random_tree(2, 9),
                                       random_tree(100'000, 9), complete_tree(17), hanging_chains()}) {
        nodes = std::move(tree);
        const int count = static_cast<int>(nodes.size());
        for (TreeNode& node : nodes) {
            node.label = "1234";
            node.mark = 77;
            node.eye_side = 1;
        }
        state = {};
        state.collapsed = {-1};  // prevents folding at first
        style.size = ImVec2(590, 700);
        start_diagram();
        EXPECT_LT(vertices(), most);
        ui.hover("tree/view", 0.5F, 0.2F);
        for (int i = 0; i < 40; ++i) {
            wheel(-1.0F);
            ASSERT_LT(vertices(), most) << count << " nodes at zoom " << state.zoom;
        }
        selected = count / 2;
        state.reveal_next = selected;
        ui.frames(2);
        EXPECT_EQ(ui.has("tree/" + std::to_string(selected)), count > 0);
    }
}

TEST_F(TreeDiagramTest, ATreeTooWideToReadIsFoldedAtFirst) {
    nodes = complete_tree(14);
    style.current = 16'000;
    start_diagram();
    EXPECT_GE(state.zoom, 0.7) << "readable";
    EXPECT_FALSE(state.collapsed.empty());
    const RecordedItem view = ui.find("tree/view");
    int drawn = 0;
    for (const RecordedItem& item : context.recorded) {
        if (item.text != "open" && item.text != "folded") continue;
        ++drawn;
        EXPECT_GE(item.min.x, view.min.x) << item.label;
        EXPECT_LE(item.max.x, view.max.x) << item.label;
    }
    EXPECT_GE(drawn, 15) << "four levels fit";
    EXPECT_LE(drawn, 31);
    state.reveal_next = 16'000;
    ui.frames(2);
    EXPECT_TRUE(ui.has("tree/16000"));
}

TEST_F(TreeDiagramTest, OnStageNumbersAreWholeAndKeepTheirSize) {
    context.is_on_stage = true;
    nodes = complete_tree(10);
    for (std::size_t i = 0; i < nodes.size(); ++i) nodes[i].mark = 1000 + static_cast<int>(i);
    style.size = ImVec2(420, 230);
    start_diagram();
    const RecordedItem view = ui.find("tree/view");
    const viewing::test::Page page(ImGui::GetIO().Fonts->Fonts);
    std::vector<viewing::test::Letter> letters;
    for (int i = 0; i < ImGui::GetDrawData()->CmdListsCount; ++i)
        for (const viewing::test::Letter& letter : page.letters(*ImGui::GetDrawData()->CmdLists[i]))
            if (letter.character >= '0' && letter.character <= '9') letters.push_back(letter);
    ASSERT_GE(state.collapsed.size(), 4U);
    EXPECT_GE(letters.size(), 7U * 4U + state.collapsed.size() * 3U) << "each node's rank, and what the lowest hide";
    for (const viewing::test::Letter& letter : letters) {
        EXPECT_GE(letter.line_height, ImGui::GetIO().Fonts->Fonts[0]->FontSize);
        EXPECT_FALSE(letter.is_shaved);
        EXPECT_LE(letter.max.y, std::min(view.max.y, letter.clip.w)) << "cut at the lower edge";
        for (const viewing::test::Letter& other : letters) {
            const bool are_apart = other.max.x <= letter.min.x || letter.max.x <= other.min.x ||
                                   other.max.y <= letter.min.y || letter.max.y <= other.min.y;
            EXPECT_TRUE(&other == &letter || are_apart) << "two digits at " << letter.min.x << ", " << letter.min.y;
        }
    }
}

TEST_F(TreeDiagramTest, ALargeFoldOpensAFewLevelsAtATime) {
    nodes = complete_tree(12);
    state.collapsed = {1, 2};
    start_diagram();
    ui.double_click("tree/1");
    EXPECT_FALSE(state.collapsed.contains(1));
    EXPECT_EQ(state.layout.order.size(), 3U + 2U + 4U + 8U + 16U);
    state.reveal_next = 4094;  // the last leaf, below 2
    ui.frames(2);
    EXPECT_TRUE(ui.has("tree/4094"));
    EXPECT_LT(state.layout.order.size(), 150U) << "nodes off the path stay folded";
}

TEST_F(TreeDiagramTest, NodesFoldedByTheCallerStayFolded) {
    nodes = complete_tree(14);
    state.collapsed = {1};
    start_diagram();
    EXPECT_EQ(state.collapsed.size(), 1U);
    EXPECT_TRUE(ui.has("tree/0"));
}

TEST_F(TreeDiagramTest, TheTooltipCountsTheNodesOnEachSide) {
    nodes[2].label = "polygon 7";
    start_diagram();
    ui.hover("tree/2");
    EXPECT_FALSE(ui.has("tree/tooltip"));
    ui.frames(60);
    ASSERT_TRUE(ui.has("tree/tooltip"));
    EXPECT_NE(ui.text_of("tree/tooltip").find("front: 3, behind: 3"), std::string::npos);
}

}  // namespace
}  // namespace widgets::test
