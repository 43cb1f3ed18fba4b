// A box tree over a mesh's vertices or triangles: each run of neighbors has a box, eight boxes share a larger one, and
// so on up to the whole mesh. A query on a large mesh skips most of the tree. A tree is built once per mesh and kept as
// long as the mesh exists. Read object_reach.h next, which queries it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <queue>
#include <vector>

#include "geometry/mesh.h"

namespace viewing {

class BoxTree {
public:
    /// Builds a tree over the vertices, by index; all boxes are in model space.
    static BoxTree of_vertices(const Mesh& mesh);
    /// Builds a tree over the triangles, by index.
    static BoxTree of_triangles(const Mesh& mesh);

    /// Returns the box of all items.
    Bounds bounds() const { return levels_.empty() ? Bounds{} : levels_.back().front(); }

    /// Returns whether is_so(item) holds for any item in boxes that pass may_hold(box); stops at the first such item.
    template <typename MayHold, typename IsSo>
    bool any(MayHold may_hold, IsSo is_so) const {
        return !levels_.empty() && any_below(levels_.size() - 1, 0, may_hold, is_so);
    }

    /// Visits every item in boxes that pass may_hold(box).
    template <typename MayHold, typename Visit>
    void each(MayHold may_hold, Visit visit) const {
        any(may_hold, [&](std::uint32_t item) {
            visit(item);
            return false;
        });
    }

    /// Visits items, always continuing with the box that has the smallest `key`. Skips boxes whose key is at least
    /// limit(), which may shrink with each visit.
    template <typename Key, typename Limit, typename Visit>
    void least_first(Key key, Limit limit, Visit visit) const;

private:
    static constexpr std::size_t run_length = 16, fan = 8;

    template <typename BoundsOf>
    static BoxTree made(std::size_t count, const Bounds& whole, BoundsOf bounds_of_item);

    /// Visits the indices of the boxes below a box or, at level 0, the indices of a run's items.
    template <typename Each>
    void each_below(std::size_t level, std::size_t index, Each each) const {
        const std::size_t length = level == 0 ? run_length : fan;
        const std::size_t count = level == 0 ? items_.size() : levels_[level - 1].size();
        for (std::size_t i = index * length; i < std::min((index + 1) * length, count); ++i) each(i);
    }

    template <typename MayHold, typename IsSo>
    bool any_below(std::size_t level, std::size_t index, MayHold& may_hold, IsSo& is_so) const {
        if (!may_hold(levels_[level][index])) return false;
        bool found = false;
        each_below(level, index, [&](std::size_t i) {
            if (!found) found = level == 0 ? is_so(items_[i]) : any_below(level - 1, i, may_hold, is_so);
        });
        return found;
    }

    std::vector<std::uint32_t> items_;         ///< each item once, sorted along a space-filling curve
    std::vector<std::vector<Bounds>> levels_;  ///< boxes of runs, then of `fan` such boxes, …; the last level has one
};

template <typename Key, typename Limit, typename Visit>
void BoxTree::least_first(Key key, Limit limit, Visit visit) const {
    struct Waiting {
        double key;
        std::size_t level, index;
        bool operator<(const Waiting& other) const { return key > other.key; }
    };
    std::priority_queue<Waiting> waiting;
    const auto add = [&](std::size_t level, std::size_t index) {
        if (const double found = key(levels_[level][index]); found < limit()) waiting.push({found, level, index});
    };
    if (!levels_.empty()) add(levels_.size() - 1, 0);
    while (!waiting.empty()) {
        const Waiting next = waiting.top();
        if (next.key >= limit()) return;
        waiting.pop();
        each_below(next.level, next.index, [&](std::size_t i) {
            if (next.level == 0)
                visit(items_[i]);
            else
                add(next.level - 1, i);
        });
    }
}

/// Return a mesh's trees, built on first use. Safe to call from several threads.
std::shared_ptr<const BoxTree> vertex_tree(const std::shared_ptr<const Mesh>& mesh);
std::shared_ptr<const BoxTree> triangle_tree(const std::shared_ptr<const Mesh>& mesh);

}  // namespace viewing
