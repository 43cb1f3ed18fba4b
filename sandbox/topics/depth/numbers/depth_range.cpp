// Finds the range of eye distances that gives a depth picture contrast, and its scale of grays.
#include <algorithm>

#include "frame/plan/plan.h"

namespace viewing {

glm::dvec2 contrast_range(const Params& params, const Derived& derived, const Scene& scene) {
    const Lens lens = params.lens();
    const double near = lens.near, far = lens.shown_far();
    if (const auto& asked = params.view.depth_range; asked && asked->x < far && asked->y > near)
        return glm::clamp(*asked, near, far);
    glm::dvec2 range(far, near);
    const auto take = [&](const glm::dvec3& corner) {
        const double distance = -(derived.view_from_world * glm::dvec4(corner, 1.0)).z;
        range = {std::min(range.x, distance), std::max(range.y, distance)};
    };
    for (const glm::dvec3& corner : derived.planes.front().patch.corners()) take(corner);
    const Bounds& bounds = scene.bounds_world;
    for (int corner = 0; corner < 8 && !bounds.empty(); ++corner)
        take({corner & 1 ? bounds.max.x : bounds.min.x, corner & 2 ? bounds.max.y : bounds.min.y,
              corner & 4 ? bounds.max.z : bounds.min.z});
    range = glm::clamp(range, near, far);
    return range.x < range.y ? range : glm::dvec2(near, far);
}

GrayScale gray_scale(const FramePlan& plan) {
    const auto value_at = [&](double distance) {
        return plan.depth_scale == DepthScale::linear ? distance
                                                      : window_depth(plan.lens, plan.depth_mapping, distance);
    };
    const double first = value_at(plan.shown_range.x), width = value_at(plan.shown_range.y) - first;
    constexpr double steepest = 1e30;  // fits a float
    return {first, width == 0.0 ? steepest : std::clamp(1.0 / width, -steepest, steepest)};
}

}  // namespace viewing
