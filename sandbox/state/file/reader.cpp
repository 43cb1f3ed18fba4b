// Reads fields and groups of a state from a JSON tree, as defined by the list of fields. writer.cpp does the reverse.
#include "state/file/reader.h"

#include <algorithm>

#include "state/file/beside.h"
#include "state/file/form.h"
#include "text/numbers.h"
#include "text/words.h"

namespace viewing {

namespace {

constexpr std::string_view scene_must_be = "a scene's name, a path, or an object with \"objects\"";

std::string_view last_of(std::string_view path) {
    return path.substr(path.rfind('.') + 1);
}

template <typename Vector>
void read_vector(Vector& vector, const Field& field, const Json& value, const Where& where) {
    if (!value.is_array() || value.size() != static_cast<std::size_t>(Vector::length())) {
        refuse_value(value, where, allowed_text(field));
    }
    for (int i = 0; i < Vector::length(); ++i) {
        const auto index = static_cast<std::size_t>(i);
        vector[i] = read_number(value[index], where.at(index), component_range(field, i));
    }
}

glm::ivec2 read_pixel(const Json& value, const Field& field, const Where& where) {
    if (!value.is_array() || value.size() != 2) {
        refuse_value(value, where, allowed_text(field));
    }
    const auto whole = [&](std::size_t i) {
        return read_whole(value[i], where.at(i), static_cast<int>(field.min), static_cast<int>(field.max));
    };
    return {whole(0), whole(1)};
}

Follow read_follow(const Json& value, const Field& field, const Where& where) {
    static const std::vector<std::string> keys = {"object", "vertex", "point"};
    require_object(value, where, allowed_text(field));
    Follow follow;
    for (const auto& [key, member] : value.items()) {
        require_known_key(key, where, keys);
        if (key == "object") {
            follow.object = read_name(member, where.key(key));
        } else if (key == "point") {
            const Range range{field.min, field.max};
            follow.point =
                read_vec3(member, where.key(key), range, "three numbers [x, y, z], each " + range_text(range));
        } else {
            follow.vertex = read_whole(member, where.key(key), 0, 1'000'000'000);
        }
    }
    if (follow.point) {
        if (value.size() > 1) where.refuse("has a point and a vertex: give either point or object and vertex");
    } else if (follow.object.empty()) {
        where.key("object").refuse("is missing: the name of an object of the scene, or point: [x, y, z]");
    }
    return follow;
}

/// Reads a position in a picture as fractions of its width and height.
glm::dvec2 read_fraction(const Json& value, const Field& field, const Where& where) {
    if (!value.is_array() || value.size() != 2) {
        refuse_value(value, where, "two numbers [u, v], each " + range_text({field.min, field.max}));
    }
    glm::dvec2 fraction;
    for (int i = 0; i < 2; ++i) {
        const auto index = static_cast<std::size_t>(i);
        fraction[i] = read_number(value[index], where.at(index), {field.min, field.max});
    }
    return fraction;
}

Pin read_pin(const Json& value, const Field& field, const Where& where) {
    static const std::vector<std::string> keys = {"object", "at"};
    require_object(value, where, allowed_text(field));
    Pin pin;
    for (const auto& [key, member] : value.items()) {
        require_known_key(key, where, keys);
        if (key == "object") {
            pin.object = read_name(member, where.key(key));
        } else if (!member.is_null()) {
            pin.at = read_fraction(member, field, where.key(key));
        }
    }
    if (pin == Pin{}) {
        refuse_value(value, where, allowed_text(field));
    }
    return pin;
}

std::vector<std::string> read_names(const Json& value, const Field& field, const Where& where) {
    const std::vector<std::string> allowed = allowed_names(field);
    require_array(value, where, allowed.size(), allowed_text(field));
    std::vector<std::string> names;
    for (std::size_t i = 0; i < value.size(); ++i) {
        const std::string name = read_name(value[i], where.at(i));
        if (std::find(allowed.begin(), allowed.end(), name) == allowed.end()) {
            where.at(i).refuse("must be " + allowed_name_text(field) + ", got " + describe(value[i]) +
                               suggestion(name, allowed));
        }
        if (std::find(names.begin(), names.end(), name) != names.end()) {
            where.at(i).refuse(describe(value[i]) + " appears twice in the list");
        }
        names.push_back(name);
    }
    return names;
}

/// Reads the differences of the second picture. Each must be possible in some state; beside_params() makes them fit
/// the current state.
Settings read_differences(const Json& value, const Field& field, const Where& where) {
    require_object(value, where, allowed_text(field));
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
}

/// Reads one of the lights or planes of a list; fields that the object omits keep their defaults.
void read_element(std::string_view group, Params& params, std::size_t element, const Json& object, const Where& where) {
    std::vector<std::string> names;
    for (const Field* field : fields_of(group)) {
        names.emplace_back(field->name());
    }
    require_object(object, where, "a " + std::string(group) + " " + element_form(group));
    for (const auto& [key, value] : object.items()) {
        require_known_key(key, where, names);
        read_field(field(std::string(group) + "." + key), params, value, where.key(key), element);
    }
}

/// Reads an S or R that was entered by hand; refuses it if the same matrix was given before.
void read_override_matrix(std::optional<glm::dmat4>& matrix, const Json& value, const Field& field,
                          const Where& where) {
    if (value.is_null()) {
        return;
    }
    if (matrix) {
        where.refuse("is given twice for that plane and light");
    }
    matrix = read_matrix(value, where, component_range(field, 0));
}

/// Reads one element of overrides.further.
void read_override(std::array<PlaneOverrides, most_planes>& overrides, const Json& object, const std::string& must_be,
                   const Where& where) {
    static const std::vector<std::string> keys = {"plane", "light", "shadow_from_world", "mirror_from_world"};
    require_object(object, where, must_be);
    for (const auto& [key, value] : object.items()) {
        require_known_key(key, where, keys);
    }
    const auto index_of = [&](const char* key, std::size_t most) {
        const int number =
            object.contains(key) ? read_whole(object[key], where.key(key), 1, static_cast<int>(most)) : 1;
        return static_cast<std::size_t>(number - 1);
    };
    const std::size_t plane = index_of("plane", most_planes), light = index_of("light", most_lights);
    const auto read = [&](const char* key, std::optional<glm::dmat4>& matrix, bool has_own_field) {
        if (!object.contains(key)) {
            return;
        }
        const std::string path = std::string("overrides.") + key;
        if (has_own_field && !object[key].is_null()) {
            where.key(key).refuse("for the first one, use " + path);
        }
        read_override_matrix(matrix, object[key], field(path), where.key(key));
    };
    read("shadow_from_world", overrides[plane].shadowed_world_from_world[light], plane == 0 && light == 0);
    read("mirror_from_world", overrides[plane].mirrored_world_from_world, plane == 0);
}

/// Reads one JSON value into a field, with one call operator for each alternative of FieldRef.
struct FieldReader {
    const Field& field;
    Params& params;
    const Json& value;
    const Where& where;

    void operator()(bool* target) const { *target = read_bool(value, where); }
    void operator()(int* target) const {
        if (field.min == field.max && value != *target) {
            refuse_value(value, where, format_number(field.min) + ", the only version that this program reads");
        }
        if (field.path == "view.samples" && value != 0 && value != 4) {
            refuse_value(value, where, allowed_text(field));
        }
        *target = read_whole(value, where, static_cast<int>(field.min), static_cast<int>(field.max));
    }
    void operator()(double* target) const {
        if (field.may_be_infinite && value == infinite) {
            *target = std::numeric_limits<double>::infinity();
            return;
        }
        const double number = read_number(value, where, component_range(field, 0), field.may_be_infinite);
        if (number > 0.0 && number < field.least_above_zero) {
            refuse_value(value, where, allowed_text(field));
        }
        *target = number;
    }
    void operator()(glm::dvec3* target) const { read_vector(*target, field, value, where); }
    void operator()(glm::dvec4* target) const { read_vector(*target, field, value, where); }
    void operator()(Color* target) const { *target = read_color(value, where); }
    void operator()(EnumRef target) const { target.set(read_choice(value, where, target.names)); }
    void operator()(SceneSource* target) const {
        if (value.is_string()) {
            *target = read_name(value, where);
        } else {
            require_object(value, where, std::string(scene_must_be));
            *target = read_scene(value, where);
        }
    }
    template <typename Element>
    void operator()(Further<Element> list) const {
        require_array(value, where, list.most, allowed_text(field));
        list.all->resize(1);
        list.all->resize(1 + value.size());
        for (std::size_t i = 0; i < value.size(); ++i) {
            read_element(list.group, params, i + 1, value[i], where.at(i));
        }
    }
    void operator()(std::optional<glm::dmat4>* target) const {
        target->reset();
        if (!value.is_null()) {
            *target = read_matrix(value, where, component_range(field, 0));
        }
    }
    void operator()(FurtherOverrides overrides) const {
        require_array(value, where, most_planes * most_lights, allowed_text(field));
        for (std::size_t plane = 0; plane < most_planes; ++plane) {
            PlaneOverrides& cleared = (*overrides.all)[plane];
            if (plane > 0) {
                cleared.mirrored_world_from_world.reset();
            }
            for (std::size_t light = plane > 0 ? 0 : 1; light < most_lights; ++light) {
                cleared.shadowed_world_from_world[light].reset();
            }
        }
        for (std::size_t i = 0; i < value.size(); ++i) {
            read_override(*overrides.all, value[i], allowed_text(field), where.at(i));
        }
    }
    void operator()(std::optional<Follow>* target) const {
        target->reset();
        if (!value.is_null()) {
            *target = read_follow(value, field, where);
        }
    }
    void operator()(std::optional<glm::dvec2>* target) const {
        target->reset();
        if (!value.is_null()) {
            read_vector(target->emplace(), field, value, where);
            if (!((*target)->x < (*target)->y)) {
                refuse_value(value, where, allowed_text(field));
            }
        }
    }
    void operator()(std::optional<glm::ivec2>* target) const {
        target->reset();
        if (!value.is_null()) {
            *target = read_pixel(value, field, where);
        }
    }
    void operator()(std::optional<Pin>* target) const {
        target->reset();
        if (!value.is_null()) {
            *target = read_pin(value, field, where);
        }
    }
    void operator()(std::vector<std::string>* target) const { *target = read_names(value, field, where); }
    void operator()(Settings* target) const { *target = read_differences(value, field, where); }
};

}  // namespace

bool is_group(std::string_view path) {
    return std::any_of(fields().begin(), fields().end(), [path](const Field& field) {
        return field.path.size() > path.size() && is_in(field.path, path);
    });
}

void read_field(const Field& field, Params& params, const Json& value, const Where& where, std::size_t element) {
    std::visit(FieldReader{field, params, value, where}, field.in(params, element));
}

void read_group(Params& params, const Json& object, const Where& where) {
    require_object(object, where, "an object");
    if (where.path == "camera") require_one_camera(object, where);
    for (const auto& [key, value] : object.items()) {
        const Where inside = where.key(key);
        if (key.empty() || key.find('.') != std::string::npos) {
            inside.refuse("no such field: a key is a single name, and a group is a nested object");
        }
        if (const Field* known = find_field(inside.path)) {
            read_field(*known, params, value, inside);
        } else if (inside.path == look_at_path) {
            params.camera.look(read_look_at(value, inside));
        } else if (is_group(inside.path)) {
            read_group(params, value, inside);
        } else {
            refuse_unknown(inside);
        }
    }
}

void refuse_unknown(const Where& where) {
    std::vector<std::string> known = known_paths();
    for (const char* part : {"", ".eye", ".center", ".up"}) known.push_back(std::string(look_at_path) + part);
    const std::string_view word = last_of(where.path);
    // Handles both a typo anywhere in the path and a correct name in the wrong group.
    const auto distance = [&](const std::string& path) {
        return std::min(edit_distance(where.path, path), edit_distance(word, last_of(path)) + 1);
    };
    const auto nearest = std::min_element(known.begin(), known.end(), [&](const std::string& a, const std::string& b) {
        return distance(a) < distance(b);
    });
    if (is_near(distance(*nearest), word.size())) {
        where.refuse("no such field; did you mean " + *nearest + "?");
    }
    const std::string_view group = is_group(group_of(where.path)) ? group_of(where.path) : "";
    std::string all;
    for (const std::string& path : known) {
        if (group_of(path) == group) {
            all += (all.empty() ? "" : ", ") + std::string(last_of(path));
        }
    }
    where.refuse("no such field; " + (group.empty() ? "the fields are " : std::string(group) + " has ") + all);
}

std::vector<int> read_slides(const Json& object, const Where& where) {
    return object.contains("slides") ? form::slides().read(object["slides"], where.key("slides")) : std::vector<int>();
}

Titles take_titles(Json& document, const Where& where) {
    Titles titles;
    if (!document.is_object()) {
        return titles;
    }
    const auto take = [&](const char* key, std::string& text) {
        if (!document.contains(key)) {
            return;
        }
        if (!document[key].is_string()) {
            refuse_value(document[key], where.key(key), "a string");
        }
        text = document[key].get<std::string>();
        document.erase(key);
    };
    take("$schema", titles.schema);
    take("title", titles.title);
    take("about", titles.about);
    take("group", titles.group);
    take("mended_by", titles.fixed_by);
    titles.slides = read_slides(document, where);
    document.erase("slides");
    return titles;
}

}  // namespace viewing
