#include "suite/schema.h"

#include "app/picture.h"
#include "state/file/document.h"

namespace viewing {
namespace {

/// What every entry may say, and "defaults" for all: as suite_reader.cpp reads it.
constexpr const char* settings = R"({
  "set": {"anyOf": [{"type": "object"}, {"type": "array", "items": {"type": "string", "pattern": "="}}]},
  "size": {"type": "array", "items": {"type": "integer", "minimum": 1, "maximum": 16384}, "minItems": 2, "maxItems": 2},
  "samples": {"enum": [0, 4, "state"]},
  "picture": {"type": "boolean"},
  "profile": {"enum": ["strict", "portable"]},
  "worst": {"type": "integer", "minimum": 0, "maximum": 255},
  "share": {"type": "number", "minimum": 0, "maximum": 1},
  "reach": {"type": "integer", "minimum": 0, "maximum": 16},
  "masks": {"type": "array", "maxItems": 1000, "items": {"anyOf": [{"$ref": "#/$defs/name"},
    {"type": "array", "items": {"type": "integer", "minimum": 0, "maximum": 16384}, "minItems": 4, "maxItems": 4}]}},
  "matrices": {"anyOf": [{"type": "boolean"}, {"type": "object", "properties": {"tolerance": {"$ref": "#/$defs/tolerance"}},
    "additionalProperties": false}]},
  "measure": {"anyOf": [{"$ref": "#/$defs/measure"}, {"type": "array", "items": {"$ref": "#/$defs/measure"}}]},
  "problems": {"type": "object", "properties": {"must": {"$ref": "#/$defs/names"}, "must_not": {"$ref": "#/$defs/names"},
    "none": {"type": "boolean"}}, "additionalProperties": false}
})";

constexpr const char* definitions = R"({
  "name": {"type": "string", "minLength": 1, "maxLength": 1024},
  "names": {"type": "array", "items": {"$ref": "#/$defs/name"}, "maxItems": 64},
  "tolerance": {"type": "number", "minimum": 0, "maximum": 1e9},
  "quantity": {"enum": ["fighting", "visibility", "mirror", "order"]},
  "measure": {"anyOf": [{"$ref": "#/$defs/quantity"}, {"type": "object", "properties":
    {"what": {"$ref": "#/$defs/quantity"}, "tolerance": {"$ref": "#/$defs/tolerance"}}, "required": ["what"],
    "additionalProperties": false}]}
})";

constexpr const char* subject = R"({
  "name": {"$ref": "#/$defs/name"}, "about": {"$ref": "#/$defs/name"},
  "state": {"anyOf": [{"$ref": "#/$defs/name"}, {"type": "object"}]},
  "lesson": {"$ref": "#/$defs/name"}, "step": {"type": "integer", "minimum": 1, "maximum": 1000},
  "revealed": {"type": "boolean"}, "present": {"type": "boolean"},
  "exercise": {"$ref": "#/$defs/name"}, "course": {"$ref": "#/$defs/name"}, "student": {"$ref": "#/$defs/name"}
})";

constexpr const char* each = R"({
  "each": {"enum": ["preset", "mended", "scene"]}, "name": {"type": "string", "pattern": "\\{\\}"},
  "about": {"$ref": "#/$defs/name"}, "except": {"$ref": "#/$defs/names"}
})";

Json object_of(const Json& properties, const Json& more, std::vector<std::string> required) {
    Json all = properties;
    all.update(more);
    return {{"type", "object"},
            {"properties", std::move(all)},
            {"required", std::move(required)},
            {"additionalProperties", false}};
}

}  // namespace

std::string suite_schema() {
    Json of_all = Json::parse(settings);
    of_all["view"] = {{"enum", picture_view_names}};
    const Json name = {{"$ref", "#/$defs/name"}}, none = Json::object();
    Json thresholds = {{"name", name}, {"about", name}};
    for (const char* const key : {"profile", "worst", "share", "reach"}) thresholds[key] = of_all[key];
    const Json entry = {{"anyOf", Json::array({object_of(Json::parse(subject), of_all, {"name"}),
                                               object_of(Json::parse(each), of_all, {"each", "name"})})}};
    const Json loosened = object_of(thresholds, none, {"name", "about"});
    Json schema = object_of({{"$schema", {{"type", "string"}}},
                             {"suite", {{"const", 1}}},
                             {"title", name},
                             {"references", name},
                             {"report", name},
                             {"defaults", object_of(of_all, none, {})},
                             {"entries", {{"type", "array"}, {"minItems", 1}, {"items", entry}}},
                             {"loosened", {{"type", "array"}, {"items", loosened}}}},
                            none, {"suite", "entries"});
    Json whole = {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                  {"title", "A suite of the Viewing Sandbox"}};
    whole.update(schema);
    whole["$defs"] = Json::parse(definitions);
    return print_document(whole) + "\n";
}

}  // namespace viewing
