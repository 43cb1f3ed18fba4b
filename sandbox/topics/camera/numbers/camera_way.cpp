#include "topics/camera/numbers/camera_way.h"

#include <array>
#include <cmath>

#include "text/catalogue.h"
#include "text/per_enum.h"
#include "topics/depth/numbers/fragment_depth.h"

namespace viewing {

CameraWay camera_way(const Params& params, const Derived& derived, const glm::dvec3& point_world) {
    CameraWay way;
    const glm::dvec4 view = derived.view_from_world * glm::dvec4(point_world, 1.0);
    way.point_view = glm::dvec3(view) / view.w;
    way.point_clip = derived.clip_from_view * view;
    const glm::dvec4& clip = way.point_clip;
    if (std::abs(clip.w) > 1e-12) way.point_ndc = glm::dvec3(clip) / clip.w;
    const Lens lens = params.lens();
    const double distance = -way.point_view.z;
    if (distance < lens.near)
        way.cut_by = FrustumPlane::near;
    else if (distance > lens.far)
        way.cut_by = FrustumPlane::far;
    else if (std::abs(clip.x) > clip.w)
        way.cut_by = clip.x < 0.0 ? FrustumPlane::left : FrustumPlane::right;
    else if (std::abs(clip.y) > clip.w)
        way.cut_by = clip.y < 0.0 ? FrustumPlane::bottom : FrustumPlane::top;
    if (distance >= lens.near && distance <= lens.far) {
        way.window_depth = window_depth(lens, params.depth.mapping, distance);
        way.code = code_of(*way.window_depth, precision_of(params.depth.format));
    }
    return way;
}

glm::dmat4 window_from_ndc(const glm::dvec2& size_px, bool zero_to_one) {
    const glm::dvec3 scale(0.5 * size_px, zero_to_one ? 1.0 : 0.5), move(0.5 * size_px, zero_to_one ? 0.0 : 0.5);
    glm::dmat4 window(1.0);
    for (int axis = 0; axis < 3; ++axis) window[axis][axis] = scale[axis];
    window[3] = glm::dvec4(move, 1.0);
    return window;
}

const char* outcome_of(FrustumPlane plane) {
    static constexpr auto texts = per_enum<FrustumPlane>(
        marked("inside the frustum"), marked("cut off by the near plane"), marked("cut off by the far plane"),
        marked("left of the picture"), marked("right of the picture"), marked("below the picture"),
        marked("above the picture"));
    return texts[plane];
}

}  // namespace viewing
