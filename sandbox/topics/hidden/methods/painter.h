// The painter's algorithm at its simplest: sort whole polygons by one number, then draw them from far to near. This is
// correct only if that number happens to reflect which polygon hides which. See newell.h for the correct algorithm.
// Read bsp.h next. Source: lecture, Hidden Surface Removal: depth sorting.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "platform/progress.h"
#include "topics/hidden/methods/choices.h"
#include "topics/hidden/methods/polygons.h"
#include "topics/hidden/methods/viewpoint.h"

namespace viewing {

struct PainterOrder {
    PainterKey key{};
    std::vector<int> order;         ///< indices into the polygons, the farthest first; grows by one per step
    std::vector<double> distances;  ///< the value of `key` for every polygon, in the polygons' order
    std::int64_t comparisons = 0, swaps = 0;
};

/// Sorts with a heap, which finds one polygon after another in drawing order. For equal keys the higher index comes
/// first, so that the lower one is visible, as with the other methods. If canceled, the rest follows unsorted.
PainterOrder painter_order(std::span<const Polygon> polygons, const Viewpoint& viewpoint, PainterKey key,
                           WorkProgress* progress = nullptr);

}  // namespace viewing
