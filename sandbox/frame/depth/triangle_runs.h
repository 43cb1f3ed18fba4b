// A mesh's triangles in runs of neighbours with a box around each, so that most of a large mesh is passed over at once.
// Read fragments.h next.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/mesh.h"

namespace viewing {

struct TriangleRuns {
    static constexpr std::size_t length = 64;

    std::vector<std::uint32_t> triangles;  ///< each once, along a space-filling curve
    std::vector<Bounds> boxes;             ///< one for each run, in model space

    std::span<const std::uint32_t> run(std::size_t index) const {
        return std::span(triangles).subspan(index * length, std::min(length, triangles.size() - index * length));
    }
};

/// Source: Morton 1966, for the curve.
TriangleRuns runs_of(const Mesh& mesh);

}  // namespace viewing
