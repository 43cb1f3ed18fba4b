// The kinds that a file keeps as objects: the scene, further lights and planes, a followed point, a pinned one, and the
// settings of the second picture.
#pragma once

#include "state/file/beside.h"
#include "state/kinds/vector_kinds.h"

namespace viewing::kinds {

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
            const std::string prefix = group + ".";
            for (const auto& [key, value] : object.items()) {
                require_known_key(key, where, names);
                read_field(field(prefix + key), params, value, where.key(key));
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

}  // namespace viewing::kinds
