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
    glm::dmat4 clip_from_scene{1.0};  ///< the matrix that draws its image

    glm::dvec4 towards_eye() const { return (eye_side < 0.0 ? -1.0 : 1.0) * plane.unit_plane; }
    bool is_seen_from_behind() const { return is_in_view && eye_side < 0.0; }
    /// Returns a plane; the objects on its positive side are mirrored.
    glm::dvec4 kept_side(const ReflectionParams& reflection) const {
        if (reflection.clip == MirrorClip::none) return {0.0, 0.0, 0.0, 1.0};
        return reflection.side_of_eye ? towards_eye() : plane.unit_plane;
    }
    double distance_from_origin() const { return std::abs(plane.unit_plane.w); }
};

/// Returns all mirrors if any of them is in the picture, since the others may be seen in that mirror; otherwise none.
/// `frame`: the camera's, or null if the images do not matter.
std::vector<Mirror> drawn_mirrors(const Params& params, const Derived& derived, const FramePlan* frame = nullptr);

/// Returns the matrix that sends a scene point to the point of the mirror's plane where the eye sees its image.
glm::dmat4 on_mirror_from_scene(const Derived& derived, const Mirror& mirror, const glm::dmat4& clip_from_scene);

/// Returns forms that are positive where `clip_from_scene` sends a point into the picture and, with the stencil, into
/// the mirror's patch as the eye sees it.
std::vector<glm::dvec4> forms_of_image(const Params& params, const Derived& derived, const Mirror& mirror,
                                       const glm::dmat4& clip_from_scene);

/// Returns forms_of_image() and three more forms, all positive on the kept side of the mirror and between near and far.
std::vector<glm::dvec4> forms_of_drawn_image(const Params& params, const Derived& derived, const Mirror& mirror,
                                             const glm::dmat4& clip_from_scene);

/// Returns whether `clip_from_scene` may draw part of an object inside the picture and, with the stencil, inside the
/// mirror and not covered by an object.
bool may_draw_image(const Params& params, const Derived& derived, const Mirror& mirror, const Scene& scene,
                    const glm::dmat4& clip_from_scene);

/// Returns whether an object's image may be in the picture, drawn with the uploaded R or the right one. With several
/// planes, always returns true: the images of the other planes are not examined.
bool may_show_image(const Params& params, const Derived& derived, const Mirror& mirror, const Scene& scene);

/// Returns whether a mirror's mask hides the mirror's image, which lies beyond the mirror unless the wrong side is
/// mirrored. If the mirror is drawn after another plane, depth is cleared inside the mask, so the mask hides nothing.
bool mask_hides(const Params& params, const Derived& derived, const Mirror& mirror, const Scene& scene);

/// Returns whether the mask hides the whole image: no part is drawn in front of the mirror or with the codes of an
/// oblique near plane.
bool mask_hides_all(const Params& params, const Derived& derived, const Mirror& mirror, const Scene& scene);

/// Returns whether part of a shadow may be seen in a mirror, on another plane's patch.
bool may_mirror_shadows(const Params& params, const Derived& derived, const Scene& scene, const FramePlan& frame);

/// Adds the errors of the masks, which keep each image inside its mirror, and each mirror at its correct depth among
/// the objects.
void find_mask_problems(std::vector<Problem>& problems, const Params& params, const Derived& derived,
                        const std::vector<Mirror>& mirrors, const Scene& scene);

/// Adds what is missing in mirrors that show each other. `depth`: FramePlan::reflection_depth.
void find_bounce_problems(std::vector<Problem>& problems, const Params& params, const Derived& derived,
                          const std::vector<Mirror>& mirrors, int depth);

}  // namespace viewing
