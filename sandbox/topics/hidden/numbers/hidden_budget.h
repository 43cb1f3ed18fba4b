// The limits of the hidden-surface methods. See hidden_views.h for their input.
#pragma once

#include <cstdint>

#include "state/scene.h"
#include "text/message.h"

namespace viewing {

/// At these limits, a method takes about ten seconds on one processor and a gigabyte of memory if all polygons
/// intersect one another: in a BSP tree, a polygon and its pieces take up to seven thousand bytes.
inline constexpr std::int64_t most_hidden_polygons = 400'000, most_bsp_polygons = 100'000;

/// Says that the scene is too large for the methods, before any work is spent on it; empty if it is not. `builds_tree`:
/// one of the methods builds the BSP tree.
Message beyond_hidden_budget(const Scene& scene, bool builds_tree);

}  // namespace viewing
