// Diagrams of how a method works: its tree, what it costs as the scene grows, and a bar to go through its steps. As in
// widgets.h, every one edits the value it is given and says whether it did. Read show_diagrams_demo.cpp for their use.
#pragma once

#include <glm/glm.hpp>
#include <unordered_set>

#include "widgets/widgets.h"

namespace widgets {

// ---- a binary tree ---------------------------------------------------------------------------------

/// A node of a tree in a flat array: the root first, children after their parent. A link counts only where the child
/// names the same parent, so that any input is a tree; nodes that the root does not reach are not shown.
struct TreeNode {
    int parent = -1, front = -1, back = -1;  ///< indices; −1: none
    std::string_view label = {};             ///< short: a number
    int mark = -1;                           ///< its number in a walk, drawn beside it; −1: not visited
    ImU32 color = 0;                         ///< of what it stands for; 0: neutral
    int eye_side = 0;  ///< 1: the eye is in front, −1: behind; that edge is accentuated. 0: none
};

/// Where the nodes of a tree stand: its levels in rows, front before back, at least 1 apart within a row, a parent in
/// the middle above its children. One pass over the nodes, without recursion. Source: Reingold and Tilford 1981.
struct TreeLayout {
    std::vector<double> x;          ///< of each node, in node widths from the root; meaningless where level < 0
    std::vector<int> level;         ///< of each node, 0 at the root; −1: not shown
    std::vector<int> order;         ///< the nodes that are shown, level by level, each from left to right
    std::vector<int> level_begin;   ///< where each level begins in `order`; one more at the end
    std::vector<int> subtree_size;  ///< of each node, itself included, folded or not
    double min_x = 0.0, max_x = 0.0;

    int LevelCount() const { return static_cast<int>(level_begin.size()) - 1; }
    std::span<const int> Level(int index) const;
};
/// The nodes in `collapsed` keep their place, what is below them is not shown.
TreeLayout LayOutTree(std::span<const TreeNode> nodes, const std::unordered_set<int>& collapsed = {});

/// What a tree diagram remembers between frames. The caller may change all but the last part.
struct TreeDiagramState {
    glm::dvec2 pan{0.0};  ///< from the view's upper left corner to the root, in design pixels
    double zoom = 1.0;
    std::unordered_set<int> collapsed;  ///< nodes whose subtrees are folded
    bool fit_next = true;               ///< the next frame shows the whole tree, or its top where that is too large
    bool fit_whole_next = false;        ///< the next frame shows all of it, however small
    int reveal_next = -1;               ///< the next frame unfolds and moves as little as it takes to show this node
    int hovered = -1;                   ///< out: the node under the pointer

    TreeLayout layout;  ///< of `laid_out_revision` and `laid_out_collapsed`
    std::uint64_t laid_out_revision = 0;
    std::unordered_set<int> laid_out_collapsed;
    bool is_laid_out = false;
    bool fold_next = false;
    float drag_distance_px = 0.0F;
    glm::dvec2 pan_pressed{0.0};  ///< where a drag began
    int pressed = -1;             ///< the node under the last press
    bool pressed_triangle = false;
};

struct TreeDiagramStyle {
    int shown_count = 1 << 30;  ///< only nodes below this index are drawn: the steps of the build so far
    int current = -1;           ///< the node of the current visit, filled; inside a fold, the folded node
    int lit = -1;               ///< the node linked with what the pointer is on elsewhere; likewise
    ImVec2 size{0.0F, 0.0F};    ///< in pixels; 0: what is there
};

/// A tree that pans (drag), zooms (wheel), folds (double-click, or the triangle below a node; a large fold opens some
/// levels at a time), selects (click; on the ground: none) and otherwise stays still: its layout follows only
/// `revision`, to be changed with the nodes' links, and what is folded. A new revision unfolds what can be read at
/// once, folds the rest and fits. The edge to the front is marked +, to the back −. True when `selected` (−1: none)
/// changed.
bool TreeDiagram(const char* id, std::span<const TreeNode> nodes, std::uint64_t revision, TreeDiagramState& state,
                 int& selected, const TreeDiagramStyle& style = {});

// ---- curves on logarithmic axes --------------------------------------------------------------------

struct ChartCurve {
    const char* name;
    ImU32 color;
    std::span<const glm::dvec2> points;  ///< from left to right; one that is not finite and positive leaves a gap
    bool emphasised = false;
};

/// Without a sensible range (0 < min < max) an axis spans the whole decades of what is on it.
struct ChartAxis {
    const char* title = "";  ///< with its unit
    double min = 0.0, max = 0.0;
};

struct LogChartStyle {
    ChartAxis x, y;
    double marker_x = 0.0;  ///< a vertical line here; ≤ 0: none
    const char* marker_label = "";
    ImVec2 size{0.0F, 0.0F};  ///< in pixels; 0: what is there. From 160×120 design pixels on
};

/// Curves over two logarithmic axes, named at their ends; marker and dash tell them apart without colour, too. The
/// pointer shows the nearest point's values. Returns the index of its curve, else −1.
int LogChart(const char* id, std::span<const ChartCurve> curves, const LogChartStyle& style);

/// The same into a rectangle of any draw list, for export; `pointer` may be null.
int DrawLogChart(ImDrawList* draw, ImVec2 min, ImVec2 max, std::span<const ChartCurve> curves,
                 const LogChartStyle& style, const ImVec2* pointer = nullptr);

// ---- steps -----------------------------------------------------------------------------------------

/// Going through steps by itself; kept between frames.
struct StepPlayer {
    bool playing = false;
    float steps_per_s = 4.0F;
    double carry_steps = 0.0;  ///< the part of a step that has gone by
    bool shown = false;        ///< its bar was drawn; set by the bar
};

/// A step of 0…count, or −1 for all of them, also when their count grows: buttons to the ends and to the neighbours,
/// play and pause, a slider (drag; wheel and buttons step by one; Ctrl-click types), and the speed. Disabled without
/// steps. True when `step` changed.
bool StepBar(const char* id, int& step, int count, StepPlayer& player, double dt_s);

/// For bars of one's own: while it plays, a frame of `dt_s` later. It stops at the end, and from there starts again.
void PlaySteps(int& step, int count, StepPlayer& player, double dt_s);

/// Once a frame, at its end: playing ends where no bar was there to stop it.
void StopUnlessShown(StepPlayer& player);

}  // namespace widgets
