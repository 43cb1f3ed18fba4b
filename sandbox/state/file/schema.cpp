#include "state/file/schema.h"

#include "state/file/form.h"

namespace viewing {
namespace {

using form::object_of;

/// Returns the properties with the titles in front.
Json with_titles(const Json& properties) {
    Json none;
    Json all = titles_form()(none)["properties"];
    all.update(properties);
    return all;
}

/// Adds camera.look_at, which excludes the fields that it replaces.
void add_look_at(Json& camera) {
    const Json point = value_schema(field("camera.position"));
    Json look_at = object_of({{"eye", point}, {"center", point}, {"up", point}});
    look_at["required"] = {"eye", "center"};
    look_at["description"] =
        "The camera as gluLookAt takes it, instead of position, yaw, pitch and roll. Files are written with angles.";
    camera["properties"]["look_at"] = std::move(look_at);
    for (const std::string_view path : fields_of_look_at())
        camera["allOf"].push_back({{"not", {{"required", {"look_at", field(path).name()}}}}});
}

/// Adds two rules: near is positive if the projection is not orthographic or depth is logarithmic; far is finite if the
/// projection is orthographic or depth is logarithmic.
void add_rules_of_range(Json& root) {
    const auto is = [](const char* group, const char* name, std::string_view value) -> Json {
        const Json inner = {{"properties", {{name, {{"const", value}}}}}, {"required", Json::array({name})}};
        return {{"properties", {{group, inner}}}, {"required", Json::array({group})}};
    };
    const Json finite = {{"properties", {{"projection", {{"properties", {{"far", {{"type", "number"}}}}}}}}}};
    const Json positive = {
        {"properties", {{"projection", {{"properties", {{"near", {{"minimum", least_positive_near}}}}}}}}}};
    const Json orthographic = {
        {"anyOf", Json::array({is("projection", "type", name_of(ProjectionType::orthographic)),
                               is("projection", "type", name_of(ProjectionType::orthographic_window))})}};
    const Json logarithmic = is("depth", "mapping", name_of(DepthMapping::logarithmic));
    root["allOf"] = Json::array({{{"if", orthographic}, {"then", finite}, {"else", positive}},
                                 {{"if", logarithmic}, {"then", positive}},
                                 {{"if", logarithmic}, {"then", finite}}});
}

/// Returns the schema of a state, with its titles or without.
Json whole_state(Json& definitions, bool has_titles) {
    Json root = object_of(Json::object());
    for (const Field& field : fields()) {
        Json* group = &root;
        std::string_view rest = field.path;
        for (std::size_t dot = rest.find('.'); dot != std::string_view::npos; dot = rest.find('.')) {
            Json& inner = (*group)["properties"][std::string(rest.substr(0, dot))];
            if (inner.is_null()) inner = object_of(Json::object());
            group = &inner;
            rest.remove_prefix(dot + 1);
        }
        (*group)["properties"][std::string(rest)] = field_schema(field);
    }
    add_look_at(root["properties"]["camera"]);
    add_rules_of_range(root);
    if (has_titles) root["properties"] = with_titles(root["properties"]);
    definitions["scene"] = scene_form()(definitions);
    return root;
}

}  // namespace

Json state_definition(Json& definitions) {
    const Json state = whole_state(definitions, true);
    return form::defined(definitions, "state", state);
}

Json state_without_titles(Json& definitions) {
    return whole_state(definitions, false);
}

Json field_schema(const Field& field) {
    Json schema = value_schema(field);
    Params defaults;
    schema["description"] = field.help;
    schema["default"] = field_as_json(field, defaults);
    return schema;
}

std::string state_schema() {
    return form::document("A state of Viewing Sandbox",
                          [](Json& definitions) { return whole_state(definitions, true); });
}

std::string scene_schema() {
    return form::document("A scene of Viewing Sandbox", [](Json& definitions) {
        Json scene = scene_form()(definitions);
        scene["properties"] = with_titles(scene["properties"]);
        return scene;
    });
}

}  // namespace viewing
