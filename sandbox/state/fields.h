// The list of all fields: every path of the state file with its type, unit, range, default and explanation. The JSON
// reader and writer, `params`, `--set` and the panel's controls all use this list.
#pragma once

#include <array>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "state/params.h"

namespace viewing {

/// A reference to an enumeration's value, with the names of all values in order.
struct EnumRef {
    std::span<const char* const> names;
    void* value;
    int (*index_of)(const void* value);
    void (*assign)(void* value, int index);

    int index() const { return index_of(value); }
    void set(int index) const { assign(value, index); }
};

/// The elements of a list after the first. The state file keeps the first in its own group ("light") and the rest in an
/// array ("lights"), each with the fields of that group. Only this template encodes that rule.
template <typename Element>
struct Further {
    static constexpr bool has_lights = std::is_same_v<Element, LightParams>;
    static constexpr std::string_view group = has_lights ? "light" : "plane";
    static constexpr std::size_t most = has_lights ? most_lights - 1 : most_planes - 1;
    static constexpr auto member = [] {
        if constexpr (has_lights)
            return &Params::lights;
        else
            return &Params::planes;
    }();
    std::vector<Element>* all;

    std::span<Element> elements() const { return std::span(*all).subspan(1); }
};

/// Matrices entered by hand, except those of the first plane and its first light, which have their own fields.
struct FurtherOverrides {
    std::array<PlaneOverrides, most_planes>* all;
};

/// A reference to a field inside a Params. Each alternative is a kind of field, which state/kinds declares.
using FieldRef = std::variant<bool*, int*, double*, glm::dvec3*, glm::dvec4*, Color*, EnumRef, SceneSource*,
                              Further<LightParams>, Further<PlaneParams>, std::optional<glm::dmat4>*, FurtherOverrides,
                              std::optional<Follow>*, std::optional<glm::dvec2>*, std::optional<glm::ivec2>*,
                              std::optional<Pin>*, std::vector<std::string>*, Settings*>;

// clang-format off
/// Why a field may have no effect. frame/effect.cpp says when each reason holds, and names it in a sentence.
enum class Idle {
    p_by_hand, v_by_hand,
    orthographic, not_orthographic, has_window, no_field_of_view, no_window,
    no_gl_depth_test, no_depth_buffer, no_depth_test, not_reversed, not_logarithmic, no_depth_clear,
    no_decals, no_decal_offset, no_pairs,
    gl_resolution, no_culling, no_facing,
    no_shadow, no_receiver, missing_light, no_shadow_offset, no_lift,
    no_reflection, no_mirror, no_ab, unit_normals, not_oblique, scene_mirrored,
    not_painter, not_bsp, no_splits, not_ray_cast, culling, no_difference, ray_cast,
    no_second_picture, same_depth, same_settings, halves,
    no_orbiting_light, not_walking, flying, not_orbiting,
};
// clang-format on

struct Field {
    std::string_view path;  ///< "projection.near"
    FieldRef (*place)(Params& params, std::size_t element) = nullptr;
    std::string_view label;      ///< as shown on the panel: "z-near"
    bool has_control = true;     ///< in the panel or in the camera view's headline
    std::string_view unit = "";  ///< "world units", "°", "" …
    double min = -1e12;          ///< inclusive, per component; ±1e12 if nothing else limits it
    double max = 1e12;
    double step = 0.01;                       ///< natural step of a drag
    bool logarithmic = false;                 ///< the range spans decades
    bool may_be_infinite = false;             ///< "infinite" is allowed above the range
    double least_above_zero = 0.0;            ///< unless 0: a value must be 0 or at least this
    std::span<const int> only = {};           ///< the allowed whole numbers; empty: all in the range
    std::span<const char* const> names = {};  ///< the allowed names of a list; empty: the paths of fields and groups
    bool is_light = false;                    ///< four numbers are (x, y, z, w), not a plane (a, b, c, d)
    std::initializer_list<Idle> idle = {};    ///< why it may have no effect, the broadest reason first
    std::string_view help;                    ///< its effect, in a few sentences
    std::string_view formula = "";            ///< the formula that uses the field; "" if none
    std::string_view gl_call = "";            ///< the GL call that the field sets; "" if none

