// A BSP tree as its diagram wants it, the way from polygons back to nodes, and what is told of a node. Read
// tree_view.cpp for its use.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "frame/hidden/hidden_surfaces.h"
#include "widgets/diagrams.h"

namespace viewing {

class TreeIndex {
public:
    TreeIndex() = default;
    TreeIndex(const TreeIndex&) = delete;  // the labels are looked at, not held, by the nodes
    TreeIndex& operator=(const TreeIndex&) = delete;
    TreeIndex(TreeIndex&&) = default;
    TreeIndex& operator=(TreeIndex&&) = default;

    /// Follows a result: its tree, its walk, and how far its step has come. A result without a tree changes nothing.
    void follow(const std::shared_ptr<const HiddenResult>& result);
    /// Counts the trees that were followed.
    std::uint64_t revision() const { return revision_; }

    const std::vector<widgets::TreeNode>& nodes() const { return nodes_; }
    int node_of(int fragment) const;  ///< −1 where there is no such fragment
    /// Of the walk, also where the step has not come yet: 1 in front, −1 behind, 0 in the plane or not known.
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

/// "30 nodes, 7 deep, 34 fragments, 4 splits; splitter: fewest splits", and how far the step has come.
std::string tree_sentence(const HiddenResult& result);

/// What a node's plane is and does, and once the walk has reached it what the eye's side means for the order. Nodes are
/// counted from 1, as the steps of the build are. Empty where there is no such node at this step.
std::string node_sentence(const HiddenResult& result, int node, const TreeIndex& index);

}  // namespace viewing
