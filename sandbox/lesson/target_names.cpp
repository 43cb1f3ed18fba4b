#include "lesson/target_names.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>

#include "state/fields.h"
#include "text/words.h"

namespace viewing {
namespace {

/// A kind of target, and the names that may follow its colon; target_names() adds kinds whose names are listed
/// elsewhere.
struct Kind {
    std::string_view kind;
    std::span<const char* const> names;
};

constexpr const char* sections[] = {"camera", "slips", "projection", "visibility", "depth",
                                    "light",  "plane", "shadow",     "beside",     "observer"};
constexpr const char* matrices[] = {"S", "R", "V", "C", "P"};
constexpr const char* code_views[] = {"display",
                                      "display.projection",
                                      "display.rotate",
                                      "display.rotate.roll",
                                      "display.rotate.pitch",
                                      "display.rotate.yaw",
                                      "display.translate",
                                      "passes",
                                      "lecture",
                                      "lecture.shadow",
                                      "lecture.mirror"};
constexpr const char* charts[] = {"precision.near", "precision.far", "precision.quantization", "precision.arithmetic"};
constexpr const char* columns[] = {
    "fighting.pair",      "fighting.z",         "fighting.gap",     "fighting.step",         "fighting.safe_gap",
    "fighting.predicted", "fighting.trembling", "fighting.counted", "fighting.wrong_pixels", "pixel.object",
    "pixel.eye_z",        "pixel.facing",       "pixel.stored",     "pixel.compare",         "pixel.test"};
constexpr const char* facts[] = {"det_mirror", "det_shadow", "rank_shadow", "plane_dot_light"};
constexpr const char* followed[] = {"p", "S p", "shadow", "mirrored", "foot", "distance"};
constexpr const char* buttons[] = {"show C", "show V",    "normalize",  "copy",
                                   "edit",   "fix",       "raise near", "lower near",
                                   "home",   "frame all", "level",      "find a view where this key fails"};
constexpr const char* texts[] = {"mirror_derivation",
                                 "mirror_derivation.k",
                                 "mirror_derivation.foot",
                                 "mirror_derivation.mirrored",
                                 "mirror_derivation.rows",
                                 "mirror_derivation.matrix",
                                 "shadow_derivation",
                                 "shadow_derivation.lines",
                                 "shadow_derivation.matrix",
                                 "unit normal",
                                 "why.fault"};
constexpr const char* labels[] = {"mirrored", "heights"};
constexpr const char* notes[] = {"depth_step", "codes"};
constexpr const char* bars[] = {"pixel"};
constexpr Kind kinds[] = {{"section", sections}, {"matrix", matrices}, {"code", code_views}, {"chart", charts},
                          {"column", columns},   {"fact", facts},      {"follow", followed}, {"button", buttons},
                          {"text", texts},       {"label", labels},    {"note", notes},      {"bar", bars},
                          {"call", named_calls}};
/// Names without a kind: the lamps for degrees of freedom, and things that occur in many places (red sentences, advice
/// on z-near, formulas in tooltips, links between entries and controls).
constexpr const char* alone[] = {"lamps", "sentences", "advice", "formulas", "links"};

/// Former names, still used by lessons older than the current labels, each with its current name.
constexpr std::pair<std::string_view, const char*> former_names[] = {
    {"button:mend", "button:fix"},
    {"button:normalise", "button:normalize"},
    {"chart:precision.quantisation", "chart:precision.quantization"}};

/// Whether the field, or a field of the group, has a control.
bool has_control(std::string_view path) {
    return std::any_of(fields().begin(), fields().end(),
                       [path](const Field& field) { return field.has_control && is_in(field.path, path); });
}

int component_count(const Field& field) {
    const std::string_view type = type_name(field);
    return type == "vec3" ? 3 : type == "vec4" ? 4 : 0;
}

/// Removes an index such as "[2]" from the front of `rest` and returns it; none if `rest` does not begin with an index
/// below `count`.
std::optional<int> take_index(std::string_view& rest, int count) {
    if (rest.size() < 3 || rest[0] != '[' || rest[2] != ']' || rest[1] < '0' || rest[1] >= '0' + count)
        return std::nullopt;
    const int index = rest[1] - '0';
    rest.remove_prefix(3);
    return index;
}

/// The number of indices that may follow a name, and the limit of each.
struct Indices {
    int depth = 0, count = 0;
};
Indices indices_of(const std::string& name) {
    constexpr std::string_view control = "control:", matrix = "matrix:";
    if (name.starts_with(matrix)) return {2, 4};
    if (!name.starts_with(control)) return {};
    const Field* field = find_field(name.substr(control.size()));
    const int components = field ? component_count(*field) : 0;
    return {components > 0 ? 1 : 0, components};
}

std::string index_error(std::string_view name, const std::string& whole, const Indices& indices) {
    const std::string most = std::to_string(indices.count - 1);
    if (indices.depth == 0) return "\"" + one_line(name) + "\": " + whole + " has no entries";
    return "\"" + one_line(name) + "\": " + whole + " may be followed by " +
           (indices.depth == 2 ? "[row] or [row][column]" : "[component]") + ", each from 0 to " + most;
}

}  // namespace

std::vector<std::string> target_names() {
    std::vector<std::string> names;
    const auto add = [&names](std::string name) {
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(std::move(name));
    };
    for (const std::string& path : known_paths())
        if (has_control(path)) add("control:" + path);
    add("view:camera");
    for (const char* topic : names_of<Topic>().subspan(1)) add(std::string("view:") + topic);
    for (const Kind& kind : kinds)
        for (const char* name : kind.names) add(std::string(kind.kind) + ":" + name);
    for (const char* name : alone) add(name);
    return names;
}

Result<std::string> read_target(std::string_view name) {
    for (const char* shows : names_of<Shows>())
        if (name == std::string("view:camera(") + shows + ")") return std::string("view:camera");
    for (const auto& [former, present] : former_names)
        if (name == former) return std::string(present);
    static const std::vector<std::string> known = target_names();
    const std::string whole(name.substr(0, name.find('[')));
    if (std::find(known.begin(), known.end(), whole) == known.end()) {
        const std::string nearest = suggestion(whole, known);
        if (!nearest.empty()) return Error{"\"" + one_line(name) + "\": nothing in the window has this name" + nearest};
        std::string all = "control";
        for (const Kind& kind : kinds) all += ", " + std::string(kind.kind);
        return Error{"\"" + one_line(name) + "\": nothing in the window has this name; names begin with view, " + all +
                     " and a colon, or are lamps, sentences, advice, formulas, links"};
    }
    const Indices indices = indices_of(whole);
    std::string_view rest = name.substr(whole.size());
    for (int depth = 0; depth < indices.depth && !rest.empty(); ++depth)
        if (!take_index(rest, indices.count)) break;
    if (!rest.empty()) return Error{index_error(name, whole, indices)};
    return std::string(name);
}

}  // namespace viewing
