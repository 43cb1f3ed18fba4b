// The kinds of numbers: whole ones and any others.
#pragma once

#include <limits>

#include "state/kinds/kind.h"

namespace viewing::kinds {

inline Form<int> whole(const Field& field) {
    return form::whole(static_cast<int>(field.min), static_cast<int>(field.max));
}

inline double between(double a, double b, double share, const Field& field) {
    if (field.logarithmic && a > 0.0 && b > 0.0) return a * std::pow(b / a, share);
    return a + (b - a) * share;
}

template <>
struct Kind<int*> : NumericKind {
    static constexpr std::string_view type = "int";
    static Form<int> form(const Field& field) {
        if (!field.only.empty()) return one_of(field.only);
        return field.min == field.max ? version(static_cast<int>(field.min)) : whole(field);
    }
    static Json write(const int* value) { return *value; }
    static void clamp(int* value, const int*, const Field& field) {
        *value = static_cast<int>(fixed(*value, 0.0, field, 0));
        const auto is_nearer = [given = *value](int a, int b) { return std::abs(a - given) < std::abs(b - given); };
        if (!field.only.empty()) *value = *std::min_element(field.only.rbegin(), field.only.rend(), is_nearer);
    }

private:
    static Form<int> one_of(std::span<const int> allowed) {
        std::string what;
        for (const int number : allowed) what += (what.empty() ? "" : " or ") + std::to_string(number);
        const auto read = [=](const Json& value, const Where& where) {
            const auto found = std::find_if(allowed.begin(), allowed.end(), [&](int one) { return value == one; });
            if (found == allowed.end()) refuse_value(value, where, what);
            return *found;
        };
        return {what, {}, read, [=](Json&) { return Json{{"enum", std::vector(allowed.begin(), allowed.end())}}; }};
    }
    static Form<int> version(int number) {
        const auto read = [=](const Json& value, const Where& where) {
            if (value != number)
                refuse_value(value, where, std::to_string(number) + ", the only version that this program reads");
            return number;
        };
        return {std::to_string(number), {}, read, [=](Json&) { return Json{{"const", number}}; }};
    }
};

template <>
struct Kind<double*> : NumericKind {
    static constexpr std::string_view type = "number";
    static Form<double> form(const Field& field) {
        const Range range = component_range(field, 0), above_zero{field.least_above_zero, field.max};
        const bool has_gap = field.least_above_zero > 0.0, may_be_infinite = field.may_be_infinite;
        const std::string what =
            (has_gap ? "0 or a number " + range_text(above_zero) : "a number " + range_text(range)) +
            (may_be_infinite ? ", or \"infinite\"" : "");
        const auto read = [=](const Json& value, const Where& where) {
            if (may_be_infinite && value == infinite) return std::numeric_limits<double>::infinity();
            const double number = read_number(value, where, range, may_be_infinite);
            if (number > 0.0 && number < above_zero.min) refuse_value(value, where, what);
            return number;
        };
        const auto schema = [=](Json&) -> Json {
            const Json number = form::number_in(has_gap ? above_zero : range);
            if (may_be_infinite) return {{"anyOf", Json::array({number, {{"const", infinite}}})}};
            return has_gap ? Json{{"anyOf", Json::array({{{"const", 0}}, number})}} : number;
        };
        return {what, {}, read, schema};
    }
    static Json write(const double* value) { return std::isinf(*value) ? Json(infinite) : Json(*value); }
    static void clamp(double* value, const double* fallback, const Field& field) {
        *value = fixed(*value, *fallback, field, 0);
        const double gap = field.least_above_zero;
        if (*value > 0.0 && *value < gap) *value = *value < gap / 2.0 ? 0.0 : gap;
    }
    static void blend(const double* from, double* to, double share, const Field& field) {
        *to = between(*from, *to, share, field);
    }
};

}  // namespace viewing::kinds
