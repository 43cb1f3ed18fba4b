// What a method is asked: the camera's picture, and that of the eye behind the mirror. Read hidden_surfaces.cpp next.
#include "frame/hidden/hidden_surfaces.h"

namespace viewing {

HiddenRequest hidden_request(const Params& params, const Derived& derived, glm::ivec2 size_px) {
    return {params.visibility,
            params.cull,
            {derived.view_from_world, clip_from_view(params.projection.lens(), derived.aspect)},
            size_px};
}

HiddenRequest mirrored_request(const Params& params, const Derived& derived, glm::ivec2 size_px) {
    const DerivedPlane& plane = derived.planes.front();
    HiddenRequest request = hidden_request(params, derived, size_px);
    request.viewpoint.view_from_world = derived.view_from_world * plane.mirrored_world_from_world;
    request.visibility.step = -1;
    if (params.reflection.clip != MirrorClip::none) {
        // What lies behind the mirror would stand in this eye's way: its picture begins at the mirror.
        const glm::dvec4 towards_eye = plane_facing(plane.unit_plane, derived.eye_world);
        request.viewpoint.clip_from_view = with_oblique_near_plane(
            request.viewpoint.clip_from_view, towards_eye * glm::inverse(request.viewpoint.view_from_world));
    }
    if (params.reflection.flip_winding)
        request.cull.front_face = request.cull.front_face == FrontFace::ccw ? FrontFace::cw : FrontFace::ccw;
    return request;
}

bool uses_exact_curves(const HiddenRequest& request) {
    return request.visibility.method == VisibilityMethod::ray_cast && request.visibility.exact_curves &&
           !request.cull.enabled;
}

bool draws_pixels(const VisibilityParams& visibility) {
    return visibility.method == VisibilityMethod::software_depth_buffer ||
           visibility.method == VisibilityMethod::ray_cast ||
           (visibility.method == VisibilityMethod::bsp && visibility.walk == BspOrder::front_to_back);
}

}  // namespace viewing
