// Depth fighting of a state's scene, counted and predicted, as JSON. Read measure/fighting_measure.h
// and measure/minimum_gap.h for the counting.
#pragma once

#include "render/renderer.h"
#include "state/file/document.h"
#include "state/scene.h"

namespace viewing {

/// Every pair of near-coplanar flat objects from the state's camera and the cures; unless `counts_alone`, also the
/// spread under a trembling camera and the smallest gap that its depth buffer tells apart at the target's distance,
/// which take dozens of pictures. The error is GL's.
Result<Json> fighting_as_json(Renderer& renderer, const Params& params, const Scene& scene, glm::ivec2 size_px,
                              bool counts_alone = false);

}  // namespace viewing
