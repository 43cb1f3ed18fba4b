// Building the hierarchy from the top by where bins say that a cut is cheapest, and sending rays down it, the nearer
// child first. Read curved.cpp next.
#include "visibility/bvh.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace viewing {
namespace {

constexpr int bin_count = 16;
constexpr int largest_leaf = 4;
constexpr double box_cost = 1.0, triangle_cost = 1.5;
constexpr int deepest = 60;  ///< leaves below are as large as they are: keeps the traversal's stack small

double half_surface(const Bounds& bounds) {
    if (bounds.empty()) return 0.0;
    const glm::dvec3 size = bounds.size();
    return size.x * size.y + size.y * size.z + size.z * size.x;
}

void add(Bounds& bounds, const Bounds& other) {
    bounds.min = glm::min(bounds.min, other.min);
    bounds.max = glm::max(bounds.max, other.max);
}

struct Bin {
    Bounds bounds;
    int count = 0;
};

}  // namespace

class Bvh::Build {
public:
    Build(Bvh& bvh, std::span<const Polygon> polygons) : bvh_(bvh) {
        for (std::size_t i = 0; i < polygons.size(); ++i) {
            const std::vector<glm::dvec3>& v = polygons[i].vertices;
            for (std::size_t k = 1; k + 1 < v.size(); ++k) {
                Item item{{v[0], v[k] - v[0], v[k + 1] - v[0], static_cast<int>(i), polygons[i].source}, {}, {}};
                item.bounds.add(v[0]);
                item.bounds.add(v[k]);
                item.bounds.add(v[k + 1]);
                item.center = item.bounds.center();
                items_.push_back(item);
            }
        }
    }

    void run(WorkProgress* progress) {
        if (items_.empty()) return;
        bvh_.nodes_.reserve(items_.size());
        bvh_.nodes_.emplace_back();
        std::vector<Range> ranges{{0, 0, static_cast<int>(items_.size()), 1}};
        int placed = 0;
        while (!ranges.empty()) {
            const Range range = ranges.back();
            ranges.pop_back();
            const Bounds bounds = bounds_of_items(range);
            const int middle = is_cancelled(progress) || range.depth >= deepest ? range.begin : cut(range, bounds);
            BvhNode& node = bvh_.nodes_[static_cast<std::size_t>(range.node)];
            node.corners = {bounds.min, bounds.max};
            if (middle == range.begin) {
                node.first = range.begin;
                node.triangle_count = range.end - range.begin;
                placed += node.triangle_count;
                report(progress, static_cast<double>(placed) / static_cast<double>(items_.size()));
                continue;
            }
            const int left = static_cast<int>(bvh_.nodes_.size());
            node.first = left;
            bvh_.nodes_.emplace_back();
            bvh_.nodes_.emplace_back();
            ranges.push_back({left + 1, middle, range.end, range.depth + 1});
            ranges.push_back({left, range.begin, middle, range.depth + 1});
        }
        bvh_.triangles_.reserve(items_.size());
        for (const Item& item : items_) bvh_.triangles_.push_back(item.triangle);
    }

private:
    struct Item {
        Triangle triangle;
        Bounds bounds;
        glm::dvec3 center;
    };
    struct Range {
        int node, begin, end, depth;
    };

    std::span<Item> items_of(const Range& range) {
        return std::span(items_).subspan(static_cast<std::size_t>(range.begin),
                                         static_cast<std::size_t>(range.end - range.begin));
    }

    Bounds bounds_of_items(const Range& range) {
        Bounds bounds;
        for (const Item& item : items_of(range)) add(bounds, item.bounds);
        return bounds;
    }

