// Finds the objects whose images the mirrors show, and the part of them that far cuts off. Part of problems.h.
#pragma once

#include <string>
#include <vector>

#include "frame/plan/plan.h"

namespace viewing {

/// The scene as seen through a sequence of mirrors, or just one. Forms take a scene point (x, y, z, 1).
struct WayThroughMirrors {
    std::vector<std::size_t> mirrors;  ///< in the order in which the view ray meets them; never empty
    bool is_from_behind = false;       ///< the last mirror's normal points away from the side that is seen
    std::vector<glm::dvec4> inside;    ///< all positive where a point's image is seen in each mirror, beyond near
    glm::dvec4 side{0.0};              ///< positive on the side of the last mirror whose points the mirror should show
    glm::dvec4 distance{0.0};          ///< the image's eye distance
    glm::dvec4 before_far{0.0};        ///< positive for images that far does not cut off

    /// Returns forms that are positive where the last mirror shows a point although the point is behind the mirror by
    /// more than `tolerance` (world units).
    std::vector<glm::dvec4> forms_behind(double tolerance) const;
};

/// Returns a way for each sequence of mirrors in which the frame draws objects. Without the stencil, an image need not
/// be inside the mirror's patch.
std::vector<WayThroughMirrors> ways_through_mirrors(const Params& params, const Derived& derived,
                                                    const FramePlan& frame);

/// The images of one object, in every mirror and bounce that the frame draws. An image counts where it is in the
/// picture and inside each mirror on the way, even if far cuts it off or something hides it.
struct SeenImage {
    std::string name;                           ///< of the object
    double nearest = 0.0, farthest = 0.0;       ///< eye distances of its vertices, over all its images
    bool is_shown = false, is_cut_off = false;  ///< some vertices are nearer than far; some are beyond it
};

/// Returns one entry for each object that has such an image, in the order of the scene. Judges at most a few sampled
/// vertices of each object. Empty if the frame draws no mirror.
std::vector<SeenImage> seen_images(const Params& params, const Derived& derived, const Scene& scene,
                                   const FramePlan& frame);

}  // namespace viewing
