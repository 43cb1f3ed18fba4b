// What several switches of the depth buffer come to together.
#pragma once

#include "state/depth_params.h"

namespace viewing {

/// Whether every frame begins with the farthest depth everywhere.
inline bool is_cleared_to_farthest(const DepthParams& depth) {
    return depth.clear && depth.write_while_clearing &&
           (depth.mapping != DepthMapping::reversed || depth.reversed_clear);
}

/// Whether depth is taken at the corners alone and interpolated, so that no formula of the distance has it.
inline bool has_bent_depth(const DepthParams& depth) {
    return depth.mapping == DepthMapping::logarithmic && depth.logarithm_per_vertex;
}

/// Whether surfaces are compared by being nearer, as they should be.
inline bool wants_nearer(const DepthParams& depth) {
    return depth.tests() && (depth.func == CompareFunc::less || depth.func == CompareFunc::lequal);
}

}  // namespace viewing
