// Writes fields and whole states as a JSON tree; reader.cpp does the reverse.
#include <algorithm>
#include <cmath>

#include "state/file/reader.h"

namespace viewing {

namespace {

/// Writes a field as JSON, with one call operator for each alternative of FieldRef.
struct FieldWriter {
    Params& params;

    Json operator()(const bool* value) const { return *value; }
    Json operator()(const int* value) const { return *value; }
    Json operator()(const double* value) const { return std::isinf(*value) ? Json(infinite) : Json(*value); }
    Json operator()(const glm::dvec3* value) const { return vector_as_json(*value); }
    Json operator()(const glm::dvec4* value) const { return vector_as_json(*value); }
    Json operator()(const Color* value) const { return color_as_json(*value); }
    Json operator()(const EnumRef& value) const { return value.names[static_cast<std::size_t>(value.index())]; }
    Json operator()(const SceneSource* value) const {
        const auto* scene = std::get_if<SceneDescription>(value);
        return scene != nullptr ? scene_as_json(*scene) : Json(std::get<std::string>(*value));
    }
    template <typename Element>
    Json operator()(Further<Element> list) const {
        Json array = Json::array();
        for (std::size_t element = 1; element < list.all->size(); ++element) {
            Json object = Json::object();
            for (const Field* field : fields_of(list.group)) {
                object[std::string(field->name())] = field_as_json(*field, params, element);
            }
            array.push_back(std::move(object));
        }
        return array;
    }
    Json operator()(const std::optional<glm::dmat4>* matrix) const {
        return *matrix ? matrix_as_json(**matrix) : Json(nullptr);
    }
    Json operator()(FurtherOverrides overrides) const {
        Json array = Json::array();
        for (std::size_t plane = 0; plane < most_planes; ++plane) {
            PlaneOverrides& of_plane = (*overrides.all)[plane];
            for (std::size_t light = 0; light < most_lights; ++light) {
                std::optional<glm::dmat4> shadow = of_plane.shadowed_world_from_world[light], mirror;
                if (plane == 0 && light == 0) {
                    shadow.reset();
                }
                if (plane > 0 && light == 0) {
                    mirror = of_plane.mirrored_world_from_world;
                }
                if (shadow || mirror) {
                    array.push_back({{"plane", plane + 1},
                                     {"light", light + 1},
                                     {"shadow_from_world", (*this)(&shadow)},
                                     {"mirror_from_world", (*this)(&mirror)}});
                }
            }
        }
        return array;
    }
    Json operator()(const std::optional<Follow>* follow) const {
        if (!*follow) return nullptr;
        if ((*follow)->point) return Json{{"point", vector_as_json(*(*follow)->point)}};
        return {{"object", (*follow)->object}, {"vertex", (*follow)->vertex}};
    }
    Json operator()(const std::optional<glm::dvec2>* range) const {
        return *range ? Json{(*range)->x, (*range)->y} : Json(nullptr);
    }
    Json operator()(const std::optional<glm::ivec2>* pixel) const {
        return *pixel ? Json{(*pixel)->x, (*pixel)->y} : Json(nullptr);
    }
    Json operator()(const std::optional<Pin>* pin) const {
        if (!*pin) return nullptr;
        Json object = Json::object();
        if (!(*pin)->object.empty()) object["object"] = (*pin)->object;
        if ((*pin)->at) object["at"] = Json{(*pin)->at->x, (*pin)->at->y};
        return object;
    }
    Json operator()(const std::vector<std::string>* names) const { return *names; }
    Json operator()(const Settings* settings) const { return settings_as_json(settings->all); }
};

}  // namespace

Json field_as_json(const Field& field, Params& params, std::size_t element) {
    return std::visit(FieldWriter{params}, field.in(params, element));
}

Json params_as_document(Params params) {
    Json document = Json::object();
    for (const Field& field : fields()) {
        std::string pointer = "/" + std::string(field.path);
        std::replace(pointer.begin(), pointer.end(), '.', '/');
        document[Json::json_pointer(pointer)] = field_as_json(field, params);
    }
    return document;
}

}  // namespace viewing
