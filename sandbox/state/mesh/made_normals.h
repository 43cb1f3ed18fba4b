// Internal to state/: normals for the corners of an OBJ file that name none.
#pragma once

#include "state/mesh/obj_lines.h"

namespace viewing {

/// Gives each corner without a normal one that is made from the faces about its position: the sum of their normals by
/// area, over those that can be reached from the corner's face across smooth edges. An edge between two faces is smooth
/// if both are in the same group ("s 1"); never with "s off" or between two groups; where the file has said nothing,
/// if the angle between the faces is `crease_deg` at most (0 … 180). Corners that have a normal keep it. A face without
/// an area gives nothing, and where all are so the normal is (0, 1, 0).
void make_missing_normals(ObjContent& content, double crease_deg);

}  // namespace viewing
