// Who hides whom: which polygons must be painted before which, and whether there is an order of whole polygons that
// obeys all of it. What the painter's algorithm is judged by; newell.h finds an order by cutting. Read painter.h first.
// Source: Newell, Newell and Sancha 1972 for the test of a pair; Kahn 1962 for the order.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "visibility/choices.h"
#include "visibility/polygons.h"
#include "visibility/viewpoint.h"

namespace viewing {

/// `before` must be painted before `after`, which hides a part of it. Indices.
struct HidingPair {
    int before = 0, after = 0;
    auto operator<=>(const HidingPair&) const = default;
};

/// All pairs that hide one another in this view, sorted. Polygons are clipped at the near plane. Two that run through
/// each other stand in it both ways round; of coplanar ones the one with the lowest source counts as in front. What is
/// seen edge-on hides nothing. Every polygon is compared with every other one: for thousands, not for more. Ends soon
/// after `most` pairs, with more than these and not with all.
std::vector<HidingPair> hiding_pairs(std::span<const Polygon> polygons, const Viewpoint& viewpoint,
                                     std::optional<double> epsilon = std::nullopt,
                                     std::size_t most = std::numeric_limits<std::size_t>::max());

/// The same between groups, `group_of` each index: sorted, each once, without pairs inside a group.
std::vector<HidingPair> grouped(std::span<const HidingPair> pairs, std::span<const int> group_of);

/// Whole things from 0 to count − 1, back to front.
struct WholeOrder {
    std::vector<int> order;  ///< one that obeys every pair, of equals the lowest first; empty where there is none
    std::vector<int> cycle;  ///< then: each must come before the next one, the last before the first; a short one
};
WholeOrder whole_order(int count, std::span<const HidingPair> pairs);

/// How many pairs an order (each index once, back to front) has the wrong way round.
int wrong_pairs(std::span<const HidingPair> pairs, std::span<const int> order);

}  // namespace viewing
