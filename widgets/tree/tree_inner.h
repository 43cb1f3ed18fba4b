// What the tree diagram's hands (tree_diagram.cpp) and its picture (tree_drawing.cpp) share: where a node is on screen.
#pragma once

#include "widgets/diagrams.h"

namespace widgets::inner {

/// From a layout's places to the screen. Lengths are in pixels.
struct TreeCamera {
    static constexpr double pitch = 48.0, row = 42.0;  ///< between nodes and between levels, in design pixels at zoom 1
    static constexpr double readable_zoom = 0.42;      ///< from here on a node has room for its label
    static constexpr double comfortable_zoom = 0.75;   ///< of what does not fit as a whole

    ImVec2 min, max;  ///< the view
    double unit;      ///< pixels for a design pixel
    double zoom;
    glm::dvec2 pan;

    TreeCamera(ImVec2 view_min, ImVec2 view_max, const TreeDiagramState& state);
    ImVec2 At(double x, int level) const;
    ImVec2 At(const TreeLayout& layout, int node) const;
    double LayoutX(float x) const { return ((x - min.x) / unit - pan.x) / (pitch * zoom); }
    double LayoutLevel(float y) const { return ((y - min.y) / unit - pan.y) / (row * zoom); }
    float Pitch() const { return static_cast<float>(pitch * zoom * unit); }
    /// Half a node's box; it stops growing where its text does.
    ImVec2 HalfBox() const;
    /// Below a node: what folds it.
    float TriangleRadius() const { return static_cast<float>(6.5 * unit); }
    ImVec2 TriangleCenter(ImVec2 node) const { return ImVec2(node.x, node.y + HalfBox().y + TriangleRadius()); }
    bool ShowsText() const { return zoom >= readable_zoom; }
};

/// The whole tree, in the middle. Where it would become unreadable, unless it is to be whole, its top, with the root as
/// near the middle as the tree's own edges allow.
void Fit(const TreeCamera& camera, TreeDiagramState& state, bool whole);
/// Folds a tree too wide to be read whole at the deepest level for which the rest is not; whether it had to.
bool FoldWide(const TreeCamera& camera, std::span<const TreeNode> nodes, TreeDiagramState& state);
/// Some of the tree always stays in the view.
void KeepInView(const TreeCamera& camera, TreeDiagramState& state);
void ZoomAbout(const TreeCamera& camera, ImVec2 pointer, double factor, TreeDiagramState& state);
/// By as little as it takes.
void MoveIntoView(const TreeCamera& camera, int node, TreeDiagramState& state);

struct TreeChildren {
    int front = -1, back = -1;
};
/// The links of `parent` that make a tree: to later nodes that name it.
TreeChildren ChildrenOf(std::span<const TreeNode> nodes, int parent);

/// Whether the subtree below a node has something to fold, as far as it is built.
bool HasShownChild(std::span<const TreeNode> nodes, int node, int shown_count);

void DrawTree(ImDrawList* draw, const TreeCamera& camera, std::span<const TreeNode> nodes,
              const TreeDiagramState& state, int selected, const TreeDiagramStyle& style);

}  // namespace widgets::inner
