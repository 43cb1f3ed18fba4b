// Declares each kind of field once: its name; its form, which reads a value, says what is allowed, and makes the
// schema; how a value is written; and how a value is clamped and blended. Code that needs a window or a
// random generator is elsewhere, with an overload for each type: ui/parts/controls.cpp draws the controls, and the
// tests' random_params.h makes random values.
#include <algorithm>
#include <cmath>
#include <limits>

#include "state/fields.h"
#include "state/file/beside.h"
#include "state/file/form.h"
#include "state/file/schema.h"
#include "text/numbers.h"
#include "text/words.h"

namespace viewing {
namespace {

using form::Form;

FieldRef default_ref(const Field& field) {
    static Params defaults;
    return field.in(defaults);
}

// ---- forms of parts ------------------------------------------------------------------------------------------------

std::string each_in_range(const Field& field) {
    return "each " + range_text(component_range(field, 0));
}

Form<int> whole(const Field& field) {
    return form::whole(static_cast<int>(field.min), static_cast<int>(field.max));
}

/// A list with one number for each component. `entries` has a form for each; its last form reads any further ones.
template <typename Vector, typename Entry>
Form<Vector> vector(const std::vector<Form<Entry>>& entries, const std::string& what) {
    constexpr auto length = static_cast<std::size_t>(Vector::length());
    return form::list(entries, what, {length, length, nullptr}).strict().then([](const std::vector<Entry>& values) {
        Vector vector;
        for (glm::length_t i = 0; i < Vector::length(); ++i) vector[i] = values[static_cast<std::size_t>(i)];
        return vector;
    });
}

/// Numbers, each in the range of its component.
template <typename Vector>
Form<Vector> components(const Field& field, const std::string& what) {
    std::vector<Form<double>> entries;
    for (int i = 0; i < Vector::length(); ++i) entries.push_back(form::number(component_range(field, i)));
    return vector<Vector>(entries, what);
}

/// Two numbers in the field's range.
Form<glm::dvec2> pair(const Field& field, const std::string& what) {
    return vector<glm::dvec2>(std::vector{form::number(component_range(field, 0))}, what);
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

Form<std::optional<glm::dmat4>> matrix(const Field& field) {
    const Range range = component_range(field, 0);
    const Json row = form::list_of(form::number_in(range), 4, 4), rows = form::list_of(row, 4, 4);
    return or_null<glm::dmat4>(
        {"null or 4 rows of 4 numbers, " + each_in_range(field),
         {},
         [range](const Json& value, const Where& where) { return read_matrix(value, where, range); },
         [rows](Json&) { return rows; }});
}

template <typename T, typename Write>
Json written(const std::optional<T>& value, const Write& write) {
    return value ? Json(write(*value)) : Json(nullptr);
}
template <typename Vector>
Json pair_as_json(const Vector& pair) {
    return {pair.x, pair.y};
}

// ---- clamping and blending of parts --------------------------------------------------------------------------------

double fixed(double value, double fallback, const Field& field, int component) {
    if (std::isnan(value)) return fallback;
    if (field.may_be_infinite && value > 0.0 && std::isinf(value)) return value;
    const Range range = component_range(field, component);
    const bool turns_on = field.unit == "°" && range.max >= 180.0;
    if (turns_on && std::isfinite(value) && (value < range.min || value > range.max))
        return std::remainder(value, 360.0);
    return std::clamp(value, range.min, range.max);
}

template <typename Vector>
void fix_vector(Vector& vector, const Vector& fallback, const Field& field) {
    for (int i = 0; i < Vector::length(); ++i) vector[i] = fixed(vector[i], fallback[i], field, i);
}

void fix_matrix(std::optional<glm::dmat4>& matrix, const Field& field) {
    for (int column = 0; matrix && column < 4; ++column) fix_vector((*matrix)[column], glm::dvec4(0.0), field);
}

double between(double a, double b, double share, const Field& field) {
    if (field.logarithmic && a > 0.0 && b > 0.0) return a * std::pow(b / a, share);
    return a + (b - a) * share;
}

// ---- the kinds -----------------------------------------------------------------------------------------------------

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

template <>
struct Kind<bool*> : AnyKind {
    static constexpr std::string_view type = "bool";
    static Form<bool> form(const Field&) { return form::boolean(); }
    static Json write(const bool* value) { return *value; }
};

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
struct Kind<EnumRef> : AnyKind {
    static constexpr std::string_view type = "enum";
    static Form<int> form(const Field& field) { return form::choice(std::get<EnumRef>(default_ref(field)).names); }
    static std::vector<std::string> names(const Field& field) {
        const auto all = std::get<EnumRef>(default_ref(field)).names;
        return {all.begin(), all.end()};
    }
    static void assign(const EnumRef& to, int index) { to.set(index); }
    static Json write(const EnumRef& value) { return value.names[static_cast<std::size_t>(value.index())]; }
};

template <>
struct Kind<SceneSource*> : AnyKind {
    static constexpr std::string_view type = "scene";
    static Form<SceneSource> form(const Field&) {
        const std::string what = "a scene's name, a path, or an object with \"objects\"";
        const auto read = [=](const Json& value, const Where& where) -> SceneSource {
            if (value.is_string()) return read_name(value, where);
            require_object(value, where, what);
            return read_scene(value, where);
        };
        return {what, {}, read, [](Json&) {
                    return Json{{"anyOf", Json::array({form::name_schema(), {{"$ref", "#/$defs/scene"}}})}};
                }};
    }
    static Json write(const SceneSource* value) {
        const auto* scene = std::get_if<SceneDescription>(value);
        return scene != nullptr ? scene_as_json(*scene) : Json(std::get<std::string>(*value));
    }
};

template <typename Element>
struct Kind<Further<Element>> : AnyKind {
    using List = Further<Element>;
    static constexpr std::string_view type = List::has_lights ? "lights" : "planes";
    static Form<std::vector<Element>> form(const Field&) {
        const std::string group(List::group);
        const auto list = form::list(
            element(), "an array of at most " + std::to_string(List::most) + " " + group + "s " + element_form(group),
            {List::most});
        return list.strict();
    }
    static void assign(const List& to, const std::vector<Element>& elements) {
        to.all->resize(1);
        to.all->insert(to.all->end(), elements.begin(), elements.end());
    }
    static Json write(const List& list) {
        Json array = Json::array();
        for (const Element& element : list.elements()) {
            Params params;
            params.*List::member = {element};
            Json& object = array.emplace_back(Json::object());
            for (const Field* field : fields_of(List::group))
                object[std::string(field->name())] = field_as_json(*field, params);
        }
        return array;
    }

private:
    /// Reads an element as the first one of a default state, so that fields that the element omits keep their defaults.
    static Form<Element> element() {
        const std::string group(List::group);
        const auto read = [group](const Json& object, const Where& where) {
            require_object(object, where, "a " + group + " " + element_form(group));
            std::vector<std::string> names;
            for (const Field* field : fields_of(group)) names.emplace_back(field->name());
            Params params;
            for (const auto& [key, value] : object.items()) {
                require_known_key(key, where, names);
                read_field(field(group + "." + key), params, value, where.key(key));
            }
            return (params.*List::member).front();
        };
        const auto schema = [group](Json&) {
            Json properties = Json::object();
            for (const Field* field : fields_of(group)) properties[std::string(field->name())] = field_schema(*field);
            return form::object_of(std::move(properties));
        };
        return {"", {}, read, schema};
    }
};

template <>
struct Kind<std::optional<glm::dmat4>*> : NumericKind {
    static constexpr std::string_view type = "matrix";
    static Form<std::optional<glm::dmat4>> form(const Field& field) { return matrix(field); }
    static Json write(const std::optional<glm::dmat4>* value) { return written(*value, matrix_as_json); }
    static void clamp(std::optional<glm::dmat4>* value, const std::optional<glm::dmat4>*, const Field& field) {
        fix_matrix(*value, field);
    }
};

template <>
struct Kind<FurtherOverrides> : AnyKind {
    using All = std::array<PlaneOverrides, most_planes>;
    static constexpr std::string_view type = "matrices";
    static Form<All> form(const Field& field) {
        const std::string what =
            "an array of {\"plane\", \"light\": whole numbers from 1, \"shadow_from_world\", \"mirror_from_world\": "
            "null or 4 rows of 4 numbers}";
        constexpr std::size_t most = most_planes * most_lights;
        const auto read = [=](const Json& value, const Where& where) {
            require_array(value, where, most, what);
            All all;
            for (std::size_t i = 0; i < value.size(); ++i) read_one(all, value[i], field, what, where.at(i));
            return all;
        };
        const Form<std::optional<glm::dmat4>> entry = matrix(field);
        const auto schema = [entry](Json& definitions) {
            return form::list_of(form::object_of({{"plane", form::whole_in(1, most_planes)},
                                                  {"light", form::whole_in(1, most_lights)},
                                                  {"shadow_from_world", entry.schema(definitions)},
                                                  {"mirror_from_world", entry.schema(definitions)}}),
                                 most);
        };
        return {what, {}, read, schema};
    }
    /// Leaves the first R and S unchanged, since they have their own fields.
    static void assign(const FurtherOverrides& to, All all) {
        all[0].mirrored_world_from_world = (*to.all)[0].mirrored_world_from_world;
        all[0].shadowed_world_from_world[0] = (*to.all)[0].shadowed_world_from_world[0];
        *to.all = all;
    }
    static Json write(const FurtherOverrides& overrides) {
        Json array = Json::array();
        for (std::size_t plane = 0; plane < most_planes; ++plane) {
            PlaneOverrides& of_plane = (*overrides.all)[plane];
            for (std::size_t light = 0; light < most_lights; ++light) {
                std::optional<glm::dmat4> shadow, mirror;
                if (plane > 0 || light > 0) shadow = of_plane.shadowed_world_from_world[light];
                if (plane > 0 && light == 0) mirror = of_plane.mirrored_world_from_world;
                if (shadow || mirror)
                    array.push_back({{"plane", plane + 1},
                                     {"light", light + 1},
                                     {"shadow_from_world", written(shadow, matrix_as_json)},
                                     {"mirror_from_world", written(mirror, matrix_as_json)}});
            }
        }
        return array;
    }
    static void clamp(const FurtherOverrides& value, const FurtherOverrides&, const Field& field) {
        for (PlaneOverrides& of_plane : *value.all) {
            fix_matrix(of_plane.mirrored_world_from_world, field);
            for (std::optional<glm::dmat4>& shadow : of_plane.shadowed_world_from_world) fix_matrix(shadow, field);
        }
    }

private:
    static void read_one(All& all, const Json& object, const Field& field, const std::string& must_be,
                         const Where& where) {
        static const std::vector<std::string> keys = {"plane", "light", "shadow_from_world", "mirror_from_world"};
        require_object(object, where, must_be);
        for (const auto& [key, value] : object.items()) require_known_key(key, where, keys);
        const auto index_of = [&](const char* key, std::size_t most) {
            const int number =
                object.contains(key) ? read_whole(object[key], where.key(key), 1, static_cast<int>(most)) : 1;
            return static_cast<std::size_t>(number - 1);
        };
        const std::size_t plane = index_of("plane", most_planes), light = index_of("light", most_lights);
        const auto read = [&](const char* key, std::optional<glm::dmat4>& to, bool has_own_field) {
            if (!object.contains(key) || object[key].is_null()) return;
            const Where inside = where.key(key);
            if (has_own_field) inside.refuse("for the first one, use overrides." + std::string(key));
            if (to) inside.refuse("is given twice for that plane and light");
            to = matrix(field).read(object[key], inside);
        };
        read("shadow_from_world", all[plane].shadowed_world_from_world[light], plane == 0 && light == 0);
        read("mirror_from_world", all[plane].mirrored_world_from_world, plane == 0);
    }
};

template <>
struct Kind<std::optional<Follow>*> : AnyKind {
    static constexpr std::string_view type = "follow";
    static Form<std::optional<Follow>> form(const Field& field) {
        const std::string what = "null, {\"object\": name, \"vertex\": whole number} or {\"point\": [x, y, z]}";
        const Form<glm::dvec3> point =
            form::vec3(component_range(field, 0), "three numbers [x, y, z], " + each_in_range(field));
        const Form<int> vertex = form::whole(0, 1'000'000'000);
        const auto read = [=](const Json& value, const Where& where) {
            static const std::vector<std::string> keys = {"object", "vertex", "point"};
            require_object(value, where, what);
            Follow follow;
            for (const auto& [key, member] : value.items()) {
                require_known_key(key, where, keys);
                if (key == "object")
                    follow.object = read_name(member, where.key(key));
                else if (key == "point")
                    follow.point = point.read(member, where.key(key));
                else
                    follow.vertex = vertex.read(member, where.key(key));
            }
            if (follow.point && value.size() > 1)
                where.refuse("has a point and a vertex: give either point or object and vertex");
            if (!follow.point && follow.object.empty())
                where.key("object").refuse("is missing: the name of an object of the scene, or point: [x, y, z]");
            return follow;
        };
        Form<std::optional<Follow>> form = or_null<Follow>({what, {}, read, {}});
        form.schema = [=](Json& definitions) -> Json {
            Json of_vertex = form::object_of({{"object", form::name_schema()}, {"vertex", vertex.schema(definitions)}});
            of_vertex["required"] = {"object"};
            Json of_point = form::object_of({{"point", point.schema(definitions)}});
            of_point["required"] = {"point"};
            return {{"anyOf", Json::array({{{"type", "null"}}, std::move(of_vertex), std::move(of_point)})}};
        };
        return form;
    }
    static Json write(const std::optional<Follow>* value) {
        return written(*value, [](const Follow& follow) -> Json {
            if (follow.point) return {{"point", vector_as_json(*follow.point)}};
            return {{"object", follow.object}, {"vertex", follow.vertex}};
        });
    }
    static void clamp(std::optional<Follow>* value, const std::optional<Follow>*, const Field& field) {
        if (!*value) return;
        (*value)->vertex = std::max((*value)->vertex, 0);
        if ((*value)->point) fix_vector(*(*value)->point, glm::dvec3(0.0), field);
    }
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

template <>
struct Kind<std::optional<Pin>*> : NumericKind {
    static constexpr std::string_view type = "pin";
    static Form<std::optional<Pin>> form(const Field& field) {
        const std::string range = range_text(component_range(field, 0));
        const std::string what = "null, {\"object\": name, \"at\": [u, v]} or only one of the two, u and v " + range;
        const Form<std::optional<glm::dvec2>> at = or_null(pair(field, "two numbers [u, v], " + each_in_range(field)));
        const auto read = [=](const Json& value, const Where& where) {
            static const std::vector<std::string> keys = {"object", "at"};
            require_object(value, where, what);
            Pin pin;
            for (const auto& [key, member] : value.items()) {
                require_known_key(key, where, keys);
                if (key == "object")
                    pin.object = read_name(member, where.key(key));
                else
                    pin.at = at.read(member, where.key(key));
            }
            if (pin == Pin{}) refuse_value(value, where, what);
            return pin;
        };
        const auto schema = [at](Json& definitions) {
            Json pin = form::object_of({{"object", form::name_schema()}, {"at", at.schema(definitions)}});
            pin["minProperties"] = 1;
            return pin;
        };
        return or_null<Pin>({what, {}, read, schema});
    }
    static Json write(const std::optional<Pin>* value) {
        return written(*value, [](const Pin& pin) {
            Json object = Json::object();
            if (!pin.object.empty()) object["object"] = pin.object;
            if (pin.at) object["at"] = pair_as_json(*pin.at);
            return object;
        });
    }
    static void clamp(std::optional<Pin>* value, const std::optional<Pin>*, const Field& field) {
        if (*value && (*value)->at) fix_vector(*(*value)->at, glm::dvec2(0.5), field);
        if (*value == Pin{}) value->reset();
    }
};

template <>
struct Kind<std::vector<std::string>*> : AnyKind {
    static constexpr std::string_view type = "names";
    static std::vector<std::string> names(const Field& field) {
        return field.names.empty() ? known_paths() : std::vector<std::string>(field.names.begin(), field.names.end());
    }
    static Form<std::vector<std::string>> form(const Field& field) {
        const std::string each = field.names.empty() ? "the path of a field or group" : "one of " + joined(field.names);
        const std::string what = "an array of different names, each " + each;
        const std::vector<std::string> allowed = names(field);
        const auto read = [=](const Json& value, const Where& where) {
            require_array(value, where, allowed.size(), what);
            std::vector<std::string> names;
            for (std::size_t i = 0; i < value.size(); ++i) {
                const std::string name = read_name(value[i], where.at(i));
                if (std::find(allowed.begin(), allowed.end(), name) == allowed.end())
                    where.at(i).refuse("must be " + each + ", got " + describe(value[i]) + suggestion(name, allowed));
                if (std::find(names.begin(), names.end(), name) != names.end())
                    where.at(i).refuse(describe(value[i]) + " appears twice in the list");
                names.push_back(name);
            }
            return names;
        };
        const auto schema = [allowed](Json&) {
            Json list = form::list_of({{"enum", allowed}}, allowed.size());
            list["uniqueItems"] = true;
            return list;
        };
        return {what, {}, read, schema};
    }
    static Json write(const std::vector<std::string>* value) { return *value; }
};

/// The differences of the second picture. Each setting must be valid by itself; beside_params() moves the resulting
/// values into their ranges.
template <>
struct Kind<Settings*> : AnyKind {
    static constexpr std::string_view type = "settings";
    static Form<Settings> form(const Field&) {
        const std::string what = "an object of paths and values, such as {\"depth.test\": false}";
        const auto read = [=](const Json& value, const Where& where) {
            require_object(value, where, what);
            Settings differences{read_settings(value, where)};
            for (const std::string& setting : differences.all) {
                const std::string path = setting.substr(0, setting.find('='));
                if (!may_differ_beside(path)) {
                    if (!find_field(path)) refuse_unknown({where.prefix + where.path + ": ", path});
                    where.key(path).refuse("is the same in both pictures");
                }
                applied({}, {&setting, 1}, where.prefix + where.path + ": ");
            }
            return differences;
        };
        return {what, {}, read, [](Json&) { return Json{{"type", "object"}}; }};
    }
    static Json write(const Settings* value) { return settings_as_json(value->all); }
};

/// Calls use(kind, ref) with the kind of a field and the reference to its value.
template <typename Use>
auto of_kind(const FieldRef& field, const Use& use) {
    return std::visit([&](const auto& ref) { return use(Kind<std::decay_t<decltype(ref)>>(), ref); }, field);
}

}  // namespace

std::string_view type_name(const Field& field) {
    return of_kind(default_ref(field), [](auto kind, const auto&) { return kind.type; });
}

bool has_range(const Field& field) {
    return of_kind(default_ref(field), [](auto kind, const auto&) { return kind.has_range; });
}

std::vector<std::string> allowed_names(const Field& field) {
    return of_kind(default_ref(field), [&](auto kind, const auto&) { return kind.names(field); });
}

std::string allowed_text(const Field& field) {
    return of_kind(default_ref(field), [&](auto kind, const auto&) { return kind.form(field).what; });
}

Json value_schema(const Field& field) {
    Json none;
    return of_kind(default_ref(field), [&](auto kind, const auto&) { return kind.form(field).schema(none); });
}

void read_field(const Field& field, Params& params, const Json& value, const Where& where, std::size_t element) {
    of_kind(field.in(params, element),
            [&](auto kind, const auto& to) { kind.assign(to, kind.form(field).read(value, where)); });
}

Json field_as_json(const Field& field, Params& params, std::size_t element) {
    return of_kind(field.in(params, element), [](auto kind, const auto& value) { return kind.write(value); });
}

void clamp_field(const Field& field, Params& params, std::size_t element) {
    const FieldRef fallback = default_ref(field);
    of_kind(field.in(params, element),
            [&]<typename Ref>(auto kind, const Ref& value) { kind.clamp(value, std::get<Ref>(fallback), field); });
}

void blend_field(const Field& field, Params& from, Params& to, double share, std::size_t element) {
    const FieldRef source = field.in(from, element);
    of_kind(field.in(to, element),
            [&]<typename Ref>(auto kind, const Ref& value) { kind.blend(std::get<Ref>(source), value, share, field); });
}

}  // namespace viewing
