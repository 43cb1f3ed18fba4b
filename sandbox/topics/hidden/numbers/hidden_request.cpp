// Makes a method's requests: for the camera, and for the eye behind the mirror. Read hidden_surfaces.cpp next.
#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

#include "topics/hidden/numbers/method_parts.h"

namespace viewing {

namespace {

/// Returns the fraction of the view that a picture with square pixels fills if the pixels are as large as possible.
glm::dvec2 share_of(glm::ivec2 raster, glm::ivec2 size_px) {
    const glm::dvec2 view(glm::max(size_px, glm::ivec2(1))), room = view / glm::dvec2(raster);
    return std::min(room.x, room.y) * glm::dvec2(raster) / view;
}

/// Returns P as the methods need it: for a clip range of −1 … 1, in which nearer points have the smaller z.
glm::dmat4 standard_clip_from_view(const Params& params, const Derived& derived) {
    const std::optional<glm::dmat4>& by_hand = params.camera_overrides.clip_from_view;
    if (!by_hand || params.lens_by_hand()) return clip_from_view(params.lens(), derived.aspect);
    glm::dmat4 p = *by_hand;
    if (params.depth.mapping != DepthMapping::reversed) return p;
    for (int column = 0; column < 4; ++column)
        p[column][2] = params.depth.reversed_zero_to_one ? p[column][3] - 2.0 * p[column][2] : -p[column][2];
    return p;
}

}  // namespace

glm::dmat4 part_from_view(const glm::dvec2& share) {
    return glm::scale(glm::dmat4(1.0), {1.0 / share.x, 1.0 / share.y, 1.0});
}

std::optional<glm::ivec2> raster_pixel(const glm::dvec2& place_px, glm::ivec2 view_px, glm::ivec2 size_px,
                                       const glm::dvec2& share) {
    const glm::dvec2 position = (place_px / glm::dvec2(view_px) - 0.5) / share + 0.5;
    if (glm::any(glm::lessThan(position, glm::dvec2(0.0))) || glm::any(glm::greaterThan(position, glm::dvec2(1.0))))
        return std::nullopt;
    return glm::min(glm::ivec2(position * glm::dvec2(size_px)), size_px - 1);
}

HiddenRequest hidden_request(const Params& params, const Derived& derived, glm::ivec2 size_px) {
    HiddenRequest request{
        params.visibility, params.cull, {derived.view_from_world, standard_clip_from_view(params, derived)}, size_px};
    if (!has_raster(params.visibility)) return request;
    request.size_px = *params.visibility.raster;
    request.share = share_of(request.size_px, size_px);
    request.viewpoint.clip_from_view = part_from_view(request.share) * request.viewpoint.clip_from_view;
    return request;
}

HiddenRequest mirrored_request(const Params& params, const Derived& derived, glm::ivec2 size_px) {
    const DerivedPlane& plane = derived.planes.front();
    HiddenRequest request = hidden_request(params, derived, size_px);
    request.viewpoint.view_from_world = derived.view_from_world * plane.mirrored_world_from_world;
    request.visibility.step = -1;
    if (params.reflection.clip != MirrorClip::none) {
        // Objects behind the mirror would block the mirrored eye's view, so this picture begins at the mirror.
        const glm::dvec4 towards_eye = plane_facing(plane.unit_plane, derived.eye_world);
        request.viewpoint.clip_from_view = with_oblique_near_plane(
            request.viewpoint.clip_from_view, towards_eye * glm::inverse(request.viewpoint.view_from_world));
    }
    if (params.reflection.flip_winding)
        request.cull.front_face = request.cull.front_face == FrontFace::ccw ? FrontFace::cw : FrontFace::ccw;
    return request;
}

bool uses_exact_curves(const HiddenRequest& request) {
    return hidden_method(request.visibility.method).casts_rays && request.visibility.exact_curves &&
           !request.cull.enabled;
}

bool draws_pixels(const VisibilityParams& visibility) {
    return hidden_method(visibility.method).computes_pixels || has_raster(visibility) || is_front_to_back(visibility);
}

}  // namespace viewing
