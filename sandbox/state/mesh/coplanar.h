// The scene `coplanar`: pairs of quads that fight over the depth buffer, made by a formula from its parameters. Read
// depth_params.h for the parameters.
#pragma once

#include "state/depth_params.h"
#include "state/scene_description.h"

namespace viewing {

/// Makes six pairs, nearest first: each a back quad, then the front quad, `gap` in front of it along the common normal.
/// Seen from (0, 1.5, 4) along −z, the pairs keep their places in the picture for any `distance`: positions and sizes
/// scale with it, the gap does not. `tilt` rotates each pair about its own x axis; at 0 its normal is horizontal. The
/// names contain the eye distances of the back quads. Beyond a tilt of about 80°, a pair below the eye shows its other
/// side.
SceneDescription coplanar_scene(const CoplanarParams& params);

}  // namespace viewing
