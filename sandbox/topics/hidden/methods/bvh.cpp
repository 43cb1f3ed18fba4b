// Builds the hierarchy top down, cutting where the cost, estimated with bins, is lowest. Read bvh_rays.cpp next.
#include "topics/hidden/methods/bvh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace viewing {
namespace {

constexpr int most_bins = 16;
constexpr int largest_leaf = 4;
constexpr float box_cost = 1.0F, triangle_cost = 1.5F;

/// Three coordinates in the nodes' units; the fourth is 0.
using Point __attribute__((vector_size(16))) = float;

Point least_of(const Point& a, const Point& b) {
    return a < b ? a : b;
}
Point greatest_of(const Point& a, const Point& b) {
    return a > b ? a : b;
}

struct Box {
    Point least{2.0F, 2.0F, 2.0F, 0.0F}, greatest{-2.0F, -2.0F, -2.0F, 0.0F};

    void add(const Box& other) {
        least = least_of(least, other.least);
        greatest = greatest_of(greatest, other.greatest);
    }
    void add(const Point& point) { add(Box{point, point}); }
    float half_surface() const {
        const Point size = greatest - least;
        return size[0] < 0.0F ? 0.0F : size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
    }
};

struct Bin {
    Box box;
    int count = 0;
};

/// A triangle to add to the tree.
struct Item {
    Box box;
    int triangle = 0;

    Point twice_center() const { return box.least + box.greatest; }
};

struct Cut {
    float cost = std::numeric_limits<float>::infinity();  ///< area times count, summed over both sides
    int axis = -1, last_bin = 0;                          ///< the last bin of the left side
};

/// Bins along each axis. A cut never separates items in the same bin; a small number of items needs only a few bins.
struct Bins {
    Bins(std::size_t item_count, const Box& twice_centers)
        : count(static_cast<int>(std::min<std::size_t>(most_bins, 4 + item_count / 20))), first(twice_centers.least) {
        const Point size = twice_centers.greatest - twice_centers.least;
        for (int axis = 0; axis < 3; ++axis)
            per_unit[axis] = size[axis] > 0.0F ? static_cast<float>(count) / size[axis] : 0.0F;
    }
    int of(const Point& twice_center, int axis) const {
        return std::min(static_cast<int>((twice_center[axis] - first[axis]) * per_unit[axis]), count - 1);
    }
    bool has(int axis) const { return per_unit[axis] > 0.0F; }

    int count;
    Point first, per_unit{};
};

/// Replaces `best` with the cheapest cut of a row of bins, if that cut costs less.
void cut_bins(std::span<const Bin> bins, int axis, Cut& best) {
    std::array<float, most_bins> right_cost;
    std::array<int, most_bins> right_count;
    Bin right;
    for (std::size_t i = bins.size() - 1; i > 0; --i) {
        right.box.add(bins[i].box);
        right.count += bins[i].count;
        right_cost[i] = right.box.half_surface() * static_cast<float>(right.count);
        right_count[i] = right.count;
    }
    Bin left;
    for (std::size_t i = 0; i + 1 < bins.size(); ++i) {
        left.box.add(bins[i].box);
        left.count += bins[i].count;
        const float cost = left.box.half_surface() * static_cast<float>(left.count) + right_cost[i + 1];
        if (left.count > 0 && right_count[i + 1] > 0 && cost < best.cost) best = {cost, axis, static_cast<int>(i)};
    }
}

}  // namespace

class Bvh::Build {
public:
    Build(Bvh& bvh, std::span<const Polygon> polygons) : bvh_(bvh) {
        measure_root(bounds_of(polygons));
        for (std::size_t i = 0; i < polygons.size(); ++i) {
            const std::vector<glm::dvec3>& v = polygons[i].vertices;
            for (std::size_t k = 1; k + 1 < v.size(); ++k) {
                Item item{{}, static_cast<int>(triangles_.size())};
                for (const std::size_t corner : {std::size_t{0}, k, k + 1}) item.box.add(in_nodes_units(v[corner]));
                items_.push_back(item);
                triangles_.push_back({v[0], v[k] - v[0], v[k + 1] - v[0], static_cast<int>(i), polygons[i].source});
            }
        }
    }

