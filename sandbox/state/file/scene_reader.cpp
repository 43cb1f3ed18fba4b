// Reads a scene's objects from a JSON tree, and writes them back.
#include <algorithm>
#include <cmath>
#include <unordered_set>

#include "state/file/form.h"
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

/// Returns the rule that only objects of this shape may have the key and, if `is_needed`, that they must have it.
form::Keys::Rule only_of(ShapeKind shape, const char* key, bool is_needed) {
    const std::string name(name_of(shape));
    const auto check = [=](const Json& object, const Where& where) {
        const auto names = names_of<ShapeKind>();
        const auto own =
            object.contains("shape") ? std::find(names.begin(), names.end(), object["shape"]) : names.end();
        if (own == names.end()) return;  // a missing or unknown shape is refused elsewhere
        if (*own != name && object.contains(key))
            where.key(key).refuse("belongs to the shape " + name + ", but this object is a " + *own);
        if (*own == name && !object.contains(key) && is_needed)
            where.key(key).refuse("is missing: a " + name + " needs it");
    };
    const Json is_shape = {{"properties", {{"shape", {{"const", name}}}}}};
    const Json has_key = {{"required", Json::array({key})}};
    return {check, {{"if", is_shape}, {"then", is_needed ? has_key : Json(true)}, {"else", {{"not", has_key}}}}};
}

form::Form<ObjectDescription> object_form() {
    const auto rotate = [](ObjectDescription& object, const glm::dvec3& angles) {
        object.rotation = {angles.x, angles.y, angles.z};
    };
    const auto scale_schema = [](Json&) {
        const Json factors = {form::number_in(scale_range), form::number_in({-scale_range.max, -scale_range.min})};
        return form::list_of({{"anyOf", factors}}, 3, 3);
    };
    const auto vertices_schema = [](Json&) {
        return form::list_of(form::list_of(form::number_in(position_range), 3, 3), 3, 3);
    };
    return form::Object<ObjectDescription>("an object {\"name\": …, \"shape\": …}")
        .required("name", form::name("every object needs a unique name"), &ObjectDescription::name)
        .required("shape", form::choice<ShapeKind>(names_of<ShapeKind>()), &ObjectDescription::shape)
        .optional("position", form::vec3(position_range, "three numbers [x, y, z]"), &ObjectDescription::position)
        .optional("rotation", form::vec3(angle_range, "three angles [yaw, pitch, roll] in degrees"), rotate)
        .optional("scale", form::Form<glm::dvec3>{"three factors", {}, read_scale, scale_schema},
                  &ObjectDescription::scale)
        .optional("color", form::color(), &ObjectDescription::color)
        .optional("decal", form::boolean(), &ObjectDescription::decal)
        .optional("vertices",
                  form::Form<std::array<glm::dvec3, 3>>{"three vertices", {}, read_vertices, vertices_schema},
                  &ObjectDescription::vertices)
        .optional("file", form::name(), &ObjectDescription::file)
        .optional(
            "crease_deg", form::number(crease_range),
            [](ObjectDescription & mesh) -> auto& { return mesh.reading.crease_deg; })
        .optional(
            "fit", form::boolean(), [](ObjectDescription & mesh) -> auto& { return mesh.reading.fit; })
        .optional("resolution", form::whole(1, max_resolution), &ObjectDescription::resolution)
        .rule(only_of(ShapeKind::triangle, "vertices", true))
        .rule(only_of(ShapeKind::mesh, "file", true))
        .rule(only_of(ShapeKind::mesh, "crease_deg", false))
        .rule(only_of(ShapeKind::mesh, "fit", false))
        .rule(only_of(ShapeKind::teapot, "resolution", false))
        .form();
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

form::Object<SceneDescription> scene_form() {
    const std::string objects = "an array of at most " + std::to_string(max_objects) + " objects";
    const auto have_own_names = [](const std::vector<ObjectDescription>& all, const Where& where) {
        std::unordered_set<std::string> names;
        for (std::size_t i = 0; i < all.size(); ++i)
            if (!names.insert(all[i].name).second)
                where.at(i).key("name").refuse("an earlier object is already called \"" + excerpt(all[i].name) + "\"");
    };
    const auto has_one = [](const Json& scene, const Where& where) {
        if (scene.contains("made_by") && scene.contains("objects"))
            where.key("made_by").refuse("the scene also lists objects: it must have either a formula or objects");
        if (!scene.contains("made_by") && !scene.contains("objects"))
            where.key("objects").refuse("is missing: the array of the scene's objects");
    };
    return form::Object<SceneDescription>("an object {\"objects\": […]}")
        .optional("objects", form::list(object_form(), objects, {max_objects}).then(have_own_names),
                  &SceneDescription::objects)
        .optional("made_by", form::choice<SceneFormula>(formulas), &SceneDescription::made_by)
        .rule({has_one, Json::parse(R"({"oneOf": [{"required": ["objects"]}, {"required": ["made_by"]}]})")});
}

SceneDescription read_scene(const Json& value, const Where& where) {
    static const form::Object<SceneDescription> scene = scene_form();
    return scene.read(value, where);
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
