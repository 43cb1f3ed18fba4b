// The scene `coplanar`, made by a formula from its parameters: pairs of quads that fight over the depth buffer. Read
// depth_params.h for the parameters.
#pragma once

#include "state/depth_params.h"
#include "state/scene_description.h"

namespace viewing {

/// Six pairs, the nearest first: of each the back quad, then the front one `gap` before it along the common normal. The
/// pairs keep their places in the picture seen from (0, 1.5, 4) along −z, whatever `distance` is: places and sizes are
/// in proportion to it, the gap is not. `tilt` turns each pair about its own x axis; at 0 its normal is horizontal. The
/// names say the eye distances of the back quads. Tilted by more than about 80° a pair below the eye shows its other
/// side.
SceneDescription coplanar_scene(const CoplanarParams& params);

}  // namespace viewing
