#include "suite/schema.h"

#include "app/picture.h"
#include "image/compare.h"
#include "state/file/document.h"
#include "suite/form.h"

namespace viewing {
namespace {

namespace form = suite_form;

/// The settings of an entry, or of all entries in "defaults", as suite_reader.cpp reads them. Limits and lists of names
/// are from form.h.
constexpr const char* settings = R"({
  "set": {"anyOf": [{"type": "object"}, {"$ref": "#/$defs/settings"}]},
  "size": {"type": "array", "items": {"$ref": "#/$defs/side"}, "minItems": 2, "maxItems": 2},
  "samples": {"enum": [0, 4, "state"]},
  "picture": {"type": "boolean"},
  "share": {"type": "number", "minimum": 0, "maximum": 1},
  "matrices": {"anyOf": [{"type": "boolean"}, {"type": "object", "properties": {"tolerance": {"$ref": "#/$defs/tolerance"}},
    "additionalProperties": false}]},
  "problems": {"type": "object", "properties": {"must": {"$ref": "#/$defs/names"}, "must_not": {"$ref": "#/$defs/names"},
    "none": {"type": "boolean"}}, "additionalProperties": false,
    "not": {"properties": {"none": {"const": true}, "must": {"minItems": 1}}, "required": ["none", "must"]}}
})";

constexpr const char* definitions = R"({
  "name": {"type": "string", "minLength": 1, "maxLength": 1024, "pattern": "^[^\\u0000-\\u001f\\u007f]*$"},
  "measure": {"anyOf": [{"$ref": "#/$defs/quantity"}, {"type": "object", "properties":
    {"what": {"$ref": "#/$defs/quantity"}, "tolerance": {"$ref": "#/$defs/tolerance"}}, "required": ["what"],
    "additionalProperties": false}]}
})";

constexpr const char* subject = R"({
  "name": {"$ref": "#/$defs/name"}, "about": {"$ref": "#/$defs/name"},
  "state": {"anyOf": [{"$ref": "#/$defs/name", "not": {"const": "-"}}, {"type": "object"}]},
  "lesson": {"$ref": "#/$defs/name"},
  "revealed": {"type": "boolean"}, "present": {"type": "boolean"},
  "exercise": {"$ref": "#/$defs/name"}, "course": {"$ref": "#/$defs/name"}, "student": {"$ref": "#/$defs/name"}
})";

constexpr const char* each = R"({
  "name": {"$ref": "#/$defs/name", "pattern": "\\{\\}"},
  "about": {"$ref": "#/$defs/name"}, "except": {"$ref": "#/$defs/names"}
})";

Json whole_number(int least, int most) {
    return {{"type", "integer"}, {"minimum", least}, {"maximum", most}};
}

Json list_of(const Json& items, std::size_t most) {
    return {{"type", "array"}, {"items", items}, {"maxItems", most}};
}

Json reference_to(const std::string& definition) {
    return {{"$ref", "#/$defs/" + definition}};
}

/// Returns the settings with the limits from form.h.
Json all_settings() {
    Json all = Json::parse(settings);
    all["view"] = {{"enum", picture_view_names}};
    all["profile"] = {{"enum", profile_names}};
    all["worst"] = whole_number(0, form::most_worst);
    all["reach"] = whole_number(0, form::most_reach_px);
    const Json place = whole_number(0, largest_image_side), side = reference_to("side");
    const Json rectangle = {
        {"type", "array"}, {"prefixItems", Json::array({place, place, side, side})}, {"minItems", 4}, {"maxItems", 4}};
    all["masks"] = list_of({{"anyOf", Json::array({reference_to("name"), rectangle})}}, form::most_masks);
    const Json measure = reference_to("measure");
    all["measure"] = {{"anyOf", Json::array({measure, list_of(measure, form::measure_names.size())})}};
    return all;
}

Json all_definitions() {
    Json all = Json::parse(definitions);
    all["names"] = list_of(reference_to("name"), form::most_names);
    all["settings"] = list_of({{"$ref", "#/$defs/name"}, {"pattern", "="}}, form::most_settings);
    all["side"] = whole_number(1, largest_image_side);
    all["tolerance"] = {{"type", "number"}, {"minimum", 0}, {"maximum", form::most_tolerance}};
    all["quantity"] = {{"enum", form::measure_names}};
    return all;
}

Json object_of(const Json& properties, const Json& more, std::vector<std::string> required) {
    Json all = properties;
    all.update(more);
    return {{"type", "object"},
            {"properties", std::move(all)},
            {"required", std::move(required)},
            {"additionalProperties", false}};
}

/// Returns the schema of an entry. An entry has at most one of three subjects, and a subject's keys are allowed only
/// together with that subject.
Json entry_of(const Json& of_all) {
    Json properties = Json::parse(subject);
    properties["step"] = whole_number(1, form::most_step);
    Json entry = object_of(properties, of_all, {"name"});
    entry["dependentRequired"] = {{"step", {"lesson"}},
                                  {"revealed", {"lesson"}},
                                  {"present", {"lesson"}},
                                  {"course", {"exercise"}},
                                  {"student", {"exercise"}}};
    const auto both = [](const char* a, const char* b) { return Json{{"required", {a, b}}}; };
    entry["not"] = {
        {"anyOf", Json::array({both("state", "lesson"), both("state", "exercise"), both("lesson", "exercise")})}};
    return entry;
}

}  // namespace

std::string suite_schema() {
    const Json of_all = all_settings();
    const Json name = reference_to("name"), none = Json::object();
    Json thresholds = {{"name", name}, {"about", name}};
    for (const char* const key : {"profile", "worst", "share", "reach"}) thresholds[key] = of_all[key];
    Json several = Json::parse(each);
    several["each"] = {{"enum", form::each_names}};
    const Json entry = {{"anyOf", Json::array({entry_of(of_all), object_of(several, of_all, {"each", "name"})})}};
    const Json loosened = object_of(thresholds, none, {"name", "about"});
    Json entries = list_of(entry, form::most_entries);
    entries["minItems"] = 1;
    Json schema = object_of({{"$schema", {{"type", "string"}}},
                             {"suite", {{"const", 1}}},
                             {"title", name},
                             {"references", name},
                             {"report", name},
                             {"defaults", object_of(of_all, none, {})},
                             {"entries", entries},
                             {"loosened", list_of(loosened, form::most_entries)}},
                            none, {"suite", "entries"});
    Json whole = {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                  {"title", "A suite of the Viewing Sandbox"}};
    whole.update(schema);
    whole["$defs"] = all_definitions();
    return print_document(whole) + "\n";
}

}  // namespace viewing
