// Applies the list of fields to whole states: ranges of components, and corrections of values that a control has
// dragged out of range.
#include <algorithm>
#include <cmath>

#include "state/fields.h"
#include "text/numbers.h"

namespace viewing {

namespace {

/// Keeps `low` below `high`, and the two far enough apart for P to have an inverse.
void fix_edges(double& low, double& high) {
    const double least = least_window(low, high), limit = window_limit - least;
    if (high - low >= least) return;
    const double middle = std::clamp(0.5 * (low + high), -limit, limit);
    low = middle - least;
    high = middle + least;
}

/// Removes overrides for planes and lights that do not exist.
void fix_overrides(Params& params) {
    for (std::size_t plane = 0; plane < most_planes; ++plane) {
        PlaneOverrides& overrides = params.overrides[plane];
        if (plane >= params.planes.size()) overrides = {};
        for (std::size_t light = params.lights.size(); light < most_lights; ++light)
            overrides.shadowed_world_from_world[light].reset();
    }
}

}  // namespace

double least_near(const Params& params) {
    const bool divides = !params.projection.is_orthographic();
    return divides || params.depth.mapping == DepthMapping::logarithmic ? least_positive_near
                                                                        : field("projection.near").min;
}

bool may_have_infinite_far(const Params& params) {
    return !params.projection.is_orthographic() && params.depth.mapping != DepthMapping::logarithmic;
}

double least_window(double low, double high) {
    return 1e-9 * std::max({1.0, std::abs(low), std::abs(high)});
}

std::string element_form(std::string_view group) {
    std::string form;
    for (const Field* field : fields_of(group)) {
        const std::string_view components = field->is_light ? ": [x, y, z, w]" : ": [a, b, c, d]";
        form += (form.empty() ? "\"" : ", \"") + std::string(field->name()) + "\"";
        form += type_name(*field) == "vec4" ? components : "";
    }
    return "{" + form + "}";
}

std::string range_text(const Range& range) {
    return "from " + format_number(range.min) + " to " + format_number(range.max);
}

Range component_range(const Field& field, int component) {
    return field.is_light && component == 3 ? Range{0.0, 1.0} : Range{field.min, field.max};
}

void clamp_to_ranges(Params& params) {
    params.lights.resize(std::clamp<std::size_t>(params.lights.size(), 1, most_lights));
    params.planes.resize(std::clamp<std::size_t>(params.planes.size(), 1, most_planes));
    for (const Field& field : fields()) {
        for (std::size_t element = 0; element < element_count(field, params); ++element) {
            clamp_field(field, params, element);
        }
    }
    double& far = params.projection.far;
    if (std::isinf(far) && !may_have_infinite_far(params)) far = ProjectionParams().far;
    params.projection.near = std::max(params.projection.near, least_near(params));
    if (params.projection.near >= far) far = params.projection.near * 1.01;
    fix_edges(params.projection.left, params.projection.right);
    fix_edges(params.projection.bottom, params.projection.top);
    fix_overrides(params);
    const Choice chosen = params.chosen();
    params.view.plane = static_cast<int>(chosen.plane + 1);
    params.view.light = static_cast<int>(chosen.light + 1);
}

}  // namespace viewing
