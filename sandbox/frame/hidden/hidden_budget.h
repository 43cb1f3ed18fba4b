// What hidden-surface methods take on at most. Read hidden_views.h for what they are asked.
#pragma once

#include <cstdint>

#include "state/scene.h"
#include "text/result.h"

namespace viewing {

/// About ten seconds of one processor and a gigabyte, where all of them run through one another: with its pieces in a
/// BSP tree a polygon takes up to seven thousand bytes.
inline constexpr std::int64_t most_hidden_polygons = 400'000, most_bsp_polygons = 100'000;

/// The sentence why the methods do not take a scene on, before anything is spent on it. `builds_tree`: one of them is
/// the BSP tree.
Status check_hidden_budget(const Scene& scene, bool builds_tree);

}  // namespace viewing
