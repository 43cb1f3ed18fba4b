// Builds the tree, node by node in depth-first order, front sides first. Read bsp_walk.cpp next.
#include <algorithm>
#include <cstdlib>
#include <random>
#include <utility>

#include "text/catalogue.h"
#include "topics/hidden/methods/bsp.h"

namespace viewing {
namespace {

/// The maximum number of planes tried per node, and the maximum number of polygons on which each plane is tried. Both
/// limit how long a choice takes.
constexpr std::size_t max_candidates = 12, max_tried_on = 192;

struct Children {
    std::vector<int> front, back;
};

/// Polygons that wait to become a subtree.
struct Rest {
    std::vector<int> polygons;  ///< indices into the pool
    int parent;
    bool is_front;
};

class Builder {
public:
    Builder(std::span<const Polygon> polygons, const BspOptions& options)
        : options_(options), random_(options.random_seed), pool_(polygons.begin(), polygons.end()) {
        tree_.epsilon = options.epsilon.value_or(default_epsilon(polygons));
    }

    BspTree build(WorkProgress* progress) {
        std::vector<int> all(pool_.size());
        for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<int>(i);
        if (!all.empty()) rests_.push_back({std::move(all), -1, false});
        while (!rests_.empty()) {
            if (is_canceled(progress)) tree_.problem = message("The BSP tree is not finished: it was canceled.");
            grow();
            report(progress, static_cast<double>(tree_.fragments.size()) / live_count());
        }
        return std::move(tree_);
    }

private:
    /// Returns the number of polygons and pieces so far, in the tree or still waiting. The pool has exactly this size,
    /// because one of the two pieces takes the place of the polygon that was cut.
    int live_count() const { return static_cast<int>(pool_.size()); }

    void grow() {
        Rest rest = std::move(rests_.back());
        rests_.pop_back();
        BspNode node;
        node.parent = rest.parent;
        node.depth = rest.parent < 0 ? 1 : tree_.nodes[rest.parent].depth + 1;
        node.input_count = static_cast<int>(rest.polygons.size());
        node.sorted = tree_.problem.empty();
        const int splitter = node.sorted ? choose(rest.polygons, node) : rest.polygons.front();
        node.plane = pool_[splitter].plane;
        node.splitter_source = pool_[splitter].source;

        Children children;
        std::vector<int> own = node.sorted ? divide(rest.polygons, splitter, node, children) : std::move(rest.polygons);
        keep(own, node);
        tree_.counters.depth = std::max(tree_.counters.depth, node.depth);
        const int index = static_cast<int>(tree_.nodes.size());
        tree_.nodes.push_back(node);
        if (rest.parent >= 0) {
            (rest.is_front ? tree_.nodes[rest.parent].front : tree_.nodes[rest.parent].back) = index;
        }
        if (!children.back.empty()) rests_.push_back({std::move(children.back), index, false});
        if (!children.front.empty()) rests_.push_back({std::move(children.front), index, true});
    }

    /// Returns the polygon whose plane will divide the list.
    int choose(const std::vector<int>& list, BspNode& node) {
        node.candidate_count = 1;
        if (options_.splitter == BspSplitter::first) return list.front();
        if (options_.splitter == BspSplitter::random) return list[random_() % list.size()];
        const std::size_t candidates = std::min(list.size(), max_candidates);
        node.candidate_count = static_cast<int>(candidates);
        int best = list.front();
        std::pair best_cost(list.size() + 1, list.size() + 1);
        for (std::size_t i = 0; i < candidates && list.size() > 1; ++i) {
            const int candidate = list[i * list.size() / candidates];
            const auto cost = cost_of(candidate, list);
            if (cost < best_cost) {
                best_cost = cost;
                best = candidate;
            }
        }
        return best;
    }

    /// Returns the cost to minimize and a tie-breaker.
    std::pair<std::size_t, std::size_t> cost_of(int candidate, const std::vector<int>& list) {
        const std::size_t tried_on = std::min(list.size(), max_tried_on);
        std::size_t front = 0, back = 0, spanning = 0;
        for (std::size_t i = 0; i < tried_on; ++i) {
            const PlaneSide side = side_as_to(candidate, list[i * list.size() / tried_on]);
            front += side == PlaneSide::front;
            back += side == PlaneSide::back;
            spanning += side == PlaneSide::spanning;
        }
        const std::size_t larger_child = std::max(front, back) + spanning;
        return options_.splitter == BspSplitter::fewest_splits ? std::pair(spanning, larger_child)
                                                               : std::pair(larger_child, spanning);
    }

    /// Returns which side of the splitter's plane a polygon is on. A polygon always counts as lying in its own plane,
    /// even if rounding moves it out.
    PlaneSide side_as_to(int splitter, int polygon) {
        if (splitter == polygon) return PlaneSide::coplanar;
        ++tree_.counters.plane_tests;
        return side_of_plane(pool_[polygon], pool_[splitter].plane, tree_.epsilon);
    }

    /// Sends every polygon to its side, cutting it if needed; returns the polygons in the plane.
    std::vector<int> divide(const std::vector<int>& list, int splitter, BspNode& node, Children& children) {
        std::vector<int> own;
        for (const int polygon : list) {
            switch (side_as_to(splitter, polygon)) {
                case PlaneSide::coplanar:
                    own.push_back(polygon);
                    break;
                case PlaneSide::front:
                    children.front.push_back(polygon);
                    break;
                case PlaneSide::back:
                    children.back.push_back(polygon);
                    break;
                case PlaneSide::spanning: {
                    auto [front, back] = split(pool_[polygon], node.plane, tree_.epsilon);
                    pool_[polygon] = std::move(front);
                    children.front.push_back(polygon);
                    children.back.push_back(static_cast<int>(pool_.size()));
                    pool_.push_back(std::move(back));
                    ++node.split_count;
                    break;
                }
            }
        }
        node.front_count = static_cast<int>(children.front.size());
        node.back_count = static_cast<int>(children.back.size());
        tree_.counters.splits += node.split_count;
        if (live_count() > options_.max_fragments && tree_.problem.empty()) {
            tree_.problem =
                message("The BSP tree stopped at its budget of {count} fragments; the rest is drawn unsorted.",
                        "count"_a = options_.max_fragments);
        }
        return own;
    }

    void keep(std::vector<int>& own, BspNode& node) {
        std::stable_sort(own.begin(), own.end(), [&](int a, int b) { return pool_[a].source > pool_[b].source; });
        node.first_fragment = static_cast<int>(tree_.fragments.size());
        node.fragment_count = static_cast<int>(own.size());
        for (const int polygon : own) tree_.fragments.push_back(std::move(pool_[polygon]));
    }

    const BspOptions& options_;
    std::mt19937 random_;
    std::vector<Polygon> pool_;
    std::vector<Rest> rests_;
    BspTree tree_;
};

}  // namespace

BspTree build_bsp(std::span<const Polygon> polygons, const BspOptions& options, WorkProgress* progress) {
    return Builder(polygons, options).build(progress);
}

}  // namespace viewing
