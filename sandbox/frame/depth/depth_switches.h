// The combined meaning of several switches of the depth buffer.
#pragma once

#include "state/depth_params.h"

namespace viewing {

/// Returns whether every frame begins with the farthest depth everywhere.
inline bool is_cleared_to_farthest(const DepthParams& depth) {
    return depth.clear && depth.write_while_clearing &&
           (depth.mapping != DepthMapping::reversed || depth.reversed_clear);
}

/// Returns whether depth is computed only at the vertices and interpolated, so that it does not follow from the
/// distance.
inline bool has_bent_depth(const DepthParams& depth) {
    return depth.mapping == DepthMapping::logarithmic && depth.logarithm_per_vertex;
}

/// Returns whether nearer surfaces win, as they should.
inline bool wants_nearer(const DepthParams& depth) {
    return depth.tests() && (depth.func == CompareFunc::less || depth.func == CompareFunc::lequal);
}

}  // namespace viewing
