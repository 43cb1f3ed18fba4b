// The painter's algorithm at its simplest: sort whole polygons by one number, draw from far to near. Right only where
// that number happens to tell who hides whom. Read newell.h for the right one, bsp.h next.
// Source: lecture, Hidden Surface Removal: depth sorting.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "platform/progress.h"
#include "visibility/choices.h"
#include "visibility/polygons.h"
#include "visibility/viewpoint.h"

namespace viewing {

struct PainterOrder {
    std::vector<int> order;         ///< indices into the polygons, the farthest first; grows by one a step
    std::vector<double> distances;  ///< the key of every polygon, in their own order
    std::int64_t comparisons = 0, swaps = 0;
};

/// Heap sort, which finds one polygon after the other in drawing order. Equal keys: the higher index first, so that the
/// lower one is seen, as with the other methods. Cancelled: what is left follows unsorted.
PainterOrder painter_order(std::span<const Polygon> polygons, const Viewpoint& viewpoint, PainterKey key,
                           WorkProgress* progress = nullptr);

}  // namespace viewing
