#include "state/file/schema.h"

#include "state/file/form.h"
#include "state/overloaded.h"

namespace viewing {
namespace {

using form::number_in, form::whole_in, form::one_of, form::object_of, form::list_of, form::name_schema;

Json exactly(std::size_t count, const Json& item) {
    return list_of(item, count, count);
}

Json null_or(Json schema) {
    return {{"anyOf", Json::array({{{"type", "null"}}, std::move(schema)})}};
}

Json matrix(const Range& range) {
    return null_or(exactly(4, exactly(4, number_in(range))));
}

template <typename Vector>
Json vector(const Field& field) {
    Json items = Json::array();
    for (int i = 0; i < Vector::length(); ++i) items.push_back(number_in(component_range(field, i)));
    return list_of(std::move(items), Vector::length(), Vector::length());
}

Json described(const Field& field);

/// Returns the schema of a list's element: an object with the fields of a group.
Json element(std::string_view group) {
    Json properties = Json::object();
    for (const Field* field : fields_of(group)) properties[std::string(field->name())] = described(*field);
    return object_of(std::move(properties));
}

Json further_override() {
    const Range entries = component_range(field("overrides.shadow_from_world"), 0);
    return object_of({{"plane", whole_in(1, most_planes)},
                      {"light", whole_in(1, most_lights)},
                      {"shadow_from_world", matrix(entries)},
                      {"mirror_from_world", matrix(entries)}});
}

Json of_type(const Field& field) {
    const Range range{field.min, field.max};
    Params defaults;
    return std::visit(
        Overloaded{
            [](bool*) -> Json {
                return {{"type", "boolean"}};
            },
            [&](int* value) -> Json {
                if (field.path == "view.samples") return {{"enum", {0, 4}}};
                if (range.min == range.max) return {{"const", *value}};
                return whole_in(range.min, range.max);
            },
            [&](double*) -> Json {
                if (field.may_be_infinite) return {{"anyOf", Json::array({number_in(range), {{"const", infinite}}})}};
                const double least = field.least_above_zero;
                if (least == 0.0) return number_in(range);
                return {{"anyOf", Json::array({{{"const", 0}}, number_in({least, range.max})})}};
            },
            [&](glm::dvec3*) { return vector<glm::dvec3>(field); },
            [&](glm::dvec4*) { return vector<glm::dvec4>(field); },
            [](Color*) { return form::color_schema(); },
            [](EnumRef choice) { return one_of(choice.names); },
            [](SceneSource*) -> Json {
                return {{"anyOf", Json::array({name_schema(), {{"$ref", "#/$defs/scene"}}})}};
            },
            []<typename Element>(Further<Element> list) { return list_of(element(list.group), list.most); },
            [&](std::optional<glm::dmat4>*) { return matrix(component_range(field, 0)); },
            [](FurtherOverrides) { return list_of(further_override(), most_planes * most_lights); },
            [&](std::optional<Follow>*) -> Json {
                Json vertex = object_of({{"object", name_schema()}, {"vertex", whole_in(0, 1'000'000'000)}});
                vertex["required"] = {"object"};
                Json point = object_of({{"point", exactly(3, number_in(range))}});
                point["required"] = {"point"};
                return {{"anyOf", Json::array({{{"type", "null"}}, std::move(vertex), std::move(point)})}};
            },
            [&](std::optional<glm::dvec2>*) { return null_or(exactly(2, number_in(range))); },
            [&](std::optional<glm::ivec2>*) { return null_or(exactly(2, whole_in(range.min, range.max))); },
            [&](std::optional<Pin>*) {
                Json pin = object_of({{"object", name_schema()}, {"at", null_or(exactly(2, number_in(range)))}});
                pin["minProperties"] = 1;
                return null_or(std::move(pin));
            },
            [&](std::vector<std::string>*) {
                const std::vector<std::string> allowed = allowed_names(field);
                Json names = list_of({{"enum", allowed}}, allowed.size());
                names["uniqueItems"] = true;
                return names;
            },
            [](Settings*) -> Json {
                return {{"type", "object"}};
            },
        },
        field.in(defaults));
}

Json described(const Field& field) {
    Json schema = of_type(field);
    Params defaults;
    schema["description"] = field.help;
    schema["default"] = field_as_json(field, defaults);
    return schema;
}

/// Returns the properties with the titles in front.
Json with_titles(const Json& properties) {
    Json all = Json::object();
    for (const char* key : {"$schema", "title", "about", "group", "mended_by"}) all[key] = {{"type", "string"}};
    Json none;
    all["slides"] = form::slides().schema(none);
    all.update(properties);
    return all;
}

/// Adds camera.look_at, which excludes the fields that it replaces.
void add_look_at(Json& camera) {
    const Json point = vector<glm::dvec3>(field("camera.position"));
    Json look_at = object_of({{"eye", point}, {"center", point}, {"up", point}});
    look_at["required"] = {"eye", "center"};
    look_at["description"] =
        "The camera as gluLookAt takes it, instead of position, yaw, pitch and roll. Files are written with angles.";
    camera["properties"]["look_at"] = std::move(look_at);
    for (const std::string_view path : fields_of_look_at())
        camera["allOf"].push_back({{"not", {{"required", {"look_at", field(path).name()}}}}});
}

/// Adds the rules that near is positive unless the projection is orthographic and depth is not logarithmic, and that
/// far is finite if the projection is orthographic or depth is logarithmic.
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
        (*group)["properties"][std::string(rest)] = described(field);
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
    return described(field);
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
