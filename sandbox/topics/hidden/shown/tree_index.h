// A BSP tree in the form that its diagram needs, a map from polygons back to nodes, and sentences about the tree and
// its nodes. See tree_view.cpp for usage.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "topics/hidden/numbers/hidden_surfaces.h"
#include "widgets/diagrams.h"

namespace viewing {

class TreeIndex {
public:
    TreeIndex() = default;
    TreeIndex(const TreeIndex&) = delete;  // the nodes point into the labels
    TreeIndex& operator=(const TreeIndex&) = delete;
    TreeIndex(TreeIndex&&) = default;
    TreeIndex& operator=(TreeIndex&&) = default;

    /// Updates the index to match a result's tree, its traversal, and the progress of its step. Ignores a result
    /// without a tree.
    void follow(const std::shared_ptr<const HiddenResult>& result);
    /// How many trees the index has followed so far.
    std::uint64_t revision() const { return revision_; }

    const std::vector<widgets::TreeNode>& nodes() const { return nodes_; }
    int node_of(int fragment) const;  ///< −1 if there is no such fragment
    /// The side of the node's plane on which the eye is, even if the traversal has not reached the node yet: 1 in
    /// front, −1 behind, 0 in the plane or unknown.
    int eye_side_of(int node) const;

private:
    void take_tree(const BspTree& tree, const SceneSurface* surface);
    void take_walk(const HiddenResult& result);

    std::shared_ptr<const HiddenResult> followed_;
    std::uint64_t revision_ = 0;
    std::vector<widgets::TreeNode> nodes_;
    std::vector<char> labels_;
    std::vector<int> node_of_fragment_;
    std::vector<signed char> eye_sides_;
};

/// Returns the node that the step builds or visits; −1 if there is none, or if all steps are shown.
int current_node(const HiddenResult& result);

/// Describes the tree: "30 nodes, depth 7, 34 fragments, 4 splits; splitter: fewest splits". If a step is shown, adds
/// its progress.
std::string tree_sentence(const HiddenResult& result);

/// Describes a node's plane and, once the traversal has reached it, how the eye's side of the plane decides the order.
/// Numbers nodes from 1, like the steps that build the tree. Empty if there is no such node at this step.
std::string node_sentence(const HiddenResult& result, int node, const TreeIndex& index);

}  // namespace viewing
