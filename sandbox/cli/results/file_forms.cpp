#include "cli/results/file_forms.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "lesson/exercise.h"
#include "lesson/hand_in.h"
#include "lesson/lesson.h"
#include "state/file/document.h"
#include "state/file/schema.h"
#include "suite/suite.h"
#include "text/numbers.h"
#include "text/words.h"

namespace viewing {
namespace {

/// What the schemas' shared definitions hold, in words; a table does not repeat their members.
constexpr std::pair<std::string_view, const char*> definitions[] = {
    {"name", "a name"},
    {"text", "a text"},
    {"needed_text", "a text"},
    {"numbers", "a number, vector, or matrix"},
    {"sample", "a number, vector, or matrix"},
    {"settings", "settings, such as {\"projection.near\": 0.1}"},
    {"scene", "a scene: see help states"},
    {"state", "a state: see params --format text"}};

/// Longer lists of names are shortened.
constexpr std::size_t most_names = 12;

struct MemberRow {
    std::string path, value;
    std::vector<std::string> kinds = {};  ///< of the object, where only these kinds have the member
    bool operator==(const MemberRow& other) const { return path == other.path && value == other.value; }
};

std::string definition_of(const Json& schema) {
    const std::string reference = schema.value("$ref", "");
    return reference.substr(reference.rfind('/') + 1);
}

std::string with_range(const std::string& noun, const Json& schema) {
    constexpr double unlimited = 1e12;
    const double least = schema.value("minimum", -unlimited), most = schema.value("maximum", unlimited);
    if (least <= -unlimited && most >= unlimited) return noun;
    if (most >= unlimited) return noun + " from " + format_number(least);
    return noun + " from " + format_number(least) + " to " + format_number(most);
}

std::string value_of(const Json& schema);

std::string names_in(const Json& values) {
    std::vector<std::string> names;
    for (const Json& value : values)
        if (names.size() < most_names) names.push_back(value.is_string() ? value.get<std::string>() : value.dump());
    const std::size_t left = values.size() - names.size();
    return joined(std::span<const std::string>(names)) + (left == 0 ? "" : ", or " + std::to_string(left) + " others");
}

std::string list_of(const Json& schema) {
    const std::size_t least = schema.value("minItems", std::size_t{0}), most = schema.value("maxItems", std::size_t{0});
    const Json& first = schema.contains("prefixItems") ? schema["prefixItems"].front() : schema["items"];
    const std::string count = least == most ? std::to_string(most) : "at most " + std::to_string(most);
    return "a list of " + count + ": " + value_of(first);
}

std::string value_of(const Json& schema) {
    const std::string definition = definition_of(schema);
    for (const auto& [name, words] : definitions)
        if (name == definition) return words;
    if (schema.contains("const")) return schema["const"].dump();
    if (schema.contains("enum")) return "one of " + names_in(schema["enum"]);
    const std::string type = schema.value("type", "");
    if (type == "array") return list_of(schema);
    if (type == "number") return with_range("a number", schema);
    if (type == "integer") return with_range("a whole number", schema);
    if (type == "string") return "a string";
    if (type == "boolean") return "true or false";
    if (type == "object") return schema.contains("properties") ? "an object" : "an object with members of your choice";
    std::vector<std::string> values;
    if (schema.contains("anyOf"))
        for (const Json& alternative : schema["anyOf"])
            if (std::string value = value_of(alternative); std::count(values.begin(), values.end(), value) == 0)
                values.push_back(std::move(value));
    std::string all;
    for (const std::string& value : values) all += (all.empty() ? "" : " or ") + value;
    return type.empty() && all.empty() ? "anything" : all.empty() ? type : all;
}

bool names_kind(const std::string& name, const Json& member) {
    return name == "kind" && member.contains("const");
}

bool needs(const Json& schema, const Json& name) {
    const Json needed = schema.value("required", Json::array());
    return std::count(needed.begin(), needed.end(), name) > 0;
}

/// Returns the name that tells an object from the other alternatives: its "kind", or else the first member that only it
/// needs; empty if there is none.
std::string kind_of(const Json& schema, const Json& alternatives) {
    if (!schema.contains("properties")) return "";
    for (const auto& [name, member] : schema["properties"].items())
        if (names_kind(name, member)) return member["const"].get<std::string>();
    for (const Json& name : schema.value("required", Json::array()))
        if (std::none_of(alternatives.begin(), alternatives.end(),
                         [&](const Json& other) { return other != schema && needs(other, name); }))
            return name;
    return "";
}

std::vector<MemberRow> rows_below(const Json& schema, const std::string& path);

/// The rows of alternatives: each row once, with the kinds of object that have it unless all have it.
std::vector<MemberRow> rows_of_alternatives(const Json& alternatives, const std::string& path) {
    std::vector<MemberRow> rows;
    std::vector<std::string> kinds;
    for (const Json& alternative : alternatives) {
        const std::string kind = kind_of(alternative, alternatives);
        if (!kind.empty()) kinds.push_back(kind);
        for (MemberRow row : rows_below(alternative, path)) {
            const auto same = std::find(rows.begin(), rows.end(), row);
            if (same == rows.end()) {
                if (!kind.empty()) row.kinds = {kind};
                rows.push_back(std::move(row));
            } else if (!kind.empty()) {
                same->kinds.push_back(kind);
            }
        }
    }
    for (MemberRow& row : rows)
        if (row.kinds.size() == kinds.size()) row.kinds.clear();
    const Json& first = alternatives.front();
    if (first.contains("properties") && first["properties"].contains("kind"))
        rows.insert(rows.begin(),
                    {path + ".kind", "one of " + joined(std::span<const std::string>(kinds)) + "; needed"});
    return rows;
}

std::vector<MemberRow> rows_below(const Json& schema, const std::string& path) {
    std::vector<MemberRow> rows;
    if (!schema.is_object()) return rows;
    const auto append = [&rows](const std::vector<MemberRow>& more) {
        rows.insert(rows.end(), more.begin(), more.end());
    };
    if (schema.contains("properties")) {
        for (const auto& [name, member] : schema["properties"].items()) {
            // Members without rules, or of another kind of object, have no row; the alternatives have one for the kind.
            if (!member.is_object() || names_kind(name, member)) continue;
            const std::string below = path.empty() ? name : path + "." + name;
            rows.push_back({below, value_of(member) + (needs(schema, name) ? "; needed" : "")});
            append(rows_below(member, below));
        }
    } else if (schema.contains("anyOf")) {
        append(rows_of_alternatives(schema["anyOf"], path));
    }
    if (schema.contains("items")) append(rows_below(schema["items"], path + "[]"));
    return rows;
}

/// Returns the rows of a schema's table, in the schema's order. Each has two cells: a member's path, such as
/// "steps[].ask.expect", where [] means any item of a list; and its value, with "; needed" if it must be there. For a
/// member that only some kinds of an object have, the value ends with these kinds: "(number, vector)".
std::vector<ManualBlock> member_rows(const std::string& schema) {
    std::vector<ManualBlock> blocks;
    for (const MemberRow& row : rows_below(Json::parse(schema), "")) {
        const std::string kinds = row.kinds.empty() ? "" : " (" + joined(std::span<const std::string>(row.kinds)) + ")";
        blocks.push_back({ManualPart::row, {row.path, row.value + kinds}});
    }
    return blocks;
}

}  // namespace

std::span<const FileForm> file_forms() {
    static constexpr std::array forms{FileForm{"scene", "scene-schema", "states", scene_schema},
                                      FileForm{"suite", "suite-schema", "suites", suite_schema},
                                      FileForm{"lesson", "lesson-schema", "lessons", lesson_schema},
                                      FileForm{"lecture", "lecture-schema", "lessons", lecture_schema},
                                      FileForm{"exercise", "exercise-schema", "exercises", exercise_schema},
                                      FileForm{"hand-in", "hand-in-schema", "grading", hand_in_schema},
                                      FileForm{"flight", "flight-schema", "sweeps", flight_schema}};
    return forms;
}

std::vector<ManualBlock> manual_page(std::string_view topic) {
    std::vector<ManualBlock> blocks = manual_topic(topic);
    for (const FileForm& form : file_forms()) {
        if (form.topic != topic) continue;
        blocks.push_back({ManualPart::heading, {"The members of " + std::string(form.name) + " files"}});
        const std::vector<ManualBlock> rows = member_rows(form.schema());
        blocks.insert(blocks.end(), rows.begin(), rows.end());
    }
    return blocks;
}

}  // namespace viewing
