// What hidden-surface methods take on at most. Read hidden_views.h for what they are asked.
#pragma once

#include <cstdint>

#include "state/scene.h"
#include "text/result.h"

namespace viewing {

/// A polygon costs a method a few hundred bytes, with its pieces in a BSP tree up to two thousand.
inline constexpr std::uint64_t most_hidden_polygons = 1'000'000, most_bsp_polygons = 500'000;

/// The sentence why the methods do not take a scene on, before anything is spent on it. `builds_tree`: one of them is
/// the BSP tree.
Status check_hidden_budget(const Scene& scene, bool builds_tree);

}  // namespace viewing
