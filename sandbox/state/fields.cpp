// The one list of fields, in the order of the state file, and the names of the enumerations. A table, hence its
// length. The words are the lecture's. What may be done with a range stands in ranges.cpp; read json.h next.
#include "state/fields.h"

#include <algorithm>
#include <cassert>
#include <type_traits>

namespace viewing {

// clang-format off
template <> std::span<const char* const> names_of<Navigation>() { static constexpr const char* names[] = {"fly", "walk", "orbit"}; return names; }
template <> std::span<const char* const> names_of<ProjectionType>() { static constexpr const char* names[] = {"perspective", "orthographic"}; return names; }
template <> std::span<const char* const> names_of<CompareFunc>() { static constexpr const char* names[] = {"never", "less", "equal", "lequal", "greater", "notequal", "gequal", "always"}; return names; }
template <> std::span<const char* const> names_of<DepthFormat>() { static constexpr const char* names[] = {"d4", "d5", "d6", "d7", "d8", "d9", "d10", "d11", "d12", "d16", "d24", "d32f"}; return names; }
template <> std::span<const char* const> names_of<DepthMapping>() { static constexpr const char* names[] = {"standard", "reversed", "logarithmic"}; return names; }
template <> std::span<const char* const> names_of<CullFace>() { static constexpr const char* names[] = {"front", "back", "front_and_back"}; return names; }
template <> std::span<const char* const> names_of<FrontFace>() { static constexpr const char* names[] = {"ccw", "cw"}; return names; }
template <> std::span<const char* const> names_of<ShadowOffset>() { static constexpr const char* names[] = {"none", "polygon_offset", "lift", "no_depth_test"}; return names; }
template <> std::span<const char* const> names_of<ShadowStyle>() { static constexpr const char* names[] = {"blend", "missing_light"}; return names; }
template <> std::span<const char* const> names_of<ShadowSign>() { static constexpr const char* names[] = {"plane_dot_light", "none", "forced"}; return names; }
template <> std::span<const char* const> names_of<MirrorClip>() { static constexpr const char* names[] = {"none", "clip_distance", "oblique"}; return names; }
template <> std::span<const char* const> names_of<MirroredThing>() { static constexpr const char* names[] = {"scene", "camera"}; return names; }
template <> std::span<const char* const> names_of<VisibilityMethod>() { static constexpr const char* names[] = {"depth_buffer", "none", "painter", "newell", "bsp", "software_depth_buffer", "ray_cast"}; return names; }
template <> std::span<const char* const> names_of<PainterKey>() { static constexpr const char* names[] = {"nearest", "farthest", "centroid"}; return names; }
template <> std::span<const char* const> names_of<BspSplitter>() { static constexpr const char* names[] = {"first", "random", "fewest_splits", "balanced"}; return names; }
template <> std::span<const char* const> names_of<BspOrder>() { static constexpr const char* names[] = {"back_to_front", "front_to_back"}; return names; }
template <> std::span<const char* const> names_of<Shows>() { static constexpr const char* names[] = {"color", "depth", "stencil", "facing", "overdraw", "difference", "fighting", "shadow_w"}; return names; }
template <> std::span<const char* const> names_of<DepthScale>() { static constexpr const char* names[] = {"window", "linear"}; return names; }
template <> std::span<const char* const> names_of<DecalMethod>() { static constexpr const char* names[] = {"offset", "equal", "stencil"}; return names; }
template <> std::span<const char* const> names_of<DepthColors>() { static constexpr const char* names[] = {"grey", "bands"}; return names; }
template <> std::span<const char* const> names_of<Beside>() { static constexpr const char* names[] = {"nothing", "depth", "other_depth"}; return names; }
template <> std::span<const char* const> names_of<BesideLayout>() { static constexpr const char* names[] = {"halves", "divider"}; return names; }
template <> std::span<const char* const> names_of<Topic>() { static constexpr const char* names[] = {"automatic", "observer", "depth", "histogram", "precision", "codes", "pixel", "cells", "fighting", "moving_world", "passes", "tree", "order", "growth", "shadow_derivation", "mirror_derivation", "lecture_code", "mirror_ways", "from_light", "display_code"}; return names; }
template <> std::span<const char* const> names_of<BigView>() { static constexpr const char* names[] = {"none", "camera", "lower_left", "lower_right", "matrices"}; return names; }
template <> std::span<const char* const> names_of<Theme>() { static constexpr const char* names[] = {"dark", "light", "projector"}; return names; }
template <> std::span<const char* const> names_of<Language>() { static constexpr const char* names[] = {"en", "ko"}; return names; }
template <> std::span<const char* const> names_of<ShapeKind>() { static constexpr const char* names[] = {"box", "sphere", "torus", "cylinder", "cone", "quad", "triangle", "teapot", "mesh"}; return names; }
// clang-format on

namespace {

/// An enumeration by its names and indices, anything else by its address.
template <typename T>
FieldRef field_ref(T& value) {
    if constexpr (std::is_enum_v<T>) {
        return EnumRef{names_of<T>(), &value,
                       [](const void* address) { return static_cast<int>(*static_cast<const T*>(address)); },
                       [](void* address, int index) { *static_cast<T*>(address) = static_cast<T>(index); }};
    } else {
        return &value;
    }
}

#define IN(member) \
    [](Params& params, [[maybe_unused]] std::size_t element) -> FieldRef { return field_ref(params.member); }

constexpr double position_limit = 1e6;
constexpr double turns_limit_deg = 3600.0;
constexpr double offset_limit = 1e6;

constexpr std::string_view length = "world units";
constexpr std::string_view degrees = "°";
constexpr std::string_view camera_formula = "C = T(position) · Ry(yaw) · Rx(pitch) · Rz(roll), V = C⁻¹";
constexpr std::string_view frustum_formula = "d = f/(f−n) − f·n/((f−n)·z) (perspective, standard depth)";
constexpr std::string_view shadow_formula = "S = (Π·L) I − L Πᵀ";
constexpr std::string_view mirror_formula = "R p = p − 2 (n·p + d) n, |n| = 1";

const Field all_fields[] = {
    {.path = "version",
     .place = IN(version),
     .label = "version",
     .min = 1,
     .max = 1,
     .step = 1,
     .help = "The version of the state file's format. This program reads version 1."},
    {.path = "scene",
     .place = IN(scene),
     .label = "scene",
     .help =
         "What is looked at: the name of a scene that comes with the sandbox, the path of a scene or OBJ file, or the "
         "objects themselves."},

    // camera
    {.path = "camera.position",
     .place = IN(camera.position),
     .label = "position",
     .unit = length,
     .min = -position_limit,
     .max = position_limit,
     .step = 0.05,
     .help =
         "Where the eye is, in world coordinates. Moving the camera by +10 along z is the same picture as moving the "
         "world by −10.",
     .formula = camera_formula},
    {.path = "camera.yaw",
     .place = IN(camera.yaw),
     .label = "yaw",
     .unit = degrees,
     .min = -turns_limit_deg,
     .max = turns_limit_deg,
     .step = 0.5,
     .help =
         "Heading: the turn about the y axis, positive to the left. At 0 the camera looks along −z. Walking changes "
         "this angle only.",
     .formula = camera_formula},
    {.path = "camera.pitch",
     .place = IN(camera.pitch),
     .label = "pitch",
     .unit = degrees,
     .min = -180,
     .max = 180,
     .step = 0.5,
     .help = "Looking up (positive) or down (negative): the turn about the camera's own x axis, after yaw. Beyond ±90° "
             "the camera is upside down.",
     .formula = camera_formula},
    {.path = "camera.roll",
     .place = IN(camera.roll),
     .label = "roll",
     .unit = degrees,
     .min = -turns_limit_deg,
     .max = turns_limit_deg,
     .step = 0.5,
     .help =
         "Tilting the head: the turn about the direction of view, after yaw and pitch. Positive leans the camera to "
         "the left, so the picture turns clockwise.",
     .formula = camera_formula},
    {.path = "camera.target",
     .place = IN(camera.target),
     .label = "target",
     .unit = length,
     .min = -position_limit,
     .max = position_limit,
     .step = 0.05,
     .help = "The point that orbiting turns about and at whose distance the depth step is stated. Changing it moves "
             "nothing by itself."},
    {.path = "camera.navigation",
     .place = IN(camera.navigation),
     .label = "navigation",
     .help =
         "How input moves the camera: fly has six degrees of freedom in the camera's own frame, walk has two on the "
         "ground (pan and forward), orbit turns about the target."},

    // projection
    {.path = "projection.type",
     .place = IN(projection.type),
     .label = "projection",
     .help =
         "Perspective makes far things small; orthographic keeps parallel lines parallel and sizes the same at every "
         "distance.",
     .gl_call = "glm::perspective | glm::ortho"},
    {.path = "projection.fovy",
     .place = IN(projection.fovy),
     .label = "fovy",
     .unit = degrees,
     .min = 1,
     .max = 179,
     .step = 0.5,
     .help = "The full vertical angle of view of the perspective. GLM takes it in radians: glm::radians(fovy).",
     .formula = "P₂₂ = 1 / tan(fovy / 2)",
     .gl_call = "glm::perspective"},
    {.path = "projection.height",
     .place = IN(projection.height),
     .label = "height",
     .unit = length,
     .min = 1e-3,
     .max = 1e4,
     .step = 0.05,
     .logarithmic = true,
     .help = "The full vertical size of the orthographic view; the width follows from the aspect ratio.",
     .formula = "P₂₂ = 2 / height",
     .gl_call = "glm::ortho"},
    {.path = "projection.near",
     .place = IN(projection.near),
     .label = "z-near",
     .unit = length,
     .min = 1e-6,
     .max = 1e6,
     .step = 0.01,
     .logarithmic = true,
     .help =
         "Distance of the near plane: what is closer is cut off. In a perspective with standard depth it decides the "
         "precision: a tenth of it makes the steps of depth far away ten times as wide.",
     .formula = frustum_formula,
     .gl_call = "glm::perspective | glm::ortho"},
    {.path = "projection.far",
     .place = IN(projection.far),
     .label = "z-far",
     .unit = length,
     .min = 1e-5,
     .max = 1e9,
     .step = 0.1,
     .logarithmic = true,
     .help =
         "Distance of the far plane: what is beyond is cut off. In perspective it costs hardly any depth precision; "
         "the near plane does.",
     .formula = frustum_formula,
     .gl_call = "glm::perspective | glm::ortho"},

    {.path = "projection.aspect",
     .place = IN(projection.aspect),
     .label = "aspect",
     .min = 0,
     .max = 10,
     .step = 0.01,
     .help = "The width of the picture in heights that the projection is made for; 0 is the view's own. With another "
             "one, GL stretches the picture to the view: perspective(45, 1, …) is right in a square window only.",
     .formula = "P₁₁ = P₂₂ / aspect",
     .gl_call = "glm::perspective | glm::ortho"},

    // depth
    {.path = "depth.buffer",
     .place = IN(depth.buffer),
     .label = "depth buffer",
     .help = "Whether the window was asked for a depth buffer at all. Without one there is nothing to compare with: "
             "the depth test passes always, whatever is set, and what is drawn last wins.",
     .gl_call = "glutInitDisplayMode(… | GLUT_DEPTH)"},
    {.path = "depth.test",
     .place = IN(depth.test),
     .label = "depth test",
     .help =
         "Compares each new fragment with the depth buffer. Off, whatever is drawn last wins, and the depth buffer is "
         "not written either.",
     .gl_call = "glEnable(GL_DEPTH_TEST)"},
    {.path = "depth.func",
     .place = IN(depth.func),
     .label = "depth function",
     .help = "The comparison that a new depth must pass against the stored one. ALWAYS is not the same as no test: it "
             "still writes depth. With reversed depth the program turns less and greater round.",
     .gl_call = "glDepthFunc"},
    {.path = "depth.write",
     .place = IN(depth.write),
     .label = "depth mask",
     .help = "Whether fragments that pass leave their depth behind. Off, objects are tested but hide nothing that is "
             "drawn later.",
     .gl_call = "glDepthMask"},
    {.path = "depth.clear",
     .place = IN(depth.clear),
     .label = "clear depth",
     .help = "Clears the depth buffer at the beginning of every frame. Without it, the depths of earlier frames go on "
             "hiding what is drawn now.",
     .gl_call = "glClear(GL_DEPTH_BUFFER_BIT)"},
    {.path = "depth.format",
     .place = IN(depth.format),
     .label = "depth format",
     .unit = "bits",
     .help = "How many bits each stored depth has: 16 or 24 as an integer, 32 as a float; 4 to 12 bits are emulated so "
             "that depth fighting can be seen with the naked eye.",
     .formula = "Δz ≈ z² (f−n) / (f·n·(2ᵇ − 1))",
     .gl_call = "glRenderbufferStorage"},
    {.path = "depth.mapping",
     .place = IN(depth.mapping),
     .label = "depth mapping",
     .help =
         "How eye distance becomes window depth: standard has 0 at near, reversed has 1 at near and spends a float's "
         "precision far away, logarithmic spends it evenly over the decades.",
     .formula = "reversed: d = n (f−z) / ((f−n)·z); logarithmic: d = ln(z/n) / ln(f/n)",
     .gl_call = "glClipControl, glClearDepth"},
    {.path = "depth.offset.factor",
     .place = IN(depth.offset.factor),
     .label = "offset factor",
     .min = -offset_limit,
     .max = offset_limit,
     .step = 0.1,
     .help = "Polygon offset of objects marked as decals, times the polygon's steepest depth slope m. Negative pulls "
             "towards the eye.",
     .formula = "offset = factor · m + units · r",
     .gl_call = "glPolygonOffset"},
    {.path = "depth.offset.units",
     .place = IN(depth.offset.units),
     .label = "offset units",
     .min = -offset_limit,
     .max = offset_limit,
     .step = 0.1,
     .help =
         "Polygon offset of objects marked as decals, in the smallest steps r that the depth buffer can tell apart. "
         "Too little stipples, too much bleeds through.",
     .formula = "offset = factor · m + units · r",
     .gl_call = "glPolygonOffset"},
    {.path = "depth.decals",
     .place = IN(depth.decals),
     .label = "decals by",
     .help = "What keeps objects marked as decals from fighting with what they lie on: a polygon offset; drawing them "
             "last where depth is EQUAL, which needs the very same triangles; or a stencil mark on what lies below "
             "and no depth test at all.",
     .gl_call = "glPolygonOffset | glDepthFunc(GL_EQUAL) | glStencilFunc"},
    {.path = "depth.write_while_clearing",
     .place = IN(depth.write_while_clearing),
     .label = "mask on while clearing",
     .help = "glClear obeys the depth mask. Off, it is called with the mask off, and clears no depth: the picture is "
             "drawn against the depths of the frame before.",
     .gl_call = "glDepthMask(GL_TRUE); glClear(GL_DEPTH_BUFFER_BIT)"},
    {.path = "depth.reversed_zero_to_one",
     .place = IN(depth.reversed_zero_to_one),
     .label = "clip range 0 to 1",
     .help = "Reversed depth pays off only where clip space goes from 0 to 1. Off, it goes from −1 to 1, and halving "
             "and adding a half rounds away what a float has near 0.",
     .gl_call = "glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE)"},
    {.path = "depth.reversed_clear",
     .place = IN(depth.reversed_clear),
     .label = "clear to 0",
     .help = "Reversed depth has 0 at the far plane, so that is what it is cleared to. Off, it is cleared to 1 as "
             "usual, nothing is greater, and nothing is drawn.",
     .gl_call = "glClearDepth(0)"},
    {.path = "depth.reversed_offset",
     .place = IN(depth.reversed_offset),
     .label = "turn the offset's sign",
     .help = "With reversed depth nearer is greater, so both signs of a polygon offset turn round. Off, they do not, "
             "and what should come nearer is pushed away.",
     .gl_call = "glPolygonOffset(−factor, −units)"},
    {.path = "depth.logarithm_per_vertex",
     .place = IN(depth.logarithm_per_vertex),
     .label = "per vertex",
     .help = "Takes the logarithm in the vertex shader and lets GL interpolate it. Cheaper, and wrong inside large "
             "triangles: between their corners depth is too far away, in an orthographic view too near.",
     .formula = "z_clip = (2 ln(w/n)/ln(f/n) − 1) · w",
     .gl_call = "gl_Position.z in place of gl_FragDepth"},

    // coplanar
    {.path = "coplanar.gap",
     .place = IN(coplanar.gap),
     .label = "gap",
     .unit = length,
     .min = 0,
     .max = 10,
     .step = 0.001,
     .help = "How far the front quad of each pair in the scene `coplanar` lies before the back one, along their "
             "normal."},
    {.path = "coplanar.tilt",
     .place = IN(coplanar.tilt),
     .label = "tilt",
     .unit = degrees,
     .min = 0,
     .max = 85,
     .step = 0.5,
     .help = "How far the pairs of the scene `coplanar` are turned out of the picture's plane. The more, the more "
             "codes lie across a quad, and the narrower the stripes."},
    {.path = "coplanar.distance",
     .place = IN(coplanar.distance),
     .label = "distance",
     .unit = length,
     .min = 1,
     .max = 1000,
     .step = 0.1,
     .logarithmic = true,
     .help = "How far the nearest pair of the scene `coplanar` is from the eye. All of them move and grow in "
             "proportion, so that the picture stays as it is but for the fighting."},

    // cull
    {.path = "cull.enabled",
     .place = IN(cull.enabled),
     .label = "cull face",
     .help =
         "Drops polygons by the side they show before they are rasterised: about half of those of closed objects. The "
         "enum is GL_CULL_FACE, not GL_CULL.",
     .gl_call = "glEnable(GL_CULL_FACE)"},
    {.path = "cull.face",
     .place = IN(cull.face),
     .label = "culled side",
     .help = "Which side is dropped. BACK is the usual choice; FRONT shows objects from inside. Shadows fall the same "
             "either way.",
     .gl_call = "glCullFace"},
    {.path = "cull.front_face",
     .place = IN(cull.front_face),
     .label = "front face",
     .help = "Which winding, seen on screen, counts as the front: counter-clockwise (CCW) as the objects are made, or "
             "clockwise (CW), which turns them inside out.",
     .gl_call = "glFrontFace"},

    // light
    {.path = "light.position",
     .place = IN(lights[element].position),
     .label = "light",
     .unit = length,
     .min = -position_limit,
     .max = position_limit,
     .step = 0.05,
     .help =
         "The light ℓ = (x, y, z, w): w = 1 is a point light at (x, y, z), w = 0 a parallel light that comes from the "
         "direction (x, y, z). Values between lie at (x, y, z) ÷ w.",
     .formula = shadow_formula},
    {.path = "lights",
     .place = [](Params& params, std::size_t) -> FieldRef { return Further<LightParams>{&params.lights}; },
     .label = "further lights",
     .help = "More lights, each like the first one, each with its own shadow."},

    // plane
    {.path = "plane.equation",
     .place = IN(planes[element].equation),
     .label = "plane",
     .min = -position_limit,
     .max = position_limit,
     .step = 0.01,
     .help =
         "The plane a x + b y + c z + d = 0 that receives the shadow and mirrors. (a, b, c) is its normal; length and "
         "sign change nothing in the picture.",
     .formula = "n·p + d = 0"},
    {.path = "plane.extent",
     .place = IN(planes[element].extent),
     .label = "extent",
     .unit = length,
     .min = 1e-3,
     .max = 1e4,
     .step = 0.05,
     .logarithmic = true,
     .help = "Half the side of the square patch that is drawn for the plane. The plane itself has no end: that is why "
             "shadows and reflections need the stencil at the patch's edge."},
    {.path = "plane.receives_shadow",
     .place = IN(planes[element].receives_shadow),
     .label = "receives shadows",
     .help = "Shadows fall on this plane."},
    {.path = "plane.mirrors",
     .place = IN(planes[element].mirrors),
     .label = "mirrors",
     .help = "This plane mirrors the scene."},
    {.path = "plane.gloss",
     .place = IN(planes[element].gloss),
     .label = "gloss",
     .help = "Gives the patch a highlight, which a shadow has to take away: blending only darkens it, missing light "
             "leaves it out."},
    {.path = "planes",
     .place = [](Params& params, std::size_t) -> FieldRef { return Further<PlaneParams>{&params.planes}; },
     .label = "further planes",
     .help = "More planes, each with its equation and extent, and whether it receives shadows and mirrors."},

    // shadow
    {.path = "shadow.enabled",
     .place = IN(shadow.enabled),
     .label = "shadow",
     .help = "Draws every object a second time, flattened onto the plane by S.",
     .formula = shadow_formula},
    {.path = "shadow.color",
     .place = IN(shadow.color),
     .label = "shadow colour",
     .help = "The colour that the flattened objects are painted with."},
    {.path = "shadow.opacity",
     .place = IN(shadow.opacity),
     .label = "opacity",
     .min = 0,
     .max = 1,
     .step = 0.01,
     .help = "How much of the shadow's colour replaces what lies under it: 0 nothing, 1 all.",
     .formula = "colour = opacity · shadow + (1 − opacity) · plane",
     .gl_call = "glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA)"},
    {.path = "shadow.stencil_once",
     .place = IN(shadow.stencil_once),
     .label = "stencil once",
     .help = "Lets each pixel be darkened only once. Off, a pixel that several flattened polygons cover is blended "
             "several times and gets darker.",
     .gl_call = "glStencilOp(GL_KEEP, GL_KEEP, GL_INVERT)"},
    {.path = "shadow.clip_to_receiver",
     .place = IN(shadow.clip_to_receiver),
     .label = "clip to receiver",
     .help =
         "Keeps the shadow inside the patch by its stencil mark. Off, the shadow hangs in the air beyond the floor's "
         "edge.",
     .gl_call = "glStencilFunc(GL_EQUAL, …)"},
    {.path = "shadow.clip_casters",
     .place = IN(shadow.clip_casters),
     .label = "clip casters",
     .help = "Lets only what lies between the light and the plane cast a shadow. Off, objects behind the plane throw a "
             "false shadow.",
     .gl_call = "gl_ClipDistance"},
    {.path = "shadow.offset",
     .place = IN(shadow.offset),
     .label = "shadow offset",
     .help =
         "What keeps the shadow from fighting with the plane it lies in: nothing, polygon offset in depth, lifting it "
         "along the normal, or drawing it without the depth test.",
     .gl_call = "glPolygonOffset | glDisable(GL_DEPTH_TEST)"},
    {.path = "shadow.offset_factor",
     .place = IN(shadow.offset_factor),
     .label = "factor",
     .min = -offset_limit,
     .max = offset_limit,
     .step = 0.1,
     .help = "The slope part of the shadow's polygon offset. Negative pulls the shadow towards the eye.",
     .formula = "offset = factor · m + units · r",
     .gl_call = "glPolygonOffset"},
    {.path = "shadow.offset_units",
     .place = IN(shadow.offset_units),
     .label = "units",
     .min = -offset_limit,
     .max = offset_limit,
     .step = 0.1,
     .help = "The constant part of the shadow's polygon offset, in the smallest steps of the depth buffer.",
     .formula = "offset = factor · m + units · r",
     .gl_call = "glPolygonOffset"},
    {.path = "shadow.lift",
     .place = IN(shadow.lift),
     .label = "lift",
     .unit = length,
     .min = 0,
     .max = 10,
     .step = 0.001,
     .help = "How far the shadow is lifted off the plane towards the eye's side when the offset is \"lift\". Seen at a "
             "grazing angle it parts from its object."},
    {.path = "shadow.style",
     .place = IN(shadow.style),
     .label = "style",
     .help =
         "blend paints the shadow's colour over the plane; missing_light leaves out what this light would have added, "
         "so that highlights vanish in the shadow and textures stay."},
    {.path = "shadow.clip_at_light",
     .place = IN(shadow.clip_at_light),
     .label = "clip at the light",
     .help = "Lets only what lies nearer to the plane than the light cast a shadow: cut where w is positive, triangle "
             "by triangle. Off, what crosses the plane through the light that is parallel to the receiver stretches to "
             "infinity.",
     .gl_call = "gl_ClipDistance"},
    {.path = "shadow.sign",
     .place = IN(shadow.sign),
     .label = "sign of S",
     .help = "What S is multiplied by before it is uploaded. plane_dot_light is the sign of Π·L, so that w is positive "
             "between light and plane; none uploads S as it is, and every shadow vanishes when the normal points away "
             "from the light; forced turns each vertex with a negative w around, and casters beyond the light throw an "
             "anti-shadow.",
     .formula = "sign(Π·L) S"},
    {.path = "shadow.write_depth",
     .place = IN(shadow.write_depth),
     .label = "write depth",
     .help = "Lets the shadow write its depth, offset included: the depths of the plane are no longer its own.",
     .gl_call = "glDepthMask"},
    {.path = "shadow.own_stencil",
     .place = IN(shadow.own_stencil),
     .label = "own stencil",
     .help = "Gives each plane a stencil value and each light a bit of its own. Off, they share one: where one shadow "
             "was counted the next is missing, and a shadow leaks from plane to plane.",
     .gl_call = "glStencilMask"},

    // reflection
    {.path = "reflection.enabled",
     .place = IN(reflection.enabled),
     .label = "reflection",
     .help = "Draws the scene a second time, mirrored by R, and lays the plane over it.",
     .formula = mirror_formula},
    {.path = "reflection.reflectance",
     .place = IN(reflection.reflectance),
     .label = "reflectance",
     .min = 0,
     .max = 1,
     .step = 0.01,
     .help = "How much of the mirrored picture shows in the plane: 0 a dull floor, 1 a perfect mirror.",
     .formula = "colour = reflectance · mirrored + (1 − reflectance) · plane"},
    {.path = "reflection.stencil",
     .place = IN(reflection.stencil),
     .label = "stencil mirror",
     .help = "Draws the mirrored scene only where the patch was marked in the stencil buffer. Off, it shows beyond the "
             "mirror's edge too.",
     .gl_call = "glStencilFunc(GL_EQUAL, …)"},
    {.path = "reflection.clip",
     .place = IN(reflection.clip),
     .label = "clip to mirror",
     .help =
         "How things behind the mirror are kept out of it: not at all, by a clip plane per vertex, or by an oblique "
         "near plane in the projection, which needs no extra hardware but measures depth from the mirror on: finer or "
         "coarser, by where one looks.",
     .formula = "oblique: row₃ = 2 c / (c·q) − row₄",
     .gl_call = "glEnable(GL_CLIP_DISTANCE0)"},
    {.path = "reflection.flip_winding",
     .place = IN(reflection.flip_winding),
     .label = "flip winding",
     .help = "A mirror turns counter-clockwise into clockwise (det R = −1), so front and back must change places while "
             "the mirrored scene is drawn. Off, it is culled inside out.",
     .formula = "det R = −1",
     .gl_call = "glFrontFace"},
    {.path = "reflection.reflect_light",
     .place = IN(reflection.reflect_light),
     .label = "reflect light",
     .help = "Mirrors the light together with the scene. Off, mirrored objects are lit from the wrong side.",
     .formula = "l′ = R l"},
    {.path = "reflection.bounces",
     .place = IN(reflection.bounces),
     .label = "bounces",
     .min = 0,
     .max = 16,
     .step = 1,
     .help = "How many mirrors a line of sight may meet one after the other. One plane needs 1; mirrors that face each "
             "other show more with each bounce."},
    {.path = "reflection.mirrored",
     .place = IN(reflection.mirrored),
     .label = "what is mirrored",
     .help = "Mirror the scene by R and look with the same camera, or mirror the camera and flip the picture left and "
             "right: the same picture.",
     .formula = "P V R = F P (F V R)"},
    {.path = "reflection.same_projection",
     .place = IN(reflection.same_projection),
     .label = "same projection",
     .help = "The mirrored camera sees with the camera's own projection. Off, it sees with the aspect of a square "
             "picture, and the image does not fit its mirror."},
    {.path = "reflection.printed_by_rows",
     .place = IN(reflection.printed_by_rows),
     .label = "as printed",
     .help = "Fills R by rows, as the lecture's code is printed. OpenGL reads columns, so it gets the transpose: right "
             "only where d = 0.",
     .formula = mirror_formula,
     .gl_call = "glUniformMatrix4fv"},
    {.path = "reflection.mask_writes_depth",
     .place = IN(reflection.mask_writes_depth),
     .label = "mask writes depth",
     .help = "Lets the mask leave the mirror's own depth behind: the image lies beyond it and is hidden.",
     .gl_call = "glDepthMask"},
    {.path = "reflection.after_objects",
     .place = IN(reflection.after_objects),
     .label = "mirror last",
     .help =
         "Draws the objects first and the mirror over them without a depth test: it covers what stands in front of it.",
     .gl_call = "glDisable(GL_DEPTH_TEST)"},
    {.path = "reflection.side_of_eye",
     .place = IN(reflection.side_of_eye),
     .label = "side of the eye",
     .help = "Mirrors what lies on the eye's side of the plane. Off, it is the normal's side, and a mirror seen from "
             "behind shows what lies behind it."},
    {.path = "reflection.shadows",
     .place = IN(reflection.shadows),
     .label = "shadows inside",
     .help = "Draws the shadows on the other planes inside the mirror too."},

    // overrides, follow
    {.path = "overrides.shadow_from_world",
     .place = IN(overrides[0].shadowed_world_from_world[0]),
     .label = "S by hand",
     .help =
         "Four rows put in place of the shadow matrix S, to see what each entry does; null computes S from light and "
         "plane.",
     .formula = shadow_formula},
    {.path = "overrides.mirror_from_world",
     .place = IN(overrides[0].mirrored_world_from_world),
     .label = "R by hand",
     .help = "Four rows put in place of the reflection matrix R, to see what each entry does; null computes R from the "
             "plane.",
     .formula = mirror_formula},
    {.path = "overrides.further",
     .place = [](Params& params, std::size_t) -> FieldRef { return FurtherOverrides{&params.overrides}; },
     .label = "further S and R by hand",
     .help = "Matrices put in place of S and R of further planes and lights, each with the numbers of its plane and "
             "light, counted from 1 on.",
     .formula = shadow_formula},
    {.path = "follow",
     .place = IN(follow),
     .label = "follow a point",
     .help = "The vertex p of an object that is followed on its way through the matrices to its shadow s = S p and its "
             "mirror image R p; null follows none.",
     .formula = "s = S p ÷ w"},

    // visibility
    {.path = "visibility.method",
     .place = IN(visibility.method),
     .label = "method",
     .help =
         "Who decides what is hidden: the depth buffer of the GPU, nobody, sorting (painter, Newell), a BSP tree, a "
         "depth buffer in software, or a ray through each pixel. All but the first draw with GL's depth test off. The "
         "slide puts all of this before rasterisation: sorting stands there, the depth test after it, fragment by "
         "fragment."},
    {.path = "visibility.step",
     .place = IN(visibility.step),
     .label = "step",
     .min = -1,
     .max = 1e9,
     .step = 1,
     .help = "Stops the method after so many of its steps, to watch it work; −1 runs all of them."},
    {.path = "visibility.sort_key",
     .place = IN(visibility.sort_key),
     .label = "sort key",
     .help =
         "What the painter sorts polygons by: the distance of the nearest vertex, the farthest one, or the centroid. "
         "Each of them fails on some scene."},
    {.path = "visibility.splitter",
     .place = IN(visibility.splitter),
     .label = "splitter",
     .help = "Which polygon becomes the root when a BSP tree is built: the first, a random one, the one that cuts the "
             "fewest others, or the one that divides them most evenly."},
    {.path = "visibility.walk",
     .place = IN(visibility.walk),
     .label = "walk",
     .help =
         "How a BSP tree is drawn: from back to front, each polygon over the ones before; or from front to back, "
         "where a mask of the pixels already covered keeps what is there. The walk goes by the eye; the tree itself, "
         "which the slide divides \"according to the viewer direction\", does not."},
    {.path = "visibility.epsilon",
     .place = IN(visibility.epsilon),
     .label = "epsilon",
     .unit = "diagonals of the scene",
     .min = 1e-12,
     .max = 0.1,
     .step = 1e-9,
     .logarithmic = true,
     .help = "How near to a plane a corner may be and still count as on it, when BSP and Newell cut polygons. Too "
             "large, and what should be cut is not: seams are torn and orders wrong."},
    {.path = "visibility.exact_curves",
     .place = IN(visibility.exact_curves),
     .label = "exact curves",
     .help = "Rays meet spheres, cylinders, cones and tori by their equations, not their triangles: silhouettes are "
             "round at any distance, which is what ray casting is praised for."},
    {.path = "visibility.compare_with",
     .place = IN(visibility.compare_with),
     .label = "compare with",
     .help = "The method that the difference view holds this one against: pixels where they see different polygons, "
             "away from edges, are red."},
    {.path = "visibility.numbers",
     .place = IN(visibility.numbers),
     .label = "numbers",
     .help = "Writes on each polygon the place it has in the drawing order."},
    {.path = "visibility.raster",
     .place = IN(visibility.raster),
     .label = "raster",
     .unit = "pixels",
     .min = 1,
     .max = 256,
     .step = 1,
     .help = "Columns and rows of the picture that a method finds, shown as large squares with the depth in each; "
             "null takes the view's own pixels. GL's depth buffer draws those in any case. Shadow and mirror wait."},
    {.path = "visibility.pixel",
     .place = IN(visibility.pixel),
     .label = "chosen pixel",
     .unit = "pixels",
     .min = 0,
     .max = 16383,
     .step = 1,
     .help = "The pixel of that picture, from the top left one on, whose fragments are listed, whose next fragment "
             "one can go to, and whose ray is shown; null is none."},

    // view
    {.path = "view.shows",
     .place = IN(view.shows),
     .label = "shows",
     .help = "Which buffer the camera view shows: colour, depth (near black, far white), stencil, which side of each "
             "polygon faces the eye, how often each pixel was drawn, where two hidden-surface methods differ, or where "
             "the gap between two flat surfaces is less than depth is sure to tell apart (fighting)."},
    {.path = "view.depth_scale",
     .place = IN(view.depth_scale),
     .label = "depth scale",
     .help =
         "window shows the depth as it is stored, which standard depth in a perspective leaves nearly white; linear "
         "shows the distance from the eye between near and far."},
    {.path = "view.depth_colors",
     .place = IN(view.depth_colors),
     .label = "depth colours",
     .help = "Depth as greys, or as bands of colour that tell neighbouring depths apart and show how they are spread."},
    {.path = "view.depth_range",
     .place = IN(view.depth_range),
     .label = "depth range",
     .unit = length,
     .min = 1e-6,
     .max = 1e9,
     .step = 0.01,
     .logarithmic = true,
     .help = "The eye distances that depth pictures show as black and white; null is near and far in the camera's own "
             "picture, and what is in view in the ones beside and below it. The depths stay as they are."},
    {.path = "view.samples",
     .place = IN(view.samples),
     .label = "samples",
     .min = 0,
     .max = 4,
     .step = 4,
     .help = "Multisampling of the colour picture: 4 samples for smooth edges, 0 for none.",
     .gl_call = "glRenderbufferStorageMultisample"},
    {.path = "view.plane",
     .place = IN(view.plane),
     .label = "chosen plane",
     .min = 1,
     .max = most_planes,
     .step = 1,
     .help = "The plane that derivations, the followed point, the lecture's code, S and R by hand, the handles and the "
             "light's view are about: 1 is `plane`, 2 the first of `planes`."},
    {.path = "view.light",
     .place = IN(view.light),
     .label = "chosen light",
     .min = 1,
     .max = most_lights,
     .step = 1,
     .help = "The light that they are about, and that orbits: 1 is `light`, 2 the first of `lights`."},
    {.path = "view.beside.shows",
     .place = IN(view.beside.shows),
     .label = "beside it",
     .help = "A second picture in the camera view: the depth buffer, or the same picture with another depth format and "
             "mapping."},
    {.path = "view.beside.layout",
     .place = IN(view.beside.layout),
     .label = "layout",
     .help = "Two whole pictures in two halves, or one picture with a line to drag across it."},
    {.path = "view.beside.share",
     .place = IN(view.beside.share),
     .label = "divider",
     .min = 0,
     .max = 1,
     .step = 0.01,
     .help = "The part of the camera view that lies left of the divider."},
    {.path = "view.beside.format",
     .place = IN(view.beside.format),
     .label = "other format",
     .unit = "bits",
     .help = "The depth format of the second picture."},
    {.path = "view.beside.mapping",
     .place = IN(view.beside.mapping),
     .label = "other mapping",
     .help = "The depth mapping of the second picture."},
    {.path = "view.pixel",
     .place = IN(view.pixel),
     .label = "pinned pixel",
     .unit = "pixels",
     .min = 0,
     .max = 16383,
     .step = 1,
     .help = "The pixel of the camera view that the pixel and cell views tell about, from the top left one on; null is "
             "the one under the pointer."},
    {.path = "view.pin",
     .place = IN(view.pin),
     .label = "pin",
     .min = 0,
     .max = 1,
     .step = 0.01,
     .help = "The pinned pixel by what lies there, so that it is the same place at every size: an object of the scene "
             "and a fraction of its box in the picture, from the top left, left out for the middle of what is visible "
             "of it; or without an object a fraction of the view. It goes before the pinned pixel; null is none."},
    {.path = "view.cells",
     .place = IN(view.cells),
     .label = "cells",
     .unit = "pixels",
     .min = 1,
     .max = 64,
     .step = 1,
     .help = "Columns and rows of the block around that pixel which the cell view shows, in the middle of the picture "
             "until there is one; null shows as many as can be read."},
    {.path = "view.call",
     .place = IN(view.call),
     .label = "draw call",
     .min = -1,
     .max = 1e9,
     .step = 1,
     .help = "Draws no further than this draw call of the frame, from 0 on, to watch the buffers fill; −1 draws all."},
    {.path = "view.triangle",
     .place = IN(view.triangle),
     .label = "triangle",
     .min = -1,
     .max = 1e9,
     .step = 1,
     .help = "Draws only so many triangles of that draw call; −1 draws all of them."},
    {.path = "view.pass",
     .place = IN(view.pass),
     .label = "pass",
     .min = -1,
     .max = 1e6,
     .step = 1,
     .help = "Stops the frame after this pass, from 0 on, to see what each one leaves in colour, depth and stencil; −1 "
             "draws all of them."},
    {.path = "view.derivation_step",
     .place = IN(view.derivation_step),
     .label = "derivation step",
     .min = -1,
     .max = 1000,
     .step = 1,
     .help =
         "How many lines of the derivation of shadow or mirror image are written, from 0 on; −1 writes all of them."},
    {.path = "view.lower_left",
     .place = IN(view.lower_left),
     .label = "lower left",
     .help = "What the view below the camera's on the left shows; automatic is the observer."},
    {.path = "view.lower_right",
     .place = IN(view.lower_right),
     .label = "lower right",
     .help = "What the view below the camera's on the right shows; automatic goes by the hidden-surface method."},

    {.path = "view.layout.big",
     .place = IN(view.layout.big),
     .label = "large",
     .help = "What fills the place of all views: one of them, or the matrices; none shares it as usual."},
    {.path = "view.layout.matrices",
     .place = IN(view.layout.matrices),
     .label = "matrices",
     .help =
         "The matrices that are shown, in this order: S, R, the followed point, V, C, P and the lecture's display(); "
         "an empty list shows all as usual."},
    {.path = "view.layout.controls",
     .place = IN(view.layout.controls),
     .label = "controls",
     .help = "The controls that the panel shows, by the paths of fields and groups; an empty list shows all."},
    {.path = "view.layout.folded",
     .place = IN(view.layout.folded),
     .label = "folded",
     .help = "Which columns are folded away: the panel, the matrices."},

    // observer
    {.path = "observer.target",
     .place = IN(observer.target),
     .label = "observer target",
     .unit = length,
     .min = -position_limit,
     .max = position_limit,
     .step = 0.05,
     .help = "The point that the observer, who sees camera, frustum, light and plane from outside, looks at and turns "
             "about."},
    {.path = "observer.yaw",
     .place = IN(observer.yaw),
     .label = "observer yaw",
     .unit = degrees,
     .min = -turns_limit_deg,
     .max = turns_limit_deg,
     .step = 0.5,
     .help = "The observer's turn about the y axis through its target."},
    {.path = "observer.pitch",
     .place = IN(observer.pitch),
     .label = "observer pitch",
     .unit = degrees,
     .min = -90,
     .max = 90,
     .step = 0.5,
     .help = "How steeply the observer looks: negative from above, positive from below."},
    {.path = "observer.distance",
     .place = IN(observer.distance),
     .label = "observer distance",
     .unit = length,
     .min = 1e-3,
     .max = 1e6,
     .step = 0.1,
     .logarithmic = true,
     .help = "How far the observer is from its target."},
    {.path = "observer.light_rays",
     .place = IN(observer.light_rays),
     .label = "light rays",
     .help = "Rays from the light through the vertices of each object's outline to their shadow."},
    {.path = "observer.mirrored_eye",
     .place = IN(observer.mirrored_eye),
     .label = "mirrored eye",
     .help = "The eye on the other side of the mirror, and the frustum through which it would see the same image."},
    {.path = "observer.image_space",
     .place = IN(observer.image_space),
     .label = "image space",
     .help = "The scene once more behind the mirror, where its image seems to be."},

    // slips
    {.path = "slips.walk_slows",
     .place = IN(slips.walk_slows),
     .label = "walk slows",
     .help = "A famous slip: walking moves along the direction of view and then sets the height back, so that one gets "
             "slower the more one looks up or down."},
    {.path = "slips.creeping_roll",
     .place = IN(slips.creeping_roll),
     .label = "creeping roll",
     .help = "A famous slip: walking and orbiting turn yaw about the camera's own axis in place of the world's, and a "
             "roll that nobody asked for creeps in."},
    {.path = "slips.pole_flip",
     .place = IN(slips.pole_flip),
     .label = "pole flip",
     .help = "A famous slip: orbiting builds the view from a fixed up vector without a limit on pitch, and the picture "
             "flips over at the pole.",
     .gl_call = "glm::lookAt"},
    {.path = "slips.swapped_order",
     .place = IN(slips.swapped_order),
     .label = "R T for T R",
     .help =
         "A famous slip: the camera's matrix is multiplied in the wrong order, so that its position is turned along "
         "with it.",
     .formula = "C = R T ≠ T R"},
    {.path = "slips.camera_as_view",
     .place = IN(slips.camera_as_view),
     .label = "C for V",
     .help = "A famous slip: the camera's own matrix is sent where its inverse belongs, and everything moves the wrong "
             "way.",
     .formula = "C ≠ V = C⁻¹"},
    {.path = "slips.degrees_as_radians",
     .place = IN(slips.degrees_as_radians),
     .label = "degrees as radians",
     .help = "The slide's perspective(45, …): fovy's number of degrees is handed over where GLM takes radians. 45 "
             "radians look like 58.3°, so the picture is believable.",
     .formula = "P₂₂ = 1 / tan(fovy / 2), fovy read as radians",
     .gl_call = "glm::perspective(45.f, …)"},
    {.path = "slips.plus_2ab",
     .place = IN(slips.plus_2ab),
     .label = "+2ab in R",
     .help = "A sign lost in the slide's expansion: row 2, column 1 of R is +2ab in place of −2ab. It shows where the "
             "plane's normal has both an x and a y.",
     .formula = "R₂₁ = −2ab"},
    {.path = "slips.normal_not_unit",
     .place = IN(slips.normal_not_unit),
     .label = "n not divided by |n|",
     .help = "R is filled from (a, b, c, d) as they are typed. The formula holds for a normal of length 1; with a "
             "longer one points are thrown too far.",
     .formula = mirror_formula},

    // animation
    {.path = "animation.jiggle",
     .place = IN(animation.jiggle),
     .label = "jiggle",
     .help = "Lets the camera tremble by a thousandth of the target's distance: surfaces stay where they are, but the "
             "stripes of depth fighting crawl."},
    {.path = "animation.light_orbit",
     .place = IN(animation.light_orbit),
     .label = "light orbits",
     .help = "Lets the chosen light turn about the y axis of the world."},
    {.path = "animation.light_speed",
     .place = IN(animation.light_speed),
     .label = "speed",
     .unit = "°/s",
     .min = -360,
     .max = 360,
     .step = 1,
     .help = "How fast the light turns; negative the other way round."},

    // ui
    {.path = "ui.theme",
     .place = IN(ui.theme),
     .label = "theme",
     .help =
         "The colours of the window: dark, light, or projector with larger type and heavier lines for a bright room."},
    {.path = "ui.scale",
     .place = IN(ui.scale),
     .label = "scale",
     .min = 0.5,
     .max = 4,
     .step = 0.05,
     .help = "The size of type and controls, on top of what the screen asks for."},
    {.path = "ui.language",
     .place = IN(ui.language),
     .label = "language",
     .help = "The language of the window and of the lessons. States, matrices and calls of GL are the same in each."},
};

#undef IN

}  // namespace

std::span<const Field> fields() {
    return all_fields;
}

std::string_view group_of(std::string_view path) {
    const std::size_t dot = path.rfind('.');
    return dot == std::string_view::npos ? "" : path.substr(0, dot);
}

bool is_in(std::string_view path, std::string_view group) {
    return path.starts_with(group) && (path.size() == group.size() || path[group.size()] == '.');
}

std::vector<const Field*> fields_of(std::string_view group) {
    std::vector<const Field*> found;
    for (const Field& field : all_fields) {
        if (field.path.substr(0, field.path.rfind('.')) == group) {
            found.push_back(&field);
        }
    }
    return found;
}

std::vector<std::string> known_paths() {
    std::vector<std::string> paths;
    for (const Field& field : all_fields)
        for (std::string_view path = field.path; !path.empty(); path = group_of(path))
            if (std::find(paths.begin(), paths.end(), path) == paths.end()) paths.emplace_back(path);
    return paths;
}

std::vector<std::string> allowed_names(const Field& field) {
    if (field.path == "view.layout.matrices") return {"S", "R", "follow", "V", "C", "P", "display"};
    if (field.path == "view.layout.folded") return {"panel", "matrices"};
    return known_paths();
}

std::size_t element_count(const Field& field, const Params& params) {
    return field.path.starts_with("light.")   ? params.lights.size()
           : field.path.starts_with("plane.") ? params.planes.size()
                                              : 1;
}

const Field* find_field(std::string_view path) {
    const auto found = std::find_if(std::begin(all_fields), std::end(all_fields),
                                    [path](const Field& field) { return field.path == path; });
    return found == std::end(all_fields) ? nullptr : &*found;
}

const Field& field(std::string_view path) {
    const Field* found = find_field(path);
    assert(found != nullptr);
    return *found;
}

}  // namespace viewing
