// The one list of fields: every path of the state file with its type, unit, range, default and what
// it does. The JSON reader and writer, `params`, `--set` and the panel's controls all read this list.
#pragma once

#include <span>
#include <string>
#include <string_view>
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

/// Where a field lives inside a Params.
using FieldRef = std::variant<bool*, int*, double*, glm::dvec3*, glm::dvec4*, Color*, EnumRef, SceneSource*,
                              std::vector<LightParams>*, std::vector<PlaneParams>*, std::optional<glm::dmat4>*,
                              std::optional<Follow>*, std::optional<glm::dvec2>*, std::optional<glm::ivec2>*>;

struct Field {
    std::string_view path;  ///< "projection.near"
    FieldRef (*in)(Params&) = nullptr;
    std::string_view label;      ///< as on the panel: "z-near"
    std::string_view unit = "";  ///< "world units", "°", "" …
    double min = -1e12;          ///< inclusive, per component; ±1e12 where nothing else limits it
    double max = 1e12;
    double step = 0.01;             ///< the natural step of a drag
    bool logarithmic = false;       ///< the range spans decades
    std::string_view help;          ///< what it does, one or two sentences
    std::string_view formula = "";  ///< "" or the formula it enters
    std::string_view gl_call = "";  ///< "" or the GL call it becomes
};

/// All fields in the order of the state file.
std::span<const Field> fields();

/// The field at a path; nullptr when there is none.
const Field* find_field(std::string_view path);

/// The field at a path that is known to exist; a missing one is a programmer's mistake and asserts.
const Field& field(std::string_view path);

/// What one component of a field may be, both ends included. The w of a light is 0 … 1, other components have the
/// field's range. Scalars are component 0.
struct Range {
    double min, max;
};
Range component_range(const Field& field, int component);

/// "from 1 to 179".
std::string range_text(const Range& range);

/// "bool", "int", "number", "vec3", "vec4", "color", "enum", "scene", "lights", "planes", "matrix", "follow",
/// "range", "pixel".
std::string_view type_name(const Field& field);

/// What the field accepts, to follow "must be": "a number from 1 to 179", "one of fly, walk, orbit" …
std::string allowed_text(const Field& field);

/// At most so many further lights and planes, so that four lights and eight planes are the most in all.
inline constexpr std::size_t max_further_lights = 3;
inline constexpr std::size_t max_further_planes = 7;

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
template <> std::span<const char* const> names_of<SortKey>();
template <> std::span<const char* const> names_of<Splitter>();
template <> std::span<const char* const> names_of<Shows>();
template <> std::span<const char* const> names_of<DepthScale>();
template <> std::span<const char* const> names_of<DecalMethod>();
template <> std::span<const char* const> names_of<DepthColors>();
template <> std::span<const char* const> names_of<Beside>();
template <> std::span<const char* const> names_of<BesideLayout>();
template <> std::span<const char* const> names_of<Topic>();
template <> std::span<const char* const> names_of<Theme>();
template <> std::span<const char* const> names_of<ShapeKind>();
// clang-format on

template <typename Enum>
std::string_view name_of(Enum value) {
    return names_of<Enum>()[static_cast<std::size_t>(value)];
}

/// Puts every number back into its field's range and mends what belongs together (near < far, a plane
/// with a normal, a light that is not zero): what the panel can reach is never an error. An angle that
/// may turn on and on (yaw, roll) is wrapped by whole turns instead of stopping; NaN becomes the default.
/// The objects of an inline scene are left alone: no control reaches them.
void clamp_to_ranges(Params& params);

}  // namespace viewing
