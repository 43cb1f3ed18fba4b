// The one list of fields: every path of the state file with its type, unit, range, default and what
// it does. The JSON reader and writer, `params`, `--set` and the panel's controls all read this list.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "state/params.h"

namespace viewing {

/// An enumeration's value together with its names in order.
struct EnumRef {
    std::span<const char* const> names;
    void* value;
    int (*index_of)(const void* value);
    void (*assign)(void* value, int index);

    int index() const { return index_of(value); }
    void set(int index) const { assign(value, index); }
};

/// The elements of a list behind the first one. The state file has them in an array ("lights") and the first one in a
/// group of its own ("light"), whose fields are those of every element: this is the one place that says so.
template <typename Element>
struct Further {
    static constexpr bool has_lights = std::is_same_v<Element, LightParams>;
    static constexpr std::string_view group = has_lights ? "light" : "plane";
    static constexpr std::size_t most = has_lights ? most_lights - 1 : most_planes - 1;
    std::vector<Element>* all;

    std::span<Element> elements() const { return std::span(*all).subspan(1); }
};

/// The matrices by hand but those of the first plane and the first light on it, which have fields of their own.
struct FurtherOverrides {
    std::array<PlaneOverrides, most_planes>* all;
};

/// Where a field lives inside a Params.
using FieldRef = std::variant<bool*, int*, double*, glm::dvec3*, glm::dvec4*, Color*, EnumRef, SceneSource*,
                              Further<LightParams>, Further<PlaneParams>, std::optional<glm::dmat4>*, FurtherOverrides,
                              std::optional<Follow>*, std::optional<glm::dvec2>*, std::optional<glm::ivec2>*,
                              std::optional<Pin>*, std::vector<std::string>*>;

struct Field {
    std::string_view path;  ///< "projection.near"
    FieldRef (*place)(Params& params, std::size_t element) = nullptr;
    std::string_view label;      ///< as on the panel: "z-near"
    std::string_view unit = "";  ///< "world units", "°", "" …
    double min = -1e12;          ///< inclusive, per component; ±1e12 where nothing else limits it
    double max = 1e12;
    double step = 0.01;             ///< the natural step of a drag
    bool logarithmic = false;       ///< the range spans decades
    std::string_view help;          ///< what it does, one or two sentences
    std::string_view formula = "";  ///< "" or the formula it enters
    std::string_view gl_call = "";  ///< "" or the GL call it becomes

    /// Of a field of the groups "light" and "plane", in which light or plane of the list; `element` is 0 for others.
    FieldRef in(Params& params, std::size_t element = 0) const { return place(params, element); }
    /// "near"
    std::string_view name() const { return path.substr(path.rfind('.') + 1); }
};

/// All fields in the order of the state file.
std::span<const Field> fields();

/// The field at a path; nullptr when there is none.
const Field* find_field(std::string_view path);

/// The field at a path that is known to exist; a missing one is a programmer's mistake and asserts.
const Field& field(std::string_view path);

/// Whether a path is that of the group, or field, itself or of something in it.
bool is_in(std::string_view path, std::string_view group);

/// The fields of a group, which may be that of a list's elements.
std::vector<const Field*> fields_of(std::string_view group);

/// `{"equation": [a, b, c, d], "extent", …}`: what the state file has for an element of that group's list.
std::string element_form(std::string_view group);

/// In how many elements of a list the field stands; 1 for one that is in no list.
std::size_t element_count(const Field& field, const Params& params);

/// What one component of a field may be, both ends included. The w of a light is 0 … 1, other components have the
/// field's range. Scalars are component 0.
struct Range {
    double min, max;
};
Range component_range(const Field& field, int component);

/// "from 1 to 179".
std::string range_text(const Range& range);

/// "bool", "int", "number", "vec3", "vec4", "color", "enum", "scene", "lights", "planes", "matrix",
/// "matrices", "follow", "range", "pixel", "pin", "names".
std::string_view type_name(const Field& field);

/// "projection" of "projection.near", "" of "scene".
std::string_view group_of(std::string_view path);

/// Paths of fields and of groups, in the order of the list.
std::vector<std::string> known_paths();

/// What a list of names may hold, each once.
std::vector<std::string> allowed_names(const Field& field);

/// One of them, to follow "must be".
std::string allowed_name_text(const Field& field);

/// Where the projection's aspect is neither 0 nor at least this, the picture would be a line.
inline constexpr double min_aspect = 0.1;

/// What the field accepts, to follow "must be": "a number from 1 to 179", "one of fly, walk, orbit" …
std::string allowed_text(const Field& field);

/// A normal (a, b, c) or a light (x, y, z, w) shorter than this counts as zero.
inline constexpr double min_length = 1e-9;

/// The names of an enumeration, in the order of its enumerators.
template <typename Enum>
std::span<const char* const> names_of();

// clang-format off
template <> std::span<const char* const> names_of<Navigation>();
template <> std::span<const char* const> names_of<ProjectionType>();
template <> std::span<const char* const> names_of<CompareFunc>();
template <> std::span<const char* const> names_of<DepthFormat>();
template <> std::span<const char* const> names_of<DepthMapping>();
template <> std::span<const char* const> names_of<CullFace>();
template <> std::span<const char* const> names_of<FrontFace>();
template <> std::span<const char* const> names_of<ShadowOffset>();
template <> std::span<const char* const> names_of<ShadowStyle>();
template <> std::span<const char* const> names_of<ShadowSign>();
template <> std::span<const char* const> names_of<MirrorClip>();
template <> std::span<const char* const> names_of<MirroredThing>();
template <> std::span<const char* const> names_of<VisibilityMethod>();
template <> std::span<const char* const> names_of<PainterKey>();
template <> std::span<const char* const> names_of<BspSplitter>();
template <> std::span<const char* const> names_of<Shows>();
template <> std::span<const char* const> names_of<DepthScale>();
template <> std::span<const char* const> names_of<DecalMethod>();
template <> std::span<const char* const> names_of<DepthColors>();
template <> std::span<const char* const> names_of<Beside>();
template <> std::span<const char* const> names_of<BesideLayout>();
template <> std::span<const char* const> names_of<Topic>();
template <> std::span<const char* const> names_of<BigView>();
template <> std::span<const char* const> names_of<Theme>();
template <> std::span<const char* const> names_of<Language>();
template <> std::span<const char* const> names_of<ShapeKind>();
// clang-format on

template <typename Enum>
std::string_view name_of(Enum value) {
    return names_of<Enum>()[static_cast<std::size_t>(value)];
}

/// Puts every number back into its field's range and mends what belongs together (near < far, a plane
/// with a normal, a light that is not zero, a chosen one that is there): what the panel can reach is never an error. An
/// angle that may turn on and on (yaw, roll) is wrapped by whole turns instead of stopping; NaN becomes the default.
/// The objects of an inline scene are left alone: no control reaches them.
void clamp_to_ranges(Params& params);

}  // namespace viewing
