// Sorts items along a Hilbert curve, which keeps neighbors in space close together in the list. The curve never jumps,
// so the box around a run of neighbors usually stays small. Source: Skilling, Programming the Hilbert curve, 2004.
#include "frame/box_tree.h"

#include <array>
#include <map>
#include <mutex>
#include <utility>

namespace viewing {
namespace {

constexpr int bits = 10;  ///< per coordinate
using Cell = std::array<std::uint32_t, 3>;

/// Converts a cell's coordinates to the digits of its position along the curve. Each digit takes one bit from each of
/// the three coordinates; the first coordinate's bit is the highest.
Cell digits_on_curve(Cell cell) {
    for (std::uint32_t half = 1U << (bits - 1); half > 1; half >>= 1) {  // reorient the octants inside each octant
        const std::uint32_t below = half - 1;
        for (std::uint32_t& axis : cell) {
            if ((axis & half) != 0) {
                cell[0] ^= below;
            } else {
                const std::uint32_t exchanged = (cell[0] ^ axis) & below;
                cell[0] ^= exchanged;
                axis ^= exchanged;
            }
        }
    }
    cell[1] ^= cell[0];  // Gray code
    cell[2] ^= cell[1];
    std::uint32_t turned = 0;
    for (std::uint32_t half = 1U << (bits - 1); half > 1; half >>= 1)
        if ((cell[2] & half) != 0) turned ^= half - 1;
    for (std::uint32_t& axis : cell) axis ^= turned;
    return cell;
}

/// Returns a point's position along the curve through the bounds; a coordinate that is not finite counts as the lowest.
std::uint64_t place_on_curve(const glm::dvec3& point, const Bounds& bounds) {
    const glm::dvec3 share = (point - bounds.min) / bounds.size();  // NaN along an axis without extent
    Cell cell{};
    for (int axis = 0; axis < 3; ++axis) {
        constexpr double cells = 1 << bits;
        cell[axis] = static_cast<std::uint32_t>(share[axis] > 0.0 ? std::min(share[axis] * cells, cells - 1.0) : 0.0);
    }
    std::uint64_t place = 0;
    const Cell digits = digits_on_curve(cell);
    for (int bit = bits - 1; bit >= 0; --bit)
        for (const std::uint32_t axis : digits) place = place << 1 | (axis >> bit & 1U);
    return place;
}

/// Keeps each mesh's trees for as long as the mesh exists.
class KeptTrees {
public:
    template <typename Make>
    std::shared_ptr<const BoxTree> of(const std::shared_ptr<const Mesh>& mesh, Make make) {
        const std::scoped_lock lock(mutex_);
        if (const auto found = trees_.find(mesh); found != trees_.end()) return found->second;
        for (auto tree = trees_.begin(); tree != trees_.end();)
            tree = tree->first.expired() ? trees_.erase(tree) : std::next(tree);
        return trees_[mesh] = std::make_shared<const BoxTree>(make(*mesh));
    }

private:
    std::mutex mutex_;
    std::map<std::weak_ptr<const Mesh>, std::shared_ptr<const BoxTree>, std::owner_less<>> trees_;
};

}  // namespace

template <typename BoundsOf>
BoxTree BoxTree::made(std::size_t count, const Bounds& whole, BoundsOf bounds_of_item) {
    std::vector<std::uint64_t> sorted(count);  // position on the curve, in the high bits; then index
    for (std::size_t i = 0; i < count; ++i) sorted[i] = place_on_curve(bounds_of_item(i).center(), whole) << 32U | i;
    std::sort(sorted.begin(), sorted.end());

    BoxTree tree;
    if (count == 0) return tree;
    tree.items_.reserve(count);
    std::vector<Bounds> boxes((count + run_length - 1) / run_length);
    for (const std::uint64_t entry : sorted) {
        const auto item = static_cast<std::uint32_t>(entry);
        boxes[tree.items_.size() / run_length].add(bounds_of_item(item));
        tree.items_.push_back(item);
    }
    while (boxes.size() > 1) {
        std::vector<Bounds> larger((boxes.size() + fan - 1) / fan);
        for (std::size_t i = 0; i < boxes.size(); ++i) larger[i / fan].add(boxes[i]);
        tree.levels_.push_back(std::exchange(boxes, std::move(larger)));
    }
    tree.levels_.push_back(std::move(boxes));
    return tree;
}

BoxTree BoxTree::of_vertices(const Mesh& mesh) {
    return made(mesh.positions.size(), bounds_of(mesh), [&](std::size_t vertex) {
        const glm::dvec3 position(mesh.positions[vertex]);
        return Bounds{position, position};
    });
}

BoxTree BoxTree::of_triangles(const Mesh& mesh) {
    return made(mesh.triangle_count(), bounds_of(mesh), [&](std::size_t triangle) {
        Bounds bounds;
        for (std::size_t corner = 0; corner < 3; ++corner)
            bounds.add(mesh.positions[mesh.indices[3 * triangle + corner]]);
        return bounds;
    });
}

std::shared_ptr<const BoxTree> vertex_tree(const std::shared_ptr<const Mesh>& mesh) {
    static KeptTrees kept;
    return kept.of(mesh, BoxTree::of_vertices);
}

std::shared_ptr<const BoxTree> triangle_tree(const std::shared_ptr<const Mesh>& mesh) {
    static KeptTrees kept;
    return kept.of(mesh, BoxTree::of_triangles);
}

}  // namespace viewing