    /// Where the range is best cut in two, its items reordered; its begin when it is best left whole.
    int cut(const Range& range, const Bounds& bounds) {
        const int count = range.end - range.begin;
        if (count <= 1) return range.begin;
        Bounds centers;
        for (const Item& item : items_of(range)) centers.add(item.center);
        double best_cost = half_surface(bounds) * triangle_cost * count;
        if (count > largest_leaf) best_cost = std::numeric_limits<double>::infinity();
        int best_axis = -1, best_bin = 0;
        for (int axis = 0; axis < 3; ++axis) {
            if (!(centers.size()[axis] > 0.0)) continue;
            std::array<Bin, bin_count> bins;
            for (const Item& item : items_of(range)) {
                Bin& bin = bins[static_cast<std::size_t>(bin_of(item, axis, centers))];
                add(bin.bounds, item.bounds);
                ++bin.count;
            }
            const auto [cost, bin] = cheapest_cut(bins);
            const double whole_cost = half_surface(bounds) * box_cost * 2.0 + triangle_cost * cost;
            if (whole_cost < best_cost) {
                best_cost = whole_cost;
                best_axis = axis;
                best_bin = bin;
            }
        }
        if (best_axis < 0) return range.begin;  // cheaper as a leaf, or all centres in one point
        const auto middle = std::partition(items_.begin() + range.begin, items_.begin() + range.end,
                                           [&](const Item& i) { return bin_of(i, best_axis, centers) <= best_bin; });
        return static_cast<int>(middle - items_.begin());
    }

    static int bin_of(const Item& item, int axis, const Bounds& centers) {
        const double share = (item.center[axis] - centers.min[axis]) / (centers.max[axis] - centers.min[axis]);
        return std::clamp(static_cast<int>(share * bin_count), 0, bin_count - 1);
    }

    /// Surface times count of both sides, and the last bin of the left side.
    static std::pair<double, int> cheapest_cut(const std::array<Bin, bin_count>& bins) {
        std::array<double, bin_count> right_cost{};
        Bin right;
        for (std::size_t i = bin_count - 1; i > 0; --i) {
            add(right.bounds, bins[i].bounds);
            right.count += bins[i].count;
            right_cost[i] = half_surface(right.bounds) * right.count;
        }
        std::pair best(std::numeric_limits<double>::infinity(), 0);
        Bin left;
        for (std::size_t i = 0; i + 1 < bin_count; ++i) {
            add(left.bounds, bins[i].bounds);
            left.count += bins[i].count;
            right.count -= bins[i].count;
            const double cost = half_surface(left.bounds) * left.count + right_cost[i + 1];
            if (left.count > 0 && left.count < total(bins) && cost < best.first) {
                best = {cost, static_cast<int>(i)};
            }
        }
        return best;
    }

    static int total(const std::array<Bin, bin_count>& bins) {
        int sum = 0;
        for (const Bin& bin : bins) sum += bin.count;
        return sum;
    }

    Bvh& bvh_;
    std::vector<Item> items_;
};

Bvh::Bvh(std::span<const Polygon> polygons, WorkProgress* progress) {
    Build(*this, polygons).run(progress);
    if (nodes_.empty()) return;
    const double size = glm::length(nodes_[0].corners[1] - nodes_[0].corners[0]);
    same_t_ = 1e-11 * size;
    // Room for rounding: a ray within a flat box's plane still enters it.
    for (BvhNode& node : nodes_) {
        node.corners[0] -= glm::dvec3(1e-10 * size);
        node.corners[1] += glm::dvec3(1e-10 * size);
    }
}

