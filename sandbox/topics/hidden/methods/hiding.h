// Finds which polygons must be painted before which others, and whether an order of whole polygons can satisfy all
// these pairs. This judges the painter's algorithm; newell.h finds an order by cutting. Read painter.h first. Source:
// Newell, Newell and Sancha 1972 for the test of a pair; Kahn 1962 for the order.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "topics/hidden/methods/choices.h"
#include "topics/hidden/methods/polygons.h"
#include "topics/hidden/methods/viewpoint.h"

namespace viewing {

/// Two indices: `before` must be painted before `after`, which hides a part of it.
struct HidingPair {
    int before = 0, after = 0;
    auto operator<=>(const HidingPair&) const = default;
};

/// Returns all pairs in which one polygon hides a part of the other in this view, sorted. Clips polygons at the near
/// plane. Two polygons that intersect appear in both orders; of coplanar polygons, the one with the lowest source
/// counts as in front. A polygon seen edge-on hides nothing. Compares every polygon with every other one, so it is
/// suitable for thousands of polygons at most. Stops soon after finding more than `most` pairs; the result is then
/// incomplete.
std::vector<HidingPair> hiding_pairs(std::span<const Polygon> polygons, const Viewpoint& viewpoint,
                                     std::optional<double> epsilon = std::nullopt,
                                     std::size_t most = std::numeric_limits<std::size_t>::max());

/// Converts pairs of items to pairs of groups, sorted and without duplicates; drops pairs within a group. `group_of`
/// holds the group of each item.
std::vector<HidingPair> grouped(std::span<const HidingPair> pairs, std::span<const int> group_of);

/// An order of the items 0 to count − 1 from back to front, or a cycle that makes such an order impossible.
struct WholeOrder {
    std::vector<int> order;  ///< satisfies every pair, the lowest item first where several fit; empty if impossible
    std::vector<int> cycle;  ///< if impossible, a short cycle: each item must precede the next, the last one the first
};
WholeOrder whole_order(int count, std::span<const HidingPair> pairs);

/// Returns how many pairs an order (each index once, back to front) violates.
int wrong_pairs(std::span<const HidingPair> pairs, std::span<const int> order);

}  // namespace viewing
