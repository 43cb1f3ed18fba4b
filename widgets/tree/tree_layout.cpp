// Positions of a tree diagram's nodes. Subtrees are placed from the leaves up, each as close to its neighbor as the
// facing contours allow. A thread continues the contour of a shorter subtree into a longer one, so that following all
// contours takes linear time. Source: Reingold and Tilford 1981.
#include <algorithm>

#include "widgets/tree/tree_inner.h"

namespace widgets {

namespace inner {

TreeChildren ChildrenOf(std::span<const TreeNode> nodes, int parent) {
    const TreeNode& node = nodes[parent];
    const auto checked = [&](int child) {
        const bool is_child = child > parent && child < std::ssize(nodes) && nodes[child].parent == parent;
        return is_child ? child : -1;
    };
    return {checked(node.front), node.back == node.front ? -1 : checked(node.back)};
}

}  // namespace inner

namespace {

using Children = inner::TreeChildren;
using inner::ChildrenOf;

/// Computes the horizontal offsets of children from their parents, in node widths.
class Placer {
public:
    explicit Placer(std::size_t count) : nodes_(count) {}

    /// Call for children before their parents.
    void Place(int parent, const Children& children) {
        Node& node = At(parent);
        node.children = children;
        node.ends[left] = node.ends[right] = {parent, 0.0};
        if (children.front >= 0 && children.back >= 0) {
            Join(node);
        } else if (const int only = std::max(children.front, children.back); only >= 0) {
            At(only).offset = children.front >= 0 ? -0.5 : 0.5;
            for (const Side side : {left, right}) node.ends[side] = Moved(At(only).ends[side], At(only).offset);
        }
    }
    double OffsetFromParent(int node) const { return nodes_[node].offset; }

private:
    enum Side { left, right };
    /// A node and its offset from another one.
    struct Reached {
        int node = -1;
        double dx = 0.0;
    };
    struct Node {
        Children children;
        double offset = 0.0;  ///< from its parent
        Reached thread;       ///< where the contour continues below this leaf
        Reached ends[2];      ///< the outermost nodes of the subtree's deepest level
    };

    Node& At(int node) { return nodes_[node]; }
    static Reached Moved(Reached place, double dx) { return {place.node, place.dx + dx}; }

    /// Returns the next node down a subtree's contour.
    Reached Below(const Reached& place, Side side) {
        const Node& node = At(place.node);
        const int near = side == left ? node.children.front : node.children.back;
        const int far = side == left ? node.children.back : node.children.front;
        const int child = near >= 0 ? near : far;
        return Moved(child >= 0 ? Reached{child, At(child).offset} : node.thread, place.dx);
    }

    void Join(Node& parent) {
        Node &front = At(parent.children.front), &back = At(parent.children.back);
        Reached of_front{parent.children.front, 0.0}, of_back{parent.children.back, 0.0};
        double separation = 0.0;
        while (of_front.node >= 0 && of_back.node >= 0) {
            separation = std::max(separation, of_front.dx - of_back.dx + 1.0);
            of_front = Below(of_front, right);
            of_back = Below(of_back, left);
        }
        front.offset = -0.5 * separation;
        back.offset = 0.5 * separation;
        const Reached front_ends[] = {Moved(front.ends[left], front.offset), Moved(front.ends[right], front.offset)};
        const Reached back_ends[] = {Moved(back.ends[left], back.offset), Moved(back.ends[right], back.offset)};

        parent.ends[left] = of_back.node >= 0 ? back_ends[left] : front_ends[left];
        parent.ends[right] = of_front.node >= 0 ? front_ends[right] : back_ends[right];
        if (of_front.node >= 0) Continue(back_ends[right], Moved(of_front, front.offset));
        if (of_back.node >= 0) Continue(front_ends[left], Moved(of_back, back.offset));
    }
    void Continue(const Reached& end, const Reached& below) { At(end.node).thread = Moved(below, -end.dx); }

    std::vector<Node> nodes_;
};

std::vector<int> SubtreeSizes(std::span<const TreeNode> nodes) {
    std::vector<int> sizes(nodes.size(), 1);
    for (int i = static_cast<int>(nodes.size()) - 1; i >= 0; --i) {
        const Children children = ChildrenOf(nodes, i);
        for (const int child : {children.front, children.back}) {
            if (child >= 0) sizes[i] += sizes[child];
        }
    }
    return sizes;
}

}  // namespace

std::span<const int> TreeLayout::Level(int index) const {
    const auto begin = static_cast<std::size_t>(level_begin[index]);
    const auto end = static_cast<std::size_t>(level_begin[static_cast<std::size_t>(index) + 1]);
    return std::span(order).subspan(begin, end - begin);
}

TreeLayout LayOutTree(std::span<const TreeNode> nodes, const std::unordered_set<int>& collapsed) {
    TreeLayout layout;
    layout.x.assign(nodes.size(), 0.0);
    layout.level.assign(nodes.size(), -1);
    layout.subtree_size = SubtreeSizes(nodes);
    if (nodes.empty()) {
        layout.level_begin = {0};
        return layout;
    }
    const auto shown_children = [&](int node) {
        return collapsed.contains(node) ? Children{} : ChildrenOf(nodes, node);
    };
    const auto at = [](auto& values, int node) -> auto& {
        return values[node];
    };

    layout.order.push_back(0);
    layout.level[0] = 0;
    for (std::size_t i = 0; i < layout.order.size(); ++i) {
        const int node = layout.order[i], level = at(layout.level, node);
        if (level == std::ssize(layout.level_begin)) layout.level_begin.push_back(static_cast<int>(i));
        const Children children = shown_children(node);
        for (const int child : {children.front, children.back}) {
            if (child < 0) continue;
            at(layout.level, child) = level + 1;
            layout.order.push_back(child);
        }
    }
    layout.level_begin.push_back(static_cast<int>(layout.order.size()));

    Placer placer(nodes.size());
    for (auto node = layout.order.rbegin(); node != layout.order.rend(); ++node) {
        placer.Place(*node, shown_children(*node));
    }
    for (const int node : layout.order) {
        if (node > 0) at(layout.x, node) = at(layout.x, at(nodes, node).parent) + placer.OffsetFromParent(node);
        layout.min_x = std::min(layout.min_x, at(layout.x, node));
        layout.max_x = std::max(layout.max_x, at(layout.x, node));
    }
    return layout;
}

}  // namespace widgets
