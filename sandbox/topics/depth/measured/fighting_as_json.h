// Reports depth fighting in a state's scene, counted and predicted, as JSON. Read
// topics/depth/measured/fighting_measure.h and topics/depth/measured/minimum_gap.h for the counting.
#pragma once

#include "render/renderer.h"
#include "state/file/document.h"
#include "state/scene.h"

namespace viewing {

/// Reports every pair of near-coplanar flat objects as seen by the state's camera. Unless `counts_alone` is true, also
/// reports the cures, the spread for a jittered camera, and the smallest gap that the depth buffer resolves at the
/// target's distance; this requires drawing dozens of pictures. The error comes from GL, or says that the scene is too
/// large.
Result<Json> fighting_as_json(Renderer& renderer, const Params& params, const Scene& scene, glm::ivec2 size_px,
                              bool counts_alone = false);

}  // namespace viewing
