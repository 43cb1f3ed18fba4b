// Finds the objects whose images the mirrors show, and the part of them that far cuts off. Part of problems.h.
#pragma once

#include <string>
#include <vector>

#include "frame/plan.h"

namespace viewing {

/// The images of one object, in every mirror and bounce that the frame draws. An image counts where it is in the
/// picture and inside each mirror on the way, even if far cuts it off or something hides it.
struct SeenImage {
    std::string name;                           ///< of the object
    double nearest = 0.0, farthest = 0.0;       ///< eye distances of its vertices, over all its images
    bool is_shown = false, is_cut_off = false;  ///< some vertices are before far; some are beyond it
};

/// Returns the objects that have such an image, in the order of the scene. Judges at most a few sampled vertices of
/// each object. Empty if the frame draws no mirror.
std::vector<SeenImage> seen_images(const Derived& derived, const Scene& scene, const FramePlan& frame);

}  // namespace viewing
