// Fields and groups of a state from a JSON tree; the list of fields says what there is. The way back is in writer.cpp.
#include "state/reader.h"

#include <algorithm>

#include "text/numbers.h"
#include "text/words.h"

namespace viewing {

namespace {

constexpr std::string_view scene_must_be = "a scene's name, a path, or an object with \"objects\"";

std::string_view parent_of(std::string_view path) {
    const std::size_t dot = path.rfind('.');
    return dot == std::string_view::npos ? "" : path.substr(0, dot);
}

std::string_view last_of(std::string_view path) {
    return path.substr(path.rfind('.') + 1);
}

/// The paths of all fields and all groups.
std::vector<std::string> known_paths() {
    std::vector<std::string> paths;
    for (const Field& field : fields()) {
        for (std::string_view path = field.path; !path.empty(); path = parent_of(path)) {
            if (std::find(paths.begin(), paths.end(), path) == paths.end()) {
                paths.emplace_back(path);
            }
        }
    }
    return paths;
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

LightParams read_light(const Json& value, const Where& where) {
    static const std::vector<std::string> keys = {"position"};
    require_object(value, where, "a light {\"position\": [x, y, z, w]}");
    LightParams light;
    for (const auto& [key, member] : value.items()) {
        require_known_key(key, where, keys);
        read_vector(light.position, field("light.position"), member, where.key(key));
    }
    return light;
}

PlaneParams read_plane(const Json& value, const Where& where) {
    static const std::vector<std::string> keys = {"equation", "extent", "receives_shadow", "mirrors", "gloss"};
    require_object(value, where, "a plane {\"equation\": [a, b, c, d], …}");
    PlaneParams plane;
    for (const auto& [key, member] : value.items()) {
        require_known_key(key, where, keys);
        const Where inside = where.key(key);
        if (key == "equation") {
            read_vector(plane.equation, field("plane.equation"), member, inside);
        } else if (key == "extent") {
            plane.extent = read_number(member, inside, component_range(field("plane.extent"), 0));
        } else {
            bool& flag = key == "mirrors" ? plane.mirrors : key == "gloss" ? plane.gloss : plane.receives_shadow;
            flag = read_bool(member, inside);
        }
    }
    return plane;
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
    static const std::vector<std::string> keys = {"object", "vertex"};
    require_object(value, where, allowed_text(field));
    Follow follow;
    for (const auto& [key, member] : value.items()) {
        require_known_key(key, where, keys);
        if (key == "object") {
            follow.object = read_name(member, where.key(key));
        } else {
            follow.vertex = read_whole(member, where.key(key), 0, 1'000'000'000);
        }
    }
    if (follow.object.empty()) {
        where.key("object").refuse("is missing: the name of an object of the scene");
    }
    return follow;
}

/// Reads one JSON value into whatever a field is. One operator for each alternative of FieldRef.
struct FieldReader {
    const Field& field;
    const Json& value;
    const Where& where;

    void operator()(bool* target) const { *target = read_bool(value, where); }
    void operator()(int* target) const {
        if (field.min == field.max && value != *target) {
            refuse_value(value, where, format_number(field.min) + ", the only one that this program reads");
        }
        if (field.path == "view.samples" && value != 0 && value != 4) {
            refuse_value(value, where, allowed_text(field));
        }
        *target = read_whole(value, where, static_cast<int>(field.min), static_cast<int>(field.max));
    }
    void operator()(double* target) const { *target = read_number(value, where, component_range(field, 0)); }
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
    void operator()(std::vector<LightParams>* target) const {
        require_array(value, where, max_further_lights, allowed_text(field));
        target->clear();
        for (std::size_t i = 0; i < value.size(); ++i) {
            target->push_back(read_light(value[i], where.at(i)));
        }
    }
    void operator()(std::vector<PlaneParams>* target) const {
        require_array(value, where, max_further_planes, allowed_text(field));
        target->clear();
        for (std::size_t i = 0; i < value.size(); ++i) {
            target->push_back(read_plane(value[i], where.at(i)));
        }
    }
    void operator()(std::optional<glm::dmat4>* target) const {
        target->reset();
        if (!value.is_null()) {
            *target = read_matrix(value, where, component_range(field, 0));
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
};

void check_light(const glm::dvec4& position, const Where& where) {
    if (glm::length(position) < min_length) {
        where.refuse("must not be zero: a point light has w = 1, a parallel light a direction");
    }
}

void check_plane(const glm::dvec4& equation, const Where& where) {
    if (glm::length(glm::dvec3(equation)) < min_length) {
        where.refuse("the normal (a, b, c) must not be zero");
    }
}

}  // namespace

bool is_group(std::string_view path) {
    return std::any_of(fields().begin(), fields().end(), [path](const Field& field) {
        return field.path.size() > path.size() && field.path.starts_with(path) && field.path[path.size()] == '.';
    });
}

void read_field(const Field& field, Params& params, const Json& value, const Where& where) {
    std::visit(FieldReader{field, value, where}, field.in(params));
}

void read_group(Params& params, const Json& object, const Where& where) {
    require_object(object, where, "an object");
    for (const auto& [key, value] : object.items()) {
        const Where inside = where.key(key);
        if (key.empty() || key.find('.') != std::string::npos) {
            inside.refuse("no such field: a key is one name, and groups are objects within objects");
        }
        if (const Field* known = find_field(inside.path)) {
            read_field(*known, params, value, inside);
        } else if (is_group(inside.path)) {
            read_group(params, value, inside);
        } else {
            refuse_unknown(inside);
        }
    }
}

void refuse_unknown(const Where& where) {
    const std::vector<std::string> known = known_paths();
    const std::string_view word = last_of(where.path);
    // A slip somewhere in the path, or the right word in the wrong group.
    const auto distance = [&](const std::string& path) {
        return std::min(edit_distance(where.path, path), edit_distance(word, last_of(path)) + 1);
    };
    const auto nearest = std::min_element(known.begin(), known.end(), [&](const std::string& a, const std::string& b) {
        return distance(a) < distance(b);
    });
    if (is_near(distance(*nearest), word.size())) {
        where.refuse("no such field; did you mean " + *nearest + "?");
    }
    const std::string_view group = is_group(parent_of(where.path)) ? parent_of(where.path) : "";
    std::string all;
    for (const std::string& path : known) {
        if (parent_of(path) == group) {
            all += (all.empty() ? "" : ", ") + std::string(last_of(path));
        }
    }
    where.refuse("no such field; " + (group.empty() ? "there are " : std::string(group) + " has ") + all);
}

void check_together(const Params& params, const std::string& prefix) {
    const Where root{prefix, ""};
    const auto [near, far] = std::pair(params.projection.near, params.projection.far);
    if (near >= far) {
        root.key("projection.near")
            .refuse("must be less than projection.far (" + format_number(far) + "), got " + format_number(near));
    }
    check_light(params.light.position, root.key("light.position"));
    for (std::size_t i = 0; i < params.lights.size(); ++i) {
        check_light(params.lights[i].position, root.key("lights").at(i).key("position"));
    }
    check_plane(params.plane.equation, root.key("plane.equation"));
    for (std::size_t i = 0; i < params.planes.size(); ++i) {
        check_plane(params.planes[i].equation, root.key("planes").at(i).key("equation"));
    }
}

void take_titles(Json& document, const Where& where) {
    for (const char* key : {"title", "about", "group"}) {
        if (!document.is_object() || !document.contains(key)) {
            continue;
        }
        if (!document[key].is_string()) {
            refuse_value(document[key], where.key(key), "a text");
        }
        document.erase(key);
    }
}

}  // namespace viewing
