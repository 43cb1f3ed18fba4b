// Fields and whole states as a JSON tree; reader.cpp is the way back.
#include <algorithm>

#include "state/reader.h"

namespace viewing {

namespace {

/// What a field is, as JSON. One operator for each alternative of FieldRef.
struct FieldWriter {
    Json operator()(const bool* value) const { return *value; }
    Json operator()(const int* value) const { return *value; }
    Json operator()(const double* value) const { return *value; }
    Json operator()(const glm::dvec3* value) const { return vector_as_json(*value); }
    Json operator()(const glm::dvec4* value) const { return vector_as_json(*value); }
    Json operator()(const Color* value) const { return color_as_json(*value); }
    Json operator()(const EnumRef& value) const { return value.names[static_cast<std::size_t>(value.index())]; }
    Json operator()(const SceneSource* value) const {
        const auto* scene = std::get_if<SceneDescription>(value);
        return scene != nullptr ? scene_as_json(*scene) : Json(std::get<std::string>(*value));
    }
    Json operator()(const std::vector<LightParams>* lights) const {
        Json array = Json::array();
        for (const LightParams& light : *lights) {
            array.push_back({{"position", vector_as_json(light.position)}});
        }
        return array;
    }
    Json operator()(const std::vector<PlaneParams>* planes) const {
        Json array = Json::array();
        for (const PlaneParams& plane : *planes) {
            array.push_back({{"equation", vector_as_json(plane.equation)},
                             {"extent", plane.extent},
                             {"receives_shadow", plane.receives_shadow},
                             {"mirrors", plane.mirrors},
                             {"gloss", plane.gloss}});
        }
        return array;
    }
    Json operator()(const std::optional<glm::dmat4>* matrix) const {
        return *matrix ? matrix_as_json(**matrix) : Json(nullptr);
    }
    Json operator()(const std::optional<Follow>* follow) const {
        return *follow ? Json{{"object", (*follow)->object}, {"vertex", (*follow)->vertex}} : Json(nullptr);
    }
    Json operator()(const std::optional<glm::dvec2>* range) const {
        return *range ? Json{(*range)->x, (*range)->y} : Json(nullptr);
    }
    Json operator()(const std::optional<glm::ivec2>* pixel) const {
        return *pixel ? Json{(*pixel)->x, (*pixel)->y} : Json(nullptr);
    }
};

}  // namespace

Json field_as_json(const Field& field, Params& params) {
    return std::visit(FieldWriter{}, field.in(params));
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
