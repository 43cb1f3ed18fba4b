#include "state/file/form.h"

namespace viewing::form {

// ---- parts of schemas ----------------------------------------------------------------------------------------------

Json number_in(const Range& range) {
    return {{"type", "number"}, {"minimum", range.min}, {"maximum", range.max}};
}

Json whole_in(double min, double max) {
    return {{"type", "integer"}, {"minimum", min}, {"maximum", max}};
}

Json one_of(std::span<const char* const> names) {
    return {{"enum", std::vector<std::string>(names.begin(), names.end())}};
}

Json object_of(Json properties) {
    return {{"type", "object"}, {"properties", std::move(properties)}, {"additionalProperties", false}};
}

Json list_of(Json items, std::size_t most, std::size_t least) {
    Json list = {{"type", "array"}, {"maxItems", most}};
    if (least > 0) list["minItems"] = least;
    if (!items.is_array()) items = Json::array({std::move(items)});
    if (most > items.size() || items.size() == 1) list["items"] = items.back();  // of those after the first ones
    if (items.size() > 1) list["prefixItems"] = std::move(items);
    return list;
}

Json defined(Json& definitions, const char* name, Json schema) {
    definitions[name] = std::move(schema);
    return {{"$ref", std::string("#/$defs/") + name}};
}

Json name_schema() {
    return {
        {"type", "string"}, {"minLength", 1}, {"maxLength", 1024}, {"not", {{"pattern", "[\\u0000-\\u001f\\u007f]"}}}};
}

std::string document(const char* title, const std::function<Json(Json& definitions)>& content) {
    Json whole = {{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", title}};
    Json definitions = Json::object();
    whole.update(content(definitions));
    if (!definitions.empty()) whole["$defs"] = std::move(definitions);
    return print_document(whole) + "\n";
}

// ---- plain values --------------------------------------------------------------------------------------------------

Form<std::string> name(const std::string& what) {
    return {what, &Json::is_string, read_name,
            [](Json& definitions) { return defined(definitions, "name", name_schema()); }};
}

Form<std::string> text(const std::string& what, std::size_t most_bytes) {
    const auto read = [=](const Json& value, const Where& where) {
        if (!value.is_string()) refuse_value(value, where, what);
        auto text = value.get<std::string>();
        if (text.size() > most_bytes) where.refuse("longer than " + std::to_string(most_bytes) + " bytes");
        return text;
    };
    return {what, &Json::is_string, read, [=](Json&) { return Json{{"type", "string"}, {"maxLength", most_bytes}}; }};
}

Form<bool> boolean() {
    return {"true or false", &Json::is_boolean, read_bool, [](Json&) { return Json{{"type", "boolean"}}; }};
}

Form<double> number(const Range& range) {
    return {"a number " + range_text(range), &Json::is_number,
            [range](const Json& value, const Where& where) { return read_number(value, where, range); },
            [range](Json&) { return number_in(range); }};
}

Form<int> whole(int min, int max) {
    return {"a whole number " + range_text({static_cast<double>(min), static_cast<double>(max)}), &Json::is_number,
            [=](const Json& value, const Where& where) { return read_whole(value, where, min, max); },
            [=](Json&) { return whole_in(min, max); }};
}

Form<Color> color() {
    return {"a color \"#rrggbb\"", &Json::is_string, read_color, [](Json&) {
                return Json{{"type", "string"}, {"pattern", "^#[0-9a-fA-F]{6}$"}};
            }};
}

Form<glm::dvec3> vec3(const Range& range, const std::string& what) {
    const auto read = [=](const Json& value, const Where& where) { return read_vec3(value, where, range, what); };
    return {what, &Json::is_array, read, [=](Json&) { return list_of(number_in(range), 3, 3); }};
}

Form<int> version() {
    const char* const what = "must be 1, the version of the format that this program reads";
    return {what, &Json::is_number,
            [=](const Json& value, const Where& where) {
                if (value != 1) where.refuse(what);
                return 1;
            },
            [](Json&) {
                return Json{{"const", 1}};
            }};
}

Form<std::vector<std::string>> settings() {
    return {"an object of paths and values", &Json::is_object, read_settings, [](Json& definitions) {
                return defined(definitions, "settings",
                               {{"$comment", "Only the program checks that the paths and values are those of a state."},
                                {"type", "object"},
                                {"propertyNames", {{"not", {{"pattern", "="}}}}}});
            }};
}

Form<std::vector<int>> slides() {
    return list(whole(1, 9999), "a list of slide numbers", {100});
}

Form<const Json*> value(const std::string& what, const std::function<Json(Json& definitions)>& schema) {
    return {what, {}, [](const Json& value, const Where&) { return &value; }, schema};
}

// ---- objects -------------------------------------------------------------------------------------------------------

bool Keys::knows(const std::string& key) const {
    return std::any_of(members.begin(), members.end(), [&](const Key& known) { return known.name == key; });
}

void Keys::check(const Json& object, const Where& where) const {
    std::vector<std::string> known;
    for (const Key& key : members) known.push_back(key.name);
    require_object(object, where, kind);
    where.part([&] { require_keys(object, where, known); });
    for (const Rule& rule : all_rules) where.part([&] { rule.check(object, where); });
}

const Json* Keys::found(const Json& object, const Key& key, const Where& where) {
    if (object.contains(key.name)) return &object[key.name];
    if (key.is_needed) where.key(key.name).refuse((key.what.starts_with("must be") ? "" : "is missing: ") + key.what);
    return nullptr;
}

Json Keys::operator()(Json& definitions) const {
    Json properties = Json::object(), needed = Json::array(), rules = Json::array();
    for (const Key& key : members) {
        properties[key.name] = key.schema(definitions);
        if (key.is_needed) needed.push_back(key.name);
    }
    for (const Rule& rule : all_rules) rules.push_back(rule.schema);
    Json schema = object_of(std::move(properties));
    if (!needed.empty()) schema["required"] = std::move(needed);
    if (!rules.empty()) schema["allOf"] = std::move(rules);
    return schema;
}

Keys::Rule Keys::one_of_keys(const Keyed& keys, bool is_needed) {
    std::string names;
    Json each = Json::array();
    for (const char* const key : keys) {
        names += (key == keys.front() ? "\"" : key == keys.back() ? " and \"" : ", \"") + std::string(key) + "\"";
        each.push_back({{"required", Json::array({key})}});
    }
    if (!is_needed) each.push_back({{"not", {{"anyOf", each}}}});
    const auto check = [=](const Json& object, const Where& where) {
        const auto is_there = [&](const char* key) { return object.contains(key); };
        const auto count = std::count_if(keys.begin(), keys.end(), is_there);
        if (count > 1 || (count == 0 && is_needed))
            where.refuse((is_needed ? "must have exactly one of " : "has more than one of ") + names);
    };
    return {check, {{"oneOf", std::move(each)}}};
}

Keys::Rule Keys::needed_by(const char* key, const char* needed) {
    return {[=](const Json& object, const Where& where) {
                if (object.contains(key) && !object.contains(needed))
                    where.key(key).refuse("needs \"" + std::string(needed) + "\"");
            },
            {{"dependentRequired", {{key, Json::array({needed})}}}}};
}

}  // namespace viewing::form
