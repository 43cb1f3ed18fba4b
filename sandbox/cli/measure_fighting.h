// Depth fighting of a state's scene, counted and predicted, as JSON: a part of measure. Read measure/fighting_measure.h
// and measure/minimum_gap.h for the counting.
#pragma once

#include "cli/headless.h"
#include "state/document.h"
#include "state/presets.h"
#include "state/scene.h"

namespace viewing {

/// Every pair of near-coplanar flat objects from the state's camera, and the smallest gap that its depth buffer tells
/// apart at the target's distance. Throws Failure where GL does not draw.
Json fighting_as_json(Headless& headless, const LoadedState& state, const Scene& scene, glm::ivec2 size_px);

}  // namespace viewing
