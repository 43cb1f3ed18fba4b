// Sorting by the bits of x, y and z in turn puts what is near in space near in the list.
#include "frame/depth/triangle_runs.h"

#include <algorithm>

namespace viewing {
namespace {

constexpr int bits = 10;  ///< of each coordinate

/// The place of a point along the curve through the bounds; what is not finite is at the beginning.
std::uint64_t place_on_curve(const glm::dvec3& point, const Bounds& bounds) {
    const glm::dvec3 share = (point - bounds.min) / bounds.size();  // not a number where there is no extent
    std::uint64_t place = 0;
    for (int axis = 0; axis < 3; ++axis) {
        constexpr double cells = 1 << bits;
        const auto cell =
            static_cast<std::uint64_t>(share[axis] > 0.0 ? std::min(share[axis] * cells, cells - 1.0) : 0.0);
        for (int bit = 0; bit < bits; ++bit) place |= (cell >> bit & 1U) << (3 * bit + axis);
    }
    return place;
}

}  // namespace

TriangleRuns runs_of(const Mesh& mesh) {
    const auto corner = [&](std::size_t index) { return glm::dvec3(mesh.positions[mesh.indices[index]]); };
    const Bounds bounds = bounds_of(mesh);
    std::vector<std::uint64_t> sorted(mesh.triangle_count());  // place on the curve, then number
    for (std::size_t i = 0; i < sorted.size(); ++i)
        sorted[i] = place_on_curve((corner(3 * i) + corner(3 * i + 1) + corner(3 * i + 2)) / 3.0, bounds) << 32U | i;
    std::sort(sorted.begin(), sorted.end());

    TriangleRuns runs;
    runs.triangles.reserve(sorted.size());
    runs.boxes.resize((sorted.size() + TriangleRuns::length - 1) / TriangleRuns::length);
    for (const std::uint64_t entry : sorted) {
        const auto triangle = static_cast<std::uint32_t>(entry);
        Bounds& box = runs.boxes[runs.triangles.size() / TriangleRuns::length];
        for (std::size_t k = 0; k < 3; ++k) box.add(corner(3 * std::size_t{triangle} + k));
        runs.triangles.push_back(triangle);
    }
    return runs;
}

}  // namespace viewing
