// The diagrams of diagrams.h with an invented method: a tree that is built and then traversed, the bar that steps
// through both, and the cost of methods as scenes grow.
#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "widgets/demo/show_demo.h"
#include "widgets/diagrams.h"

namespace widgets {

namespace {

constexpr int node_count = 40;

/// A random tree, the same on each run. Its labels are polygon numbers.
struct DemoTree {
    std::vector<std::string> labels;
    std::vector<TreeNode> nodes;
    std::vector<int> walk;  ///< traversal from back to front, with the eye on a random side of each plane

    DemoTree() : nodes(node_count) {
        std::mt19937 random(5);
        for (int i = 0; i < node_count; ++i) labels.push_back(std::to_string(random() % 100));
        for (int i = 1; i < node_count; ++i) Insert(i, random);
        for (int i = 0; i < node_count; ++i) {
            At(i).label = labels[i];
            At(i).eye_side = random() % 2 == 0 ? 1 : -1;
        }
        Walk(0);
    }
    TreeNode& At(int node) { return nodes[node]; }

private:
    void Insert(int node, std::mt19937& random) {
        int parent = 0;
        for (;;) {
            int& child = random() % 2 == 0 ? At(parent).front : At(parent).back;
            if (child < 0) {
                child = node;
                At(node).parent = parent;
                return;
            }
            parent = child;
        }
    }
    void Walk(int node) {
        if (node < 0) return;
        const bool in_front = At(node).eye_side > 0;
        Walk(in_front ? At(node).back : At(node).front);
        walk.push_back(node);
        Walk(in_front ? At(node).front : At(node).back);
    }
};

void ShowTreeAndSteps(const Palette& palette) {
    static DemoTree tree;
    static TreeDiagramState state;
    static int selected = 3, step = -1;
    static StepPlayer player{.steps_per_s = 10.0F};

    if (!Section("Tree and steps", true, "drag · wheel · double-click")) return;
    StepBar("steps", step, 2 * node_count, player, ImGui::GetIO().DeltaTime);
    // The first node_count steps each build a node; the later ones each visit a node.
    const int reached = step < 0 ? 2 * node_count : step, visited = std::max(reached - node_count, 0);
    for (int i = 0; i < node_count; ++i) {
        tree.At(i).mark = -1;
        tree.At(i).color = i % 3 == 0 ? palette.plane : palette.mirror;
    }
    for (int i = 0; i < visited; ++i) tree.At(tree.walk[i]).mark = i + 1;
    TreeDiagram("tree", tree.nodes, 1, state, selected,
                {.shown_count = std::min(reached, node_count),
                 .current = visited > 0 && step >= 0 ? tree.walk[static_cast<std::size_t>(visited) - 1] : -1,
                 .size = ImVec2(0.0F, 300.0F * CurrentContext().scale)});

    int no_step = -1;
    StepPlayer none;
    StepBar("no steps", no_step, 0, none, 0.0);
}

void ShowCosts(const Palette& palette) {
    if (!Section("Costs as scenes grow", true, "hover a point")) return;
    struct Method {
        const char* name;
        double factor, exponent;
        int points;  ///< fewer for a slow method, whose curve ends early
        ImU32 color;
    };
    const Method methods[] = {
        {"painter", 2e-4, 1.1, 9, palette.light},     {"Newell", 4e-5, 2.0, 6, palette.plane},
        {"BSP walk", 2e-4, 1.0, 9, palette.camera},   {"BSP build", 1e-3, 1.4, 8, palette.mirror},
        {"z-buffer", 3e-2, 0.55, 9, palette.trouble}, {"ray casting", 4.0, 0.12, 9, palette.text}};
    std::vector<std::vector<glm::dvec2>> points;
    for (const Method& method : methods) {
        points.emplace_back();
        for (int i = 0; i < method.points; ++i) {
            const double count = std::pow(10.0, 1.0 + 0.5 * i);
            points.back().emplace_back(count, method.factor * std::pow(count, method.exponent));
        }
    }
    std::vector<ChartCurve> curves;
    for (std::size_t i = 0; i < points.size(); ++i) {
        curves.push_back(
            {.name = methods[i].name, .color = methods[i].color, .points = points[i], .emphasized = i == 2});
    }
    LogChart("costs", curves,
             {.x = {.title = "polygons"},
              .y = {.title = "time in ms"},
              .marker_x = 740.0,
              .marker_label = "this scene",
              .size = ImVec2(0.0F, 260.0F * CurrentContext().scale)});
}

}  // namespace

void ShowDiagramsDemo() {
    const Palette& palette = CurrentContext().palette;
    ShowTreeAndSteps(palette);
    ShowCosts(palette);
}

}  // namespace widgets
