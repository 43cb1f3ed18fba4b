// Measures how depth in the image changes if the mirror is the near plane: along each view ray, codes are closer
// together or farther apart than with the near plane of P. See mirror_problems.cpp, which reports the result.
#pragma once

#include <optional>

#include "frame/plan/plan.h"

namespace viewing {

/// Width of a code in the image with the oblique near plane, divided by its width with P's near plane, at points of the
/// scene that the mirror shows: below 1, depth is finer.
struct ObliqueDepth {
    double least = 1.0, greatest = 1.0;
    double coarsest_distance = 0.0;  ///< eye distance of the point with the ratio `greatest`
};

/// Measures the frame's first mirror image. Takes at most 600 evenly chosen vertices and uses those that are visible in
/// the mirror's patch. Returns none if no vertex is visible there, or if depth does not come from clip space
/// (logarithmic).
std::optional<ObliqueDepth> oblique_depth(const Params& params, const Derived& derived, const Scene& scene,
                                          const FramePlan& frame);

}  // namespace viewing