/// Calls visit_leaf for every leaf whose box the ray enters before `max_t`, which the call may lower.
template <typename VisitLeaf>
void Bvh::traverse(const Ray& ray, const double& max_t, RayCounters& counters, VisitLeaf visit_leaf) const {
    if (nodes_.empty()) return;
    glm::dvec3 inverse;
    std::array<std::size_t, 3> near_corner{};  // the one that the ray passes first, by axis
    for (int axis = 0; axis < 3; ++axis) {
        // Large, not infinite: 0 times it is 0 on the face of a box, not NaN.
        const double d = ray.direction[axis];
        inverse[axis] = std::abs(d) > 1e-150 ? 1.0 / d : 1e150;
        near_corner[static_cast<std::size_t>(axis)] = inverse[axis] < 0.0;
    }
    const auto entry = [&](const BvhNode& node) {
        const auto distance = [&](std::size_t axis, std::size_t corner) {
            const int i = static_cast<int>(axis);
            return (node.corners[corner][i] - ray.origin[i]) * inverse[i];
        };
        double enter = 0.0, leave = max_t;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            enter = std::max(enter, distance(axis, near_corner[axis]));
            leave = std::min(leave, distance(axis, 1 - near_corner[axis]));
        }
        return enter <= leave ? enter : std::numeric_limits<double>::infinity();
    };
    struct Waiting {
        double entry;
        int node;
    };
    std::array<Waiting, deepest + 2> stack;
    std::size_t waiting = 0;
    ++counters.box_tests;
    if (const double t = entry(nodes_[0]); t <= max_t) stack[waiting++] = {t, 0};
    while (waiting > 0) {
        const Waiting next = stack[--waiting];
        if (next.entry > max_t) continue;
        const BvhNode* node = &nodes_[static_cast<std::size_t>(next.node)];
        while (node != nullptr && node->triangle_count == 0) {
            int near = node->first, far = near + 1;
            counters.box_tests += 2;
            double near_entry = entry(nodes_[static_cast<std::size_t>(near)]);
            double far_entry = entry(nodes_[static_cast<std::size_t>(far)]);
            if (far_entry < near_entry) {
                std::swap(near, far);
                std::swap(near_entry, far_entry);
            }
            if (far_entry <= max_t) stack[waiting++] = {far_entry, far};
            node = near_entry <= max_t ? &nodes_[static_cast<std::size_t>(near)] : nullptr;
        }
        if (node == nullptr) continue;
        counters.triangle_tests += node->triangle_count;
        visit_leaf(std::span(triangles_)
                       .subspan(static_cast<std::size_t>(node->first), static_cast<std::size_t>(node->triangle_count)));
    }
}

/// As geometry's intersect_triangle, on edges computed beforehand: t, negative when there is no hit.
double Bvh::intersect(const Ray& ray, const Triangle& triangle) {
    const glm::dvec3 across = glm::cross(ray.direction, triangle.ac);
    const double volume = glm::dot(triangle.ab, across);
    if (volume == 0.0) return -1.0;
    const double inverse = 1.0 / volume;
    const glm::dvec3 from_a = ray.origin - triangle.a;
    const double b = glm::dot(from_a, across) * inverse;
    if (!(b >= 0.0 && b <= 1.0)) return -1.0;
    const glm::dvec3 around = glm::cross(from_a, triangle.ab);
    const double c = glm::dot(ray.direction, around) * inverse;
    if (!(c >= 0.0 && b + c <= 1.0)) return -1.0;
    return glm::dot(triangle.ac, around) * inverse;
}

RayHit Bvh::nearest(const Ray& ray, double max_t, RayCounters& counters) const {
    ++counters.rays;
    const double same_t = same_t_ / glm::length(ray.direction);
    RayHit best;
    double limit = max_t;
    traverse(ray, limit, counters, [&](std::span<const Triangle> leaf) {
        for (const Triangle& triangle : leaf) {
            const double t = intersect(ray, triangle);
            if (!(t >= 0.0 && t <= limit)) continue;
            const bool is_tie = best.is_hit() && std::abs(t - best.t) <= same_t;
            if (is_tie ? triangle.source >= best.source : t >= best.t) continue;
            best = {t, triangle.polygon, triangle.source};
            limit = std::min(max_t, t + same_t);
        }
    });
    return best;
}

std::vector<RayHit> Bvh::all(const Ray& ray, double max_t, RayCounters& counters) const {
    ++counters.rays;
    std::vector<RayHit> hits;
    traverse(ray, max_t, counters, [&](std::span<const Triangle> leaf) {
        for (const Triangle& triangle : leaf) {
            const double t = intersect(ray, triangle);
            if (t >= 0.0 && t <= max_t) hits.push_back({t, triangle.polygon, triangle.source});
        }
    });
    // On the edge between two triangles of one polygon's fan the ray meets both.
    std::sort(hits.begin(), hits.end(),
              [](const RayHit& a, const RayHit& b) { return std::pair(a.polygon, a.t) < std::pair(b.polygon, b.t); });
    hits.erase(
        std::unique(hits.begin(), hits.end(), [](const auto& a, const auto& b) { return a.polygon == b.polygon; }),
        hits.end());
    std::sort(hits.begin(), hits.end(),
              [](const RayHit& a, const RayHit& b) { return std::pair(a.t, a.source) < std::pair(b.t, b.source); });
    return hits;
}

}  // namespace viewing
