// Diagrams of how a method works: its tree, its cost as the scene grows, and a bar to step through it. As in widgets.h,
// every widget edits the value it is given and returns whether it did. See show_diagrams_demo.cpp for usage.
#pragma once

#include <glm/glm.hpp>
#include <unordered_set>

#include "widgets/widgets.h"

namespace widgets {

// ---- a binary tree ---------------------------------------------------------------------------------

/// A node of a tree in a flat array: the root first, children after their parent. A link counts only if the child names
/// this node as its parent, so any input forms a tree. Nodes that the root does not reach are hidden.
struct TreeNode {
    int parent = -1, front = -1, back = -1;  ///< indices; −1: none
    std::string_view label = {};             ///< short: a number
    int mark = -1;                           ///< its number in a traversal, drawn beside it; −1: not visited
    ImU32 color = 0;                         ///< chosen by meaning; 0: neutral
    int eye_side = 0;                        ///< 1: eye in front, −1: behind, 0: neither; highlights that side's edge
};

/// The positions of a tree's nodes: one row per level, front before back, at least 1 apart in a row, with each parent
/// centered above its children. They are computed in linear time, without recursion. Source: Reingold and Tilford 1981.
struct TreeLayout {
    std::vector<double> x;          ///< of each node, in node widths from the root; undefined if level < 0
    std::vector<int> level;         ///< of each node, 0 at the root; −1: hidden
    std::vector<int> order;         ///< visible nodes, level by level, each level from left to right
    std::vector<int> level_begin;   ///< start of each level in `order`; one extra entry at the end
    std::vector<int> subtree_size;  ///< of each node, including itself, folded or not
    double min_x = 0.0, max_x = 0.0;

    int LevelCount() const { return static_cast<int>(level_begin.size()) - 1; }
    std::span<const int> Level(int index) const;
};
/// Computes the layout, without the subtrees of nodes in `collapsed`.
TreeLayout LayOutTree(std::span<const TreeNode> nodes, const std::unordered_set<int>& collapsed = {});

/// State of a tree diagram between frames. The caller may change everything above `layout`.
struct TreeDiagramState {
    glm::dvec2 pan{0.0};  ///< from the view's upper left corner to the root, in design pixels
    double zoom = 1.0;
    double stretch = 1.0;  ///< horizontal scale: in front of an audience, a fitted tree fills the view's width
    std::unordered_set<int> collapsed;  ///< nodes with folded subtrees
    bool fit_next = true;               ///< show the whole tree in the next frame, or only its top if it is too large
    bool fit_whole_next = false;        ///< show the whole tree in the next frame, however small
    int reveal_next = -1;               ///< in the next frame, unfold, zoom and move only as needed to show this node
    int hovered = -1;                   ///< output: the node under the pointer

    TreeLayout layout;  ///< the layout for `laid_out_revision` and `laid_out_collapsed`
    std::uint64_t laid_out_revision = 0;
    std::unordered_set<int> laid_out_collapsed;
    bool is_laid_out = false;
    bool fold_next = false;
    float drag_distance_px = 0.0F;
    glm::dvec2 pan_pressed{0.0};  ///< at the start of a drag
    int pressed = -1;             ///< the node under the last press
    bool pressed_triangle = false;
};

struct TreeDiagramStyle {
    int shown_count = 1 << 30;  ///< draws only this many nodes, those built so far
    int current = -1;           ///< the visited node, or the folded one that hides it; drawn filled
    int lit = -1;               ///< the node pointed at in another view, or the folded one that hides it
    ImVec2 size{0.0F, 0.0F};    ///< in pixels; 0: the available size
};

/// Draws a tree that the user can pan (drag), zoom (wheel), fold (double-click, or the triangle below a node; a large
/// fold opens a few levels at a time) and select from (click; a click on the background selects nothing). Apart from
/// that, it stays still: its layout depends only on folds and on `revision`, which must change when the nodes' links
/// do. A new revision unfolds as many levels as are readable together, folds the rest and fits the view. The edge to
/// the front child is marked +, the one to the back child −. Returns true when `selected` (−1: none) changed.
bool TreeDiagram(const char* id, std::span<const TreeNode> nodes, std::uint64_t revision, TreeDiagramState& state,
                 int& selected, const TreeDiagramStyle& style = {});

// ---- curves on logarithmic axes --------------------------------------------------------------------

struct ChartCurve {
    const char* name;
    ImU32 color;
    std::span<const glm::dvec2> points;  ///< from left to right; a point that is not finite and positive leaves a gap
    bool emphasized = false;
};

/// Without a valid range (0 < min < max), an axis spans the whole decades that contain its values.
struct ChartAxis {
    const char* title = "";  ///< including the unit
    double min = 0.0, max = 0.0;
};

struct LogChartStyle {
    ChartAxis x, y;
    double marker_x = 0.0;  ///< draws a vertical line here; ≤ 0: none
    const char* marker_label = "";
    ImVec2 size{0.0F, 0.0F};  ///< in pixels; 0: the available size. At least 160×120 design pixels
};

/// Draws curves over two logarithmic axes, with their names at their ends. The curves differ in marker and dash as well
/// as in color. The readout shows the values of the point nearest to the pointer. Returns the index of that point's
/// curve, otherwise −1.
int LogChart(const char* id, std::span<const ChartCurve> curves, const LogChartStyle& style);

/// Draws the chart of LogChart in a rectangle of any draw list, for export. `pointer` may be null.
int DrawLogChart(ImDrawList* draw, ImVec2 min, ImVec2 max, std::span<const ChartCurve> curves,
                 const LogChartStyle& style, const ImVec2* pointer = nullptr);

// ---- steps -----------------------------------------------------------------------------------------

/// Automatic stepping; persists between frames.
struct StepPlayer {
    bool playing = false;
    float steps_per_s = 4.0F;
    double carry_steps = 0.0;  ///< fraction of the next step that has elapsed
    bool shown = false;        ///< the bar sets this when it is drawn
};

/// Draws a bar that sets `step` to 0…count, or to −1, which means all steps even if the count grows. It has buttons
/// that jump to either end, move by one step, and play or pause; a slider (drag; the wheel moves by one step;
/// Ctrl-click to type); and the speed. Disabled without steps. Returns true when `step` changed.
bool StepBar(const char* id, int& step, int count, StepPlayer& player, double dt_s);

/// For custom bars: advances by `dt_s` while playing. Stops at the end; playing again starts over.
void PlaySteps(int& step, int count, StepPlayer& player, double dt_s);

/// Call at the end of each frame: stops playback if no bar was drawn, since the user would have no way to stop it.
void StopUnlessShown(StepPlayer& player);

}  // namespace widgets
