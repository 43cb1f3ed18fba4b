// Reads a scene's objects from a JSON tree, and writes them back.
#include <algorithm>
#include <cmath>
#include <unordered_set>

#include "state/file/reader.h"
#include "state/file/scene_limits.h"
#include "text/words.h"

namespace viewing {

namespace {

glm::dvec3 read_scale(const Json& value, const Where& where) {
    const glm::dvec3 scale = read_vec3(value, where, {-scale_range.max, scale_range.max}, "three factors [x, y, z]");
    for (int i = 0; i < 3; ++i) {
        const auto index = static_cast<std::size_t>(i);
        if (std::abs(scale[i]) < scale_range.min) {
            refuse_value(value[index], where.at(index),
                         scale[i] == 0.0 ? "nonzero: 0 would flatten the object" : "at least 1e-6 in magnitude");
        }
    }
    return scale;
}

std::array<glm::dvec3, 3> read_vertices(const Json& value, const Where& where) {
    if (!value.is_array() || value.size() != 3) {
        refuse_value(value, where, "three vertices [[x, y, z], [x, y, z], [x, y, z]]");
    }
    std::array<glm::dvec3, 3> vertices;
    for (std::size_t i = 0; i < 3; ++i) {
        vertices[i] = read_vec3(value[i], where.at(i), position_range, "a vertex [x, y, z]");
    }
    // Use the vertices as the mesh stores them: rounded to single precision.
    const auto rounded = [&vertices](std::size_t i) { return glm::dvec3{glm::vec3{vertices[i]}}; };
    const glm::dvec3 ab = rounded(1) - rounded(0);
    const glm::dvec3 ac = rounded(2) - rounded(0);
    const double longest_squared = std::max(glm::dot(ab, ab), glm::dot(ac, ac));
    if (!(glm::length(glm::cross(ab, ac)) > 1e-9 * longest_squared)) {
        where.refuse("the triangle has no area: its vertices must not lie on one line");
    }
    return vertices;
}

/// Refuses an object with a field that belongs to another shape, or without a field that its shape needs.
void require_shape(const ObjectDescription& object, ShapeKind shape, const Json& value, const Where& where,
                   const char* key, bool is_needed) {
    if (object.shape != shape && value.contains(key)) {
        where.key(key).refuse("belongs to the shape " + std::string(name_of(shape)) + ", but this object is a " +
                              std::string(name_of(object.shape)));
    }
    if (object.shape == shape && !value.contains(key) && is_needed) {
        where.key(key).refuse("is missing: a " + std::string(name_of(shape)) + " needs it");
    }
}

void read_member(ObjectDescription& object, const std::string& key, const Json& value, const Where& where) {
    if (key == "name") {
        object.name = read_name(value, where);
    } else if (key == "shape") {
        object.shape = static_cast<ShapeKind>(read_choice(value, where, names_of<ShapeKind>()));
    } else if (key == "position") {
        object.position = read_vec3(value, where, position_range, "three numbers [x, y, z]");
    } else if (key == "rotation") {
        const glm::dvec3 angles = read_vec3(value, where, angle_range, "three angles [yaw, pitch, roll] in degrees");
        object.rotation = {angles.x, angles.y, angles.z};
    } else if (key == "scale") {
        object.scale = read_scale(value, where);
    } else if (key == "color") {
        object.color = read_color(value, where);
    } else if (key == "decal") {
        object.decal = read_bool(value, where);
    } else if (key == "vertices") {
        object.vertices = read_vertices(value, where);
    } else if (key == "file") {
        object.file = read_name(value, where);
    } else if (key == "crease_deg") {
        object.reading.crease_deg = read_number(value, where, crease_range);
    } else if (key == "fit") {
        object.reading.fit = read_bool(value, where);
    } else {
        object.resolution = read_whole(value, where, 1, max_resolution);
    }
}

ObjectDescription read_object(const Json& value, const Where& where) {
    static const std::vector<std::string> keys = {"name",  "shape",    "position", "rotation",   "scale", "color",
                                                  "decal", "vertices", "file",     "crease_deg", "fit",   "resolution"};
    require_object(value, where, "an object {\"name\": …, \"shape\": …}");
    ObjectDescription object;
    for (const auto& [key, member] : value.items()) {
        require_known_key(key, where, keys);
        read_member(object, key, member, where.key(key));
    }
    if (object.name.empty()) {
        where.key("name").refuse("is missing: every object needs a unique name");
    }
    if (!value.contains("shape")) {
        where.key("shape").refuse("is missing: one of " + joined(names_of<ShapeKind>()));
    }
    require_shape(object, ShapeKind::triangle, value, where, "vertices", true);
    require_shape(object, ShapeKind::mesh, value, where, "file", true);
    require_shape(object, ShapeKind::mesh, value, where, "crease_deg", false);
    require_shape(object, ShapeKind::mesh, value, where, "fit", false);
    require_shape(object, ShapeKind::teapot, value, where, "resolution", false);
    return object;
}

Json object_as_json(const ObjectDescription& object) {
    const Angles& rotation = object.rotation;
    Json json = {{"name", object.name},
                 {"shape", name_of(object.shape)},
                 {"position", vector_as_json(object.position)},
                 {"rotation", {rotation.yaw_deg, rotation.pitch_deg, rotation.roll_deg}},
                 {"scale", vector_as_json(object.scale)},
                 {"color", color_as_json(object.color)}};
    if (object.decal) {
        json["decal"] = true;
    }
    if (object.shape == ShapeKind::triangle) {
        json["vertices"] = Json::array();
        for (const glm::dvec3& vertex : object.vertices) {
            json["vertices"].push_back(vector_as_json(vertex));
        }
    } else if (object.shape == ShapeKind::mesh) {
        json["file"] = object.file;
        json["crease_deg"] = object.reading.crease_deg;
        json["fit"] = object.reading.fit;
    } else if (object.shape == ShapeKind::teapot) {
        json["resolution"] = object.resolution;
    }
    return json;
}

}  // namespace

SceneDescription read_scene(const Json& value, const Where& where) {
    static const std::vector<std::string> keys = {"objects", "made_by"};
    require_object(value, where, "an object {\"objects\": […]}");
    for (const auto& item : value.items()) {
        require_known_key(item.key(), where, keys);
    }
    const Where where_objects = where.key("objects");
    if (value.contains("made_by")) {
        const Where where_formula = where.key("made_by");
        const int formula = read_choice(value["made_by"], where_formula, formulas);
        if (value.contains("objects")) {
            where_formula.refuse("the scene also lists objects: it must have either a formula or objects");
        }
        return {{}, static_cast<SceneFormula>(formula)};
    }
    if (!value.contains("objects")) {
        where_objects.refuse("is missing: the array of the scene's objects");
    }
    const Json& objects = value["objects"];
    require_array(objects, where_objects, max_objects,
                  "an array of at most " + std::to_string(max_objects) + " objects");

    SceneDescription scene;
    std::unordered_set<std::string> names;
    for (std::size_t i = 0; i < objects.size(); ++i) {
        scene.objects.push_back(read_object(objects[i], where_objects.at(i)));
        if (!names.insert(scene.objects.back().name).second) {
            where_objects.at(i).key("name").refuse("an earlier object is already called \"" +
                                                   excerpt(scene.objects.back().name) + "\"");
        }
    }
    return scene;
}

Json scene_as_json(const SceneDescription& scene) {
    if (scene.made_by) {
        return {{"made_by", formulas[static_cast<std::size_t>(*scene.made_by)]}};
    }
    Json objects = Json::array();
    for (const ObjectDescription& object : scene.objects) {
        objects.push_back(object_as_json(object));
    }
    return {{"objects", objects}};
}

}  // namespace viewing