    /// Returns a reference to the field in `params`. `element` selects the light or plane in the groups "light" and
    /// "plane"; it is 0 for other fields.
    FieldRef in(Params& params, std::size_t element = 0) const { return place(params, element); }
    /// Returns "near" for "projection.near".
    std::string_view name() const { return path.substr(path.rfind('.') + 1); }
};

/// The text for an infinite value in a file, where Field::may_be_infinite allows it.
inline constexpr const char* infinite = "infinite";

/// Returns all fields in the order of the state file.
std::span<const Field> fields();

/// Returns the field at a path; nullptr if there is none.
const Field* find_field(std::string_view path);

/// Returns the field at a path that must exist; a missing one is a programming error and fails an assertion.
const Field& field(std::string_view path);

/// Returns whether a path is the given group or field, or is inside it.
bool is_in(std::string_view path, std::string_view group);

/// Returns the fields of a group, which may also be a group of list elements, such as "light".
std::vector<const Field*> fields_of(std::string_view group);

/// Returns the JSON form of an element of the group's list: `{"equation": [a, b, c, d], "extent", …}`.
std::string element_form(std::string_view group);

/// Returns the number of lights or planes if each of them has the field; 1 for any other field.
std::size_t element_count(const Field& field, const Params& params);

/// The inclusive range of a field's component. The w of a light has the range 0 … 1; all other components have the
/// field's range. A scalar is component 0.
struct Range {
    double min, max;
};
Range component_range(const Field& field, int component);

/// Returns the range as text: "from 1 to 179".
std::string range_text(const Range& range);

/// Returns "bool", "int", "number", "vec3", "vec4", "color", "enum", "scene", "lights", "planes", "matrix", "matrices",
/// "follow", "range", "pixel", "pin", "names" or "settings".
std::string_view type_name(const Field& field);

/// Returns "projection" for "projection.near", "" for "scene".
std::string_view group_of(std::string_view path);

/// Returns the paths of all fields and groups, in the order of the list.
std::vector<std::string> known_paths();

/// Returns whether the JSON of the `params` command gives the field's range.
bool has_range(const Field& field);

/// Returns the names of a field's enumeration, or those that a list of names may contain; empty for other kinds.
std::vector<std::string> allowed_names(const Field& field);

/// Returns the smallest value of near that the state's projection and depth mapping allow. It is positive if
/// perspective divides by the distance or logarithmic depth takes its logarithm; otherwise near may be negative, as in
/// glOrtho.
double least_near(const Params& params);
inline constexpr double least_positive_near = 1e-6;

/// Returns whether the state's projection and depth mapping allow far to be infinite: parallel view rays and a
/// logarithm need a finite value.
bool may_have_infinite_far(const Params& params);

/// Returns the minimum distance between two opposite edges of the picture's window.
double least_window(double low, double high);

/// The largest distance of an edge of the picture's window from the view axis.
inline constexpr double window_limit = 1e6;

/// The smallest aspect ratio other than 0: a smaller one would squeeze the picture into a line.
inline constexpr double min_aspect = 0.1;

/// Returns the accepted values as a phrase that completes "must be": "a number from 1 to 179", "one of fly, walk,
/// orbit" …
std::string allowed_text(const Field& field);

/// A normal (a, b, c) or a light (x, y, z, w) shorter than this counts as zero.
inline constexpr double min_length = 1e-9;

/// Returns the names of an enumeration, in the order of its enumerators.
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
template <> std::span<const char* const> names_of<ViewName>();
template <> std::span<const char* const> names_of<Theme>();
template <> std::span<const char* const> names_of<Language>();
template <> std::span<const char* const> names_of<ShapeKind>();
// clang-format on

template <typename Enum>
std::string_view name_of(Enum value) {
    return names_of<Enum>()[static_cast<std::size_t>(value)];
}

/// Corrects a field's value that is out of its range; NaN becomes the default.
void clamp_field(const Field& field, Params& params, std::size_t element);

/// Moves a number from its value in `from` toward its value in `to`, by equal factors if the field is logarithmic;
/// keeps all other values of `to`.
void blend_field(const Field& field, Params& from, Params& to, double share, std::size_t element);

/// Clamps every number to its field's range and corrects values that depend on each other (near < far, a plane with a
/// normal, a light that is not zero, a chosen element that exists), so that the panel can never cause an error. The
/// camera's angles and the observer's yaw wrap by full turns, since they may keep growing; NaN becomes the default.
/// Leaves the objects of an inline scene unchanged: no control edits them.
void clamp_to_ranges(Params& params);

}  // namespace viewing
