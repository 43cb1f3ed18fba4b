#include "frame/cleared_code.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "frame/depth_switches.h"
#include "frame/object_reach.h"

namespace viewing {

double start_of_cleared_code(const Params& params) {
    const DepthParams& depth = params.depth;
    const bool refuses_ties = params.tests_depth() && depth.func == CompareFunc::less;
    if (!refuses_ties || !is_cleared_to_farthest(depth) || has_bent_depth(depth))
        return std::numeric_limits<double>::infinity();
    const double farthest = depth.mapping == DepthMapping::reversed ? 0.0 : 1.0;
    const double half = 0.5 * code_width(precision_of(depth.format), farthest);
    return distance_of_window_depth(params.lens(), depth.mapping, std::abs(farthest - half));
}

bool lets_nearer_win(const Params& params) {
    return uses_gl_depth_test(params.visibility.method) && wants_nearer(params.depth);
}

bool last_fragment_wins(const Params& params) {
    const VisibilityMethod method = params.visibility.method;
    return uses_gl_depth_test(method) ? count_of_last_wins(params.depth) > 0 : is_drawn_by_gl_alone(method);
}

bool previous_frame_hides(const Params& params) {
    return uses_gl_depth_test(params.visibility.method) && hides_next_frame(params.depth);
}

bool has_only_cleared_code(const Params& params, const Derived& derived, const Scene& scene) {
    Params with_less = params;
    with_less.depth.func = CompareFunc::less;
    with_less.depth.clear = with_less.depth.write_while_clearing = with_less.depth.reversed_clear = true;
    with_less.depth.clear_value = 1.0;
    const double start = start_of_cleared_code(with_less);
    if (!(start < params.projection.far)) return false;
    const glm::dvec4 towards_eye = glm::transpose(derived.view_from_world)[2];
    std::vector<glm::dvec4> forms;
    for (const glm::dvec4& side : forms_of_sides(derived.clip_from_world)) forms.push_back(side);
    forms.push_back(-towards_eye - glm::dvec4(0.0, 0.0, 0.0, start));
    forms.push_back(towards_eye + glm::dvec4(0.0, 0.0, 0.0, params.projection.far));
    const bool has_any = may_reach(scene, forms);
    forms.back().w += start - params.projection.far;
    forms.erase(forms.end() - 2);
    return has_any && !may_reach(scene, forms) &&
           std::none_of(derived.planes.begin(), derived.planes.end(),
                        [&](const DerivedPlane& plane) { return may_show(plane.patch, with_less, derived); });
}

bool may_show(const PlanePatch& patch, const Params& params, const Derived& derived) {
    const std::array<glm::dvec4, 4> sides = forms_of_sides(derived.clip_from_world);
    std::vector<glm::dvec4> forms(sides.begin(), sides.end());
    const glm::dvec4 towards_eye = glm::transpose(derived.view_from_world)[2];  // minus the eye distance
    const double start = std::min(start_of_cleared_code(params), params.projection.far);
    if (std::isfinite(start)) forms.push_back(towards_eye + glm::dvec4(0.0, 0.0, 0.0, start));
    forms.push_back(-towards_eye - glm::dvec4(0.0, 0.0, 0.0, params.projection.near));
    return may_reach(patch, forms);
}

bool loses_part(const PlanePatch& patch, const Params& params, const Derived& derived) {
    const double start = start_of_cleared_code(params);
    if (!(start < params.projection.far)) return false;
    Params beyond = params;
    beyond.projection.near = std::max(start, params.projection.near);
    beyond.depth.test = false;  // no code counts
    return may_show(patch, beyond, derived);
}

bool shows_anything(const glm::dmat4& clip_from_world, const Derived& derived, const Scene& scene) {
    const std::vector<glm::dvec4> frustum = forms_of_frustum(clip_from_world);
    return may_reach(scene, frustum) ||
           std::any_of(derived.planes.begin(), derived.planes.end(),
                       [&](const DerivedPlane& plane) { return may_reach(plane.patch, frustum); });
}

}  // namespace viewing
