// The mirrors whose images the frame draws. Part of problems.h.
#pragma once

#include <cmath>
#include <vector>

#include "frame/problems.h"

namespace viewing {

/// A mirror that has an image in the frame.
struct Mirror {
    const DerivedPlane& plane;
    double eye_side;
    bool is_in_view;

    glm::dvec4 towards_eye() const { return (eye_side < 0.0 ? -1.0 : 1.0) * plane.unit_plane; }
    bool is_seen_from_behind() const { return is_in_view && eye_side < 0.0; }
    /// Returns a plane; the objects on its positive side are mirrored.
    glm::dvec4 kept_side(const ReflectionParams& reflection) const {
        if (reflection.clip == MirrorClip::none) return {0.0, 0.0, 0.0, 1.0};
        return reflection.side_of_eye ? towards_eye() : plane.unit_plane;
    }
    double distance_from_origin() const { return std::abs(plane.unit_plane.w); }
};

/// Returns all mirrors if any of them is in the picture, since the others may be seen in it; otherwise none.
std::vector<Mirror> drawn_mirrors(const Params& params, const Derived& derived);

/// Adds what is missing in mirrors that show each other. `depth`: FramePlan::reflection_depth.
void find_bounce_problems(std::vector<Problem>& problems, const Params& params, const Derived& derived,
                          const std::vector<Mirror>& mirrors, int depth);

}  // namespace viewing
