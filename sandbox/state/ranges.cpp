// Applies the list of fields to values: ranges of components, descriptions of allowed values, and corrections of values
// that a control has dragged out of range.
#include <algorithm>
#include <cmath>
#include <sstream>
#include <type_traits>

#include "state/fields.h"
#include "state/overloaded.h"
#include "text/numbers.h"
#include "text/words.h"

namespace viewing {

namespace {

bool is_light(const Field& field) {
    return field.path == "light.position";
}
bool is_samples(const Field& field) {
    return field.path == "view.samples";
}

FieldRef default_ref(const Field& field) {
    static Params defaults;
    return field.in(defaults);
}

double fixed(double value, double fallback, const Field& field, int component) {
    if (std::isnan(value)) {
        return fallback;
    }
    if (field.may_be_infinite && value > 0.0 && std::isinf(value)) return value;
    const Range range = component_range(field, component);
    const bool turns_on = field.unit == "°" && range.max >= 180.0;
    if (turns_on && std::isfinite(value) && (value < range.min || value > range.max)) {
        return std::remainder(value, 360.0);
    }
    return std::clamp(value, range.min, range.max);
}

template <typename Vector>
void fix_vector(Vector& vector, const Vector& fallback, const Field& field) {
    for (int i = 0; i < Vector::length(); ++i) {
        vector[i] = fixed(vector[i], fallback[i], field, i);
    }
}

void fix_light(glm::dvec4& position) {
    if (glm::length(position) < min_length) {
        position = {0.0, 1.0, 0.0, 0.0};
    }
}

void fix_plane(glm::dvec4& equation) {
    if (glm::length(glm::dvec3(equation)) < min_length) {
        equation = {0.0, 1.0, 0.0, equation.w};
    }
}

void fix_matrix(std::optional<glm::dmat4>& matrix, const Field& field) {
    for (int i = 0; matrix && i < 16; ++i) {
        double& entry = (*matrix)[i / 4][i % 4];
        entry = fixed(entry, 0.0, field, i);
    }
}

void fix_span(std::optional<glm::dvec2>& span, const Field& field) {
    if (!span) {
        return;
    }
    fix_vector(*span, glm::dvec2(field.min, field.max), field);
    if (!(span->x < span->y)) {
        span.reset();
    }
}

/// Replaces a number in the gap above 0 with the nearer end of the gap.
void fix_gap(double& value, double least_above_zero) {
    if (value > 0.0 && value < least_above_zero) value = value < least_above_zero / 2.0 ? 0.0 : least_above_zero;
}

void fix_pin(std::optional<Pin>& pin, const Field& field) {
    if (!pin) return;
    if (pin->at) fix_vector(*pin->at, glm::dvec2(0.5), field);
    if (*pin == Pin{}) pin.reset();
}

/// Keeps `low` below `high`, and the two far enough apart for P to have an inverse.
void fix_edges(double& low, double& high) {
    const double least = least_window(low, high), limit = field("projection.left").max - least;
    if (high - low >= least) return;
    const double middle = std::clamp(0.5 * (low + high), -limit, limit);
    low = middle - least;
    high = middle + least;
}

/// Removes overrides for planes and lights that do not exist.
void fix_overrides(Params& params) {
    fix_matrix(params.camera_overrides.view_from_world, field("overrides.view_from_world"));
    fix_matrix(params.camera_overrides.clip_from_view, field("overrides.clip_from_view"));
    for (std::size_t plane = 0; plane < most_planes; ++plane) {
        PlaneOverrides& overrides = params.overrides[plane];
        if (plane >= params.planes.size()) {
            overrides = {};
        }
        fix_matrix(overrides.mirrored_world_from_world, field("overrides.mirror_from_world"));
        for (std::size_t light = 0; light < most_lights; ++light) {
            std::optional<glm::dmat4>& shadow = overrides.shadowed_world_from_world[light];
            if (light >= params.lights.size()) {
                shadow.reset();
            }
            fix_matrix(shadow, field("overrides.shadow_from_world"));
        }
    }
}

void fix_field(const Field& field, Params& params, std::size_t element) {
    const FieldRef fallback = default_ref(field);
    std::visit(Overloaded{
                   [&](int* value) {
                       *value = static_cast<int>(fixed(*value, 0.0, field, 0));
                       if (is_samples(field)) {
                           *value = *value >= 2 ? 4 : 0;
                       }
                   },
                   [&](double* value) {
                       *value = fixed(*value, *std::get<double*>(fallback), field, 0);
                       fix_gap(*value, field.least_above_zero);
                   },
                   [&](glm::dvec3* value) { fix_vector(*value, *std::get<glm::dvec3*>(fallback), field); },
                   [&](glm::dvec4* value) { fix_vector(*value, *std::get<glm::dvec4*>(fallback), field); },
                   [&](std::optional<glm::dvec2>* value) { fix_span(*value, field); },
                   [&](std::optional<glm::ivec2>* value) {
                       if (*value)
                           **value = glm::clamp(**value, glm::ivec2(static_cast<int>(field.min)),
                                                glm::ivec2(static_cast<int>(field.max)));
                   },
                   [&](std::optional<Pin>* value) { fix_pin(*value, field); },
                   [](auto&&) {},
               },
               field.in(params, element));
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
        const bool is_vector = std::holds_alternative<glm::dvec4*>(default_ref(*field));
        const std::string_view components = is_light(*field) ? ": [x, y, z, w]" : ": [a, b, c, d]";
        form += (form.empty() ? "\"" : ", \"") + std::string(field->name()) + "\"";
        form += is_vector ? components : "";
    }
    return "{" + form + "}";
}

std::string range_text(const Range& range) {
    return "from " + format_number(range.min) + " to " + format_number(range.max);
}

Range component_range(const Field& field, int component) {
    return is_light(field) && component == 3 ? Range{0.0, 1.0} : Range{field.min, field.max};
}

std::string_view type_name(const Field& field) {
    static constexpr std::string_view names[] = {"bool",   "int",   "number", "vec3",   "vec4",   "color",
                                                 "enum",   "scene", "lights", "planes", "matrix", "matrices",
                                                 "follow", "range", "pixel",  "pin",    "names",  "settings"};
    static_assert(std::size(names) == std::variant_size_v<FieldRef>);
    return names[default_ref(field).index()];
}

std::string allowed_name_text(const Field& field) {
    const std::vector<std::string> allowed = allowed_names(field);
    if (allowed == known_paths()) return "the path of a field or group";
    std::string all;
    for (const std::string& name : allowed) all += (all.empty() ? "one of " : ", ") + name;
    return all;
}

std::string allowed_text(const Field& field) {
    const std::string range = range_text({field.min, field.max});
    return std::visit(
        Overloaded{
            [](bool*) -> std::string { return "true or false"; },
            [&](int*) -> std::string {
                return is_samples(field)        ? "0 or 4"
                       : field.min == field.max ? format_number(field.min)
                                                : "a whole number " + range;
            },
            [&](double*) -> std::string {
                if (const double least = field.least_above_zero; least > 0.0)
                    return "0 or a number " + range_text({least, field.max});
                return "a number " + range + (field.may_be_infinite ? ", or \"infinite\"" : "");
            },
            [&](glm::dvec3*) -> std::string { return "three numbers [x, y, z], each " + range; },
            [&](glm::dvec4*) -> std::string {
                return is_light(field) ? "four numbers [x, y, z, w], x, y and z " + range + ", w from 0 to 1"
                                       : "four numbers [a, b, c, d], each " + range;
            },
            [](Color*) -> std::string { return "a color \"#rrggbb\""; },
            [](EnumRef choice) -> std::string { return "one of " + joined(choice.names); },
            [](SceneSource*) -> std::string { return "a scene's name, a path, or an object with \"objects\""; },
            []<typename Element>(Further<Element> list) -> std::string {
                return "an array of at most " + std::to_string(list.most) + " " + std::string(list.group) + "s " +
                       element_form(list.group);
            },
            [](std::optional<glm::dmat4>*) -> std::string {
                return "null or 4 rows of 4 numbers, each from -1e12 to 1e12";
            },
            [](FurtherOverrides) -> std::string {
                return "an array of {\"plane\", \"light\": whole numbers from 1, \"shadow_from_world\", "
                       "\"mirror_from_world\": null or 4 rows of 4 numbers}";
            },
            [](std::optional<Follow>*) -> std::string {
                return "null, {\"object\": name, \"vertex\": whole number} or {\"point\": [x, y, z]}";
            },
            [&](std::optional<glm::dvec2>*) -> std::string {
                return "null or two numbers [nearest, farthest], each " + range + ", the first less than the second";
            },
            [&](std::optional<glm::ivec2>*) -> std::string {
                return "null or two whole numbers [x, y], each " + range;
            },
            [&](std::optional<Pin>*) -> std::string {
                return "null, {\"object\": name, \"at\": [u, v]} or only one of the two, u and v " + range;
            },
            [&](std::vector<std::string>*) -> std::string {
                return "an array of different names, each " + allowed_name_text(field);
            },
            [](Settings*) -> std::string { return "an object of paths and values, such as {\"depth.test\": false}"; },
        },
        default_ref(field));
}

void clamp_to_ranges(Params& params) {
    params.lights.resize(std::clamp<std::size_t>(params.lights.size(), 1, most_lights));
    params.planes.resize(std::clamp<std::size_t>(params.planes.size(), 1, most_planes));
    for (const Field& field : fields()) {
        for (std::size_t element = 0; element < element_count(field, params); ++element) {
            fix_field(field, params, element);
        }
    }
    double& far = params.projection.far;
    if (std::isinf(far) && !may_have_infinite_far(params))
        far = *std::get<double*>(default_ref(field("projection.far")));
    params.projection.near = std::max(params.projection.near, least_near(params));
    if (params.projection.near >= far) far = params.projection.near * 1.01;
    fix_edges(params.projection.left, params.projection.right);
    fix_edges(params.projection.bottom, params.projection.top);
    for (LightParams& light : params.lights) {
        fix_light(light.position);
    }
    for (PlaneParams& plane : params.planes) {
        fix_plane(plane.equation);
    }
    fix_overrides(params);
    const Choice chosen = params.chosen();
    params.view.plane = static_cast<int>(chosen.plane + 1);
    params.view.light = static_cast<int>(chosen.light + 1);
    if (params.follow) {
        params.follow->vertex = std::max(params.follow->vertex, 0);
        const Field& range = field("follow");
        if (params.follow->point) fix_vector(*params.follow->point, glm::dvec3(0.0), range);
    }
}

}  // namespace viewing
