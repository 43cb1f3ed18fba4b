// Internal to state/: computes normals for corners of an OBJ file that have none.
#pragma once

#include "state/mesh/obj_lines.h"

namespace viewing {

/// Gives each corner without a normal the direction of an area-weighted sum of face normals. The sum includes those
/// faces around the corner's position that smooth edges connect to the corner's own face. An edge is smooth if both
/// faces are in the same smoothing group ("s 1"); it is sharp after "s off" or between two groups. In a file without
/// any "s" line, an edge is smooth if the angle between the faces is at most `crease_deg` (0 … 180). Corners that have
/// a normal keep it. A face without area contributes nothing; if none of the faces has an area, the normal is +y.
void make_missing_normals(ObjContent& content, double crease_deg);

}  // namespace viewing
