// What all kinds of field share: the members that a kind may leave out, a value that may be null, and the correction of
// a number. See kinds.cpp.
#pragma once

#include <algorithm>
#include <cmath>

#include "state/fields.h"
#include "state/file/form.h"
#include "state/file/schema.h"

namespace viewing::kinds {

using form::Form;

/// The defaults of all kinds; a kind hides those that it replaces.
struct AnyKind {
    static constexpr bool has_range = false;  ///< whether the JSON of `params` gives the field's range
    template <typename T, typename V>
    static void assign(T* to, V value) {
        *to = std::move(value);
    }
    static std::vector<std::string> names(const Field&) { return {}; }
    template <typename Ref>
    static void clamp(const Ref&, const Ref&, const Field&) {}
    template <typename Ref>
    static void blend(const Ref&, const Ref&, double, const Field&) {}
};
struct NumericKind : AnyKind {
    static constexpr bool has_range = true;
};

/// The kind of the fields whose FieldRef holds a `Ref`.
template <typename Ref>
struct Kind;

inline FieldRef default_ref(const Field& field) {
    static Params defaults;
    return field.in(defaults);
}

inline std::string each_in_range(const Field& field) {
    return "each " + range_text(component_range(field, 0));
}

/// Null, or a value of `form`. The text form.what must already mention null.
template <typename V>
Form<std::optional<V>> or_null(const Form<V>& form) {
    const auto read = [read = form.read](const Json& value, const Where& where) {
        return value.is_null() ? std::nullopt : std::optional<V>(read(value, where));
    };
    const auto schema = [schema = form.schema](Json& definitions) {
        return Json{{"anyOf", Json::array({{{"type", "null"}}, schema(definitions)})}};
    };
    return {form.what, {}, read, schema};
}

template <typename T, typename Write>
Json written(const std::optional<T>& value, const Write& write) {
    return value ? Json(write(*value)) : Json(nullptr);
}

inline double fixed(double value, double fallback, const Field& field, int component) {
    if (std::isnan(value)) return fallback;
    if (field.may_be_infinite && value > 0.0 && std::isinf(value)) return value;
    const Range range = component_range(field, component);
    const bool turns_on = field.unit == "°" && range.max >= 180.0;
    if (turns_on && std::isfinite(value) && (value < range.min || value > range.max))
        return std::remainder(value, 360.0);
    return std::clamp(value, range.min, range.max);
}

}  // namespace viewing::kinds
