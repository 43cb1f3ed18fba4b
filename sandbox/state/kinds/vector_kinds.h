// The kinds with a fixed number of components: points, lights, planes, colors, pixels and pairs of depths.
#pragma once

#include "state/kinds/number_kinds.h"

namespace viewing::kinds {

/// A list with one number for each component. `entries` has a form for each; its last form reads any further ones.
template <typename Vector, typename Entry>
Form<Vector> vector(const std::vector<Form<Entry>>& entries, const std::string& what) {
    constexpr auto length = static_cast<std::size_t>(Vector::length());
    return form::list(entries, what, {length, length, nullptr}).strict().then([](const std::vector<Entry>& values) {
        Vector vector;
        for (glm::length_t i = 0; i < Vector::length(); ++i) vector[i] = values[i];
        return vector;
    });
}

/// Numbers, each in the range of its component.
template <typename Vector>
Form<Vector> components(const Field& field, const std::string& what) {
    std::vector<Form<double>> entries;
    entries.reserve(Vector::length());
    for (int i = 0; i < Vector::length(); ++i) entries.push_back(form::number(component_range(field, i)));
    return vector<Vector>(entries, what);
}

/// Two numbers in the field's range.
inline Form<glm::dvec2> pair(const Field& field, const std::string& what) {
    return vector<glm::dvec2>(std::vector{form::number(component_range(field, 0))}, what);
}

template <typename Vector>
Json pair_as_json(const Vector& pair) {
    return {pair.x, pair.y};
}

template <typename Vector>
void fix_vector(Vector& vector, const Vector& fallback, const Field& field) {
    for (int i = 0; i < Vector::length(); ++i) vector[i] = fixed(vector[i], fallback[i], field, i);
}

template <typename Vector>
struct VectorKind : NumericKind {
    static Json write(const Vector* value) { return vector_as_json(*value); }
    static void clamp(Vector* value, const Vector* fallback, const Field& field) {
        fix_vector(*value, *fallback, field);
    }
    static void blend(const Vector* from, Vector* to, double share, const Field& field) {
        for (glm::length_t i = 0; i < Vector::length(); ++i) (*to)[i] = between((*from)[i], (*to)[i], share, field);
    }
};

template <>
struct Kind<glm::dvec3*> : VectorKind<glm::dvec3> {
    static constexpr std::string_view type = "vec3";
    static Form<glm::dvec3> form(const Field& field) {
        return components<glm::dvec3>(field, "three numbers [x, y, z], " + each_in_range(field));
    }
};

/// A light (x, y, z, w) or a plane (a, b, c, d).
template <>
struct Kind<glm::dvec4*> : VectorKind<glm::dvec4> {
    static constexpr std::string_view type = "vec4";
    static Form<glm::dvec4> form(const Field& field) {
        const std::string range = range_text(component_range(field, 0));
        const std::string what = field.is_light ? "four numbers [x, y, z, w], x, y and z " + range + ", w from 0 to 1"
                                                : "four numbers [a, b, c, d], each " + range;
        return components<glm::dvec4>(field, what);
    }
    static void clamp(glm::dvec4* value, const glm::dvec4* fallback, const Field& field) {
        fix_vector(*value, *fallback, field);
        const double length = field.is_light ? glm::length(*value) : glm::length(glm::dvec3(*value));
        if (length < min_length) *value = {0.0, 1.0, 0.0, field.is_light ? 0.0 : value->w};
    }
};

template <>
struct Kind<Color*> : AnyKind {
    static constexpr std::string_view type = "color";
    static Form<Color> form(const Field&) { return form::color(); }
    static Json write(const Color* value) { return color_as_json(*value); }
};

template <>
struct Kind<std::optional<glm::dvec2>*> : NumericKind {
    static constexpr std::string_view type = "range";
    static Form<std::optional<glm::dvec2>> form(const Field& field) {
        const std::string what =
            "null or two numbers [nearest, farthest], " + each_in_range(field) + ", the first less than the second";
        const auto read = [what, numbers = pair(field, what).read](const Json& value, const Where& where) {
            const glm::dvec2 range = numbers(value, where);
            if (!(range.x < range.y)) refuse_value(value, where, what);
            return range;
        };
        return or_null<glm::dvec2>({what, {}, read, pair(field, what).schema});
    }
    static Json write(const std::optional<glm::dvec2>* value) { return written(*value, pair_as_json<glm::dvec2>); }
    static void clamp(std::optional<glm::dvec2>* value, const std::optional<glm::dvec2>*, const Field& field) {
        if (*value) fix_vector(**value, glm::dvec2(field.min, field.max), field);
        if (*value && !((*value)->x < (*value)->y)) value->reset();
    }
};

template <>
struct Kind<std::optional<glm::ivec2>*> : NumericKind {
    static constexpr std::string_view type = "pixel";
    static Form<std::optional<glm::ivec2>> form(const Field& field) {
        return or_null(
            vector<glm::ivec2>(std::vector{whole(field)}, "null or two whole numbers [x, y], " + each_in_range(field)));
    }
    static Json write(const std::optional<glm::ivec2>* value) { return written(*value, pair_as_json<glm::ivec2>); }
    static void clamp(std::optional<glm::ivec2>* value, const std::optional<glm::ivec2>*, const Field& field) {
        if (*value)
            **value =
                glm::clamp(**value, glm::ivec2(static_cast<int>(field.min)), glm::ivec2(static_cast<int>(field.max)));
    }
};

}  // namespace viewing::kinds
