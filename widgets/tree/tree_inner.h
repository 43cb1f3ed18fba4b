// Shared by the tree diagram's interaction (tree_diagram.cpp) and drawing (tree_drawing.cpp): the nodes' positions on
// the screen.
#pragma once

#include "widgets/diagrams.h"

namespace widgets::inner {

/// Maps layout positions to the screen. Lengths are in pixels.
struct TreeCamera {
    static constexpr double pitch = 48.0, row = 42.0;  ///< between nodes and between levels, in design pixels at zoom 1
    static constexpr double readable_zoom = 0.42;      ///< at this zoom or above, labels fit into nodes
    static constexpr double comfortable_zoom = 0.75;   ///< the zoom for trees that do not fit as a whole

    ImVec2 min, max;  ///< the view
    double unit;      ///< pixels per design pixel
    double zoom, stretch;
    glm::dvec2 pan;

    TreeCamera(ImVec2 view_min, ImVec2 view_max, const TreeDiagramState& state);
    ImVec2 At(double x, int level) const;
    ImVec2 At(const TreeLayout& layout, int node) const;
    double LayoutX(float x) const { return ((x - min.x) / unit - pan.x) / (pitch * stretch * zoom); }
    double LayoutLevel(float y) const { return ((y - min.y) / unit - pan.y) / (row * zoom); }
    float Pitch() const { return static_cast<float>(pitch * stretch * zoom * unit); }
    /// Returns half the size of a node's box. The box stops growing when its text does.
    ImVec2 HalfBox() const;
    /// Returns the radius of the triangle below a node, which folds the node.
    float TriangleRadius() const { return static_cast<float>(6.5 * unit); }
    ImVec2 TriangleCenter(ImVec2 node) const { return ImVec2(node.x, node.y + HalfBox().y + TriangleRadius()); }
    /// Whether the traversal numbers fit beside the boxes.
    bool HasRoomBeside() const { return stretch > 1.0; }
    bool ShowsText() const { return zoom >= readable_zoom; }
};

/// Centers the whole tree. If that would be unreadable and `whole` is false, shows the top, with the root as close to
/// the middle as the tree's own edges allow.
void Fit(const TreeCamera& camera, TreeDiagramState& state, bool whole);
/// If the tree is too wide to read, folds it at the deepest level that still fits. Returns whether it did so.
bool FoldWide(const TreeCamera& camera, std::span<const TreeNode> nodes, TreeDiagramState& state);
/// Keeps part of the tree in the view.
void KeepInView(const TreeCamera& camera, TreeDiagramState& state);
void ZoomAbout(const TreeCamera& camera, ImVec2 pointer, double factor, TreeDiagramState& state);
/// Moves the view as little as needed to show a node. If labels are too small to read, zooms in first.
void MoveIntoView(const TreeCamera& camera, int node, TreeDiagramState& state);

struct TreeChildren {
    int front = -1, back = -1;
};
/// Returns the valid links of `parent`: those to later nodes that name it as their parent.
TreeChildren ChildrenOf(std::span<const TreeNode> nodes, int parent);

/// Returns whether the node's subtree, as built so far, has anything to fold.
bool HasShownChild(std::span<const TreeNode> nodes, int node, int shown_count);

void DrawTree(ImDrawList* draw, const TreeCamera& camera, std::span<const TreeNode> nodes,
              const TreeDiagramState& state, int selected, const TreeDiagramStyle& style);

}  // namespace widgets::inner
