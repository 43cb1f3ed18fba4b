// The combined meaning of several switches of the depth buffer.
#pragma once

#include "state/depth_params.h"

namespace viewing {

/// Returns the window depth of glClearDepth.
inline double cleared_depth(const DepthParams& depth) {
    const bool is_turned = depth.mapping == DepthMapping::reversed && depth.reversed_clear;
    return is_turned ? 1.0 - depth.clear_value : depth.clear_value;
}

/// Returns whether the buffer is cleared to the farthest depth, so that everything is nearer.
inline bool clears_to_farthest(const DepthParams& depth) {
    return cleared_depth(depth) == (depth.mapping == DepthMapping::reversed ? 0.0 : 1.0);
}

/// Returns whether glClear clears the depth buffer: it obeys the depth mask.
inline bool clears_depth(const DepthParams& depth) {
    return depth.clear && depth.write_while_clearing;
}

/// Returns whether every frame begins with the farthest depth everywhere.
inline bool is_cleared_to_farthest(const DepthParams& depth) {
    return clears_depth(depth) && clears_to_farthest(depth);
}

/// Returns whether logarithmic depth is computed only at the vertices. Between them, depth is interpolated and does not
/// match the distance.
inline bool has_bent_depth(const DepthParams& depth) {
    return depth.mapping == DepthMapping::logarithmic && depth.logarithm_per_vertex;
}

/// Returns whether the buffer is cleared to the nearest depth, so that nothing can be nearer.
inline bool clears_to_nearest(const DepthParams& depth) {
    return cleared_depth(depth) == (depth.mapping == DepthMapping::reversed ? 1.0 : 0.0);
}

/// Returns whether no fragment passes the depth test, or only those at exactly the depth that the buffer is cleared to.
inline bool rejects_all(const DepthParams& depth) {
    if (!depth.tests()) return false;
    switch (depth.func) {
        case CompareFunc::never:
        case CompareFunc::equal:
            return true;
        case CompareFunc::greater:
        case CompareFunc::gequal:
            return clears_to_farthest(depth);
        case CompareFunc::less:
        case CompareFunc::lequal:
            return clears_to_nearest(depth);
        default:
            return false;
    }
}

/// Returns whether the depths left by an identical previous frame hide this frame completely.
inline bool hides_next_frame(const DepthParams& depth) {
    const bool refuses_ties = depth.func == CompareFunc::less || depth.func == CompareFunc::greater;
    return depth.tests() && refuses_ties && depth.write && !clears_depth(depth);
}

/// Returns whether GL_NOTEQUAL compares with the depths of the previous frame, and so rejects the surfaces that were
/// drawn then.
inline bool rejects_previous_frame(const DepthParams& depth) {
    return depth.tests() && depth.func == CompareFunc::notequal && depth.write && !clears_depth(depth);
}

/// Returns whether the depth test depends on which of two depths is nearer.
inline bool compares_nearness(const DepthParams& depth) {
    return depth.tests() && (depth.func == CompareFunc::less || depth.func == CompareFunc::lequal ||
                             depth.func == CompareFunc::greater || depth.func == CompareFunc::gequal);
}

/// Returns whether reversed depth uses the offset with its sign: a negative number then pushes surfaces away.
inline bool keeps_offset_sign(const DepthParams& depth) {
    return depth.mapping == DepthMapping::reversed && !depth.reversed_offset;
}

/// Returns how many switches, each by itself, let the last fragment drawn win.
inline int count_of_last_wins(const DepthParams& depth) {
    const bool passes = depth.func == CompareFunc::always || depth.func == CompareFunc::notequal;
    return (depth.buffer ? 0 : 1) + (depth.test ? 0 : 1) + (depth.write ? 0 : 1) + (passes ? 1 : 0);
}

/// Returns whether nearer surfaces win, as they should.
inline bool wants_nearer(const DepthParams& depth) {
    return depth.tests() && (depth.func == CompareFunc::less || depth.func == CompareFunc::lequal);
}

}  // namespace viewing
