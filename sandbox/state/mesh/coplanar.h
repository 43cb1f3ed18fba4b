// The scene `coplanar`: pairs of quads that show depth fighting. They are computed from the parameters in
// depth_params.h.
#pragma once

#include "state/depth_params.h"
#include "state/scene_description.h"

namespace viewing {

/// Makes six pairs of quads, the nearest pair first. Each pair consists of a back quad and then a front quad, which is
/// `gap` in front of it along the common normal. Seen from (0, 1.5, 4) along −z, the pairs stay in the same places in
/// the picture for any `distance`, because their positions and sizes scale with it; the gap does not scale. `tilt`
/// rotates each pair about its own x axis; at 0, the pair's normal is horizontal. The names contain the eye distances
/// of the back quads. If the tilt is more than about 80°, a pair below the eye shows its other side.
SceneDescription coplanar_scene(const CoplanarParams& params);

}  // namespace viewing
