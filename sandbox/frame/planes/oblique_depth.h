// What the mirror as near plane does to depth in the image: along each line of sight codes lie closer together or
// farther apart than with the near plane of P. Read mirror_problems.cpp, which tells it.
#pragma once

#include <optional>

#include "frame/plan.h"

namespace viewing {

/// Width of a code in the image with the oblique near plane over its width with P's, at points of the scene that the
/// mirror shows: below 1 where depth is finer.
struct ObliqueDepth {
    double least = 1.0, greatest = 1.0;
    double coarsest_distance = 0.0;  ///< from the eye, along its axis, where it is `greatest`
};

/// Of the frame's first mirror image: at vertices, some hundred of them evenly taken, that are seen in its patch. None
/// where nothing is seen there, and where depth is not taken from clip space (logarithmic).
std::optional<ObliqueDepth> oblique_depth(const Params& params, const Derived& derived, const Scene& scene,
                                          const FramePlan& frame);

}  // namespace viewing