    void run(WorkProgress* progress) {
        if (items_.empty()) return;
        bvh_.nodes_.reserve(items_.size());
        bvh_.nodes_.emplace_back();
        std::vector<Range> ranges{range_of(items_, 0, 1)};
        std::size_t placed = 0;
        while (!ranges.empty()) {
            const Range range = ranges.back();
            ranges.pop_back();
            const Cut cut = is_canceled(progress) || range.depth >= deepest_bvh ? Cut{} : best_cut(range);
            BvhNode& node = bvh_.nodes_[range.node];
            for (int axis = 0; axis < 3; ++axis) {
                node.corners[0][axis] = range.box.least[axis];
                node.corners[1][axis] = range.box.greatest[axis];
            }
            if (cut.axis < 0) {
                node.first = static_cast<int>(range.items.data() - items_.data());
                node.content = static_cast<int>(range.items.size());
                placed += range.items.size();
                report(progress, static_cast<double>(placed) / static_cast<double>(items_.size()));
                continue;
            }
            const Bins bins(range.items.size(), range.twice_centers);
            const auto middle = std::partition(range.items.begin(), range.items.end(), [&](const Item& item) {
                return bins.of(item.twice_center(), cut.axis) <= cut.last_bin;
            });
            const auto left_count = static_cast<std::size_t>(middle - range.items.begin());
            const int left = static_cast<int>(bvh_.nodes_.size());
            node.first = left;
            node.content = -cut.axis;
            bvh_.nodes_.emplace_back();
            bvh_.nodes_.emplace_back();
            ranges.push_back(range_of(range.items.subspan(left_count), left + 1, range.depth + 1));
            ranges.push_back(range_of(range.items.first(left_count), left, range.depth + 1));
        }
        bvh_.triangles_.reserve(items_.size());
        for (const Item& item : items_) bvh_.triangles_.push_back(triangles_[item.triangle]);
    }

private:
    struct Range {
        std::span<Item> items;
        int node, depth;
        Box box, twice_centers;
    };

    static Range range_of(std::span<Item> items, int node, int depth) {
        Range range{
            items, node, depth, {}, {.least = {4.0F, 4.0F, 4.0F, 0.0F}, .greatest = {-4.0F, -4.0F, -4.0F, 0.0F}}};
        for (const Item& item : items) {
            range.box.add(item.box);
            range.twice_centers.add(item.twice_center());
        }
        return range;
    }

    void measure_root(const Bounds& bounds) {
        if (bounds.empty()) return;
        const double half_diagonal = 0.5 * glm::length(bounds.size());
        bvh_.middle_ = bounds.center();
        bvh_.half_diagonal_ = half_diagonal > 0.0 ? half_diagonal : 1.0;
        bvh_.same_t_ = 2e-11 * half_diagonal;
    }

    Point in_nodes_units(const glm::dvec3& point) const {
        const glm::dvec3 place = (point - bvh_.middle_) * (1.0 / bvh_.half_diagonal_);
        return Point{static_cast<float>(place.x), static_cast<float>(place.y), static_cast<float>(place.z), 0.0F};
    }

    /// Returns the cheapest cut. Its axis is −1 if the range should stay whole because a leaf is cheaper or all centers
    /// are at one point.
    static Cut best_cut(const Range& range) {
        Cut best;
        if (range.items.size() <= 1) return best;
        const Bins bins(range.items.size(), range.twice_centers);
        std::array<std::array<Bin, most_bins>, 3> filled;
        for (auto& row : filled) std::fill_n(row.begin(), bins.count, Bin{});
        for (const Item& item : range.items) {
            const Point twice_center = item.twice_center();
            for (int axis = 0; axis < 3; ++axis) {
                Bin& bin = filled[axis][bins.of(twice_center, axis)];
                bin.box.add(item.box);
                ++bin.count;
            }
        }
        for (int axis = 0; axis < 3; ++axis) {
            if (!bins.has(axis)) continue;
            cut_bins(std::span(filled[axis]).first(static_cast<std::size_t>(bins.count)), axis, best);
        }
        const auto count = static_cast<float>(range.items.size());
        const float surface = range.box.half_surface();
        const bool is_small = range.items.size() <= largest_leaf;
        if (is_small && surface * box_cost * 2.0F + triangle_cost * best.cost >= surface * triangle_cost * count)
            return {};
        return best;
    }

    Bvh& bvh_;
    std::vector<Item> items_;
    std::vector<Triangle> triangles_;
};

Bvh::Bvh(std::span<const Polygon> polygons, WorkProgress* progress) {
    Build(*this, polygons).run(progress);
}

}  // namespace viewing
