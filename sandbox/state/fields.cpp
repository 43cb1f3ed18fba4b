// The list of all fields, in the order of the state file, and the names of the enumerations. This file is long because
// it is a table. Its wording follows the lecture. Read ranges.cpp next, then file/state_json.h.
#include "state/fields.h"

#include <algorithm>
#include <cassert>
#include <type_traits>

namespace viewing {

// clang-format off
template <> std::span<const char* const> names_of<Navigation>() { static constexpr const char* names[] = {"fly", "walk", "orbit"}; return names; }
template <> std::span<const char* const> names_of<ProjectionType>() { static constexpr const char* names[] = {"perspective", "orthographic", "frustum", "orthographic_window"}; return names; }
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
template <> std::span<const char* const> names_of<VisibilityMethod>() { static constexpr const char* names[] = {VIEWING_METHODS(VIEWING_NAME)}; return names; }
template <> std::span<const char* const> names_of<PainterKey>() { static constexpr const char* names[] = {"nearest", "farthest", "centroid"}; return names; }
template <> std::span<const char* const> names_of<BspSplitter>() { static constexpr const char* names[] = {"first", "random", "fewest_splits", "balanced"}; return names; }
template <> std::span<const char* const> names_of<BspOrder>() { static constexpr const char* names[] = {"back_to_front", "front_to_back"}; return names; }
template <> std::span<const char* const> names_of<Shows>() { static constexpr const char* names[] = {"color", "depth", "stencil", "facing", "overdraw", "difference", "fighting", "shadow_w"}; return names; }
template <> std::span<const char* const> names_of<DepthScale>() { static constexpr const char* names[] = {"window", "linear"}; return names; }
template <> std::span<const char* const> names_of<DecalMethod>() { static constexpr const char* names[] = {"offset", "equal", "stencil"}; return names; }
template <> std::span<const char* const> names_of<DepthColors>() { static constexpr const char* names[] = {"grey", "bands"}; return names; }
template <> std::span<const char* const> names_of<Beside>() { static constexpr const char* names[] = {"nothing", "depth", "other_depth", "settings"}; return names; }
template <> std::span<const char* const> names_of<BesideLayout>() { static constexpr const char* names[] = {"halves", "divider"}; return names; }
template <> std::span<const char* const> names_of<Topic>() { static constexpr const char* names[] = {"automatic", VIEWING_LOWER_VIEWS(VIEWING_NAME, VIEWING_NAME)}; return names; }
template <> std::span<const char* const> names_of<ViewName>() { static constexpr const char* names[] = {"none", "camera", "lower_left", "lower_right", "matrices"}; return names; }
template <> std::span<const char* const> names_of<Theme>() { static constexpr const char* names[] = {"dark", "light", "projector"}; return names; }
template <> std::span<const char* const> names_of<Language>() { static constexpr const char* names[] = {"en", "ko"}; return names; }
template <> std::span<const char* const> names_of<ShapeKind>() { static constexpr const char* names[] = {"box", "sphere", "torus", "cylinder", "cone", "quad", "triangle", "teapot", "mesh"}; return names; }
// clang-format on

namespace {

/// Refers to an enumeration by its names and index, and to any other value by its address.
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

constexpr int sample_counts[] = {0, 4};
constexpr const char* matrix_names[] = {"S", "R", "follow", "V", "C", "P", "display"};
constexpr const char* column_names[] = {"panel", "matrices"};

constexpr std::string_view length = "world units";
constexpr std::string_view degrees = "°";
constexpr std::string_view camera_formula = "C = T(position) · R_y(yaw) · R_x(pitch) · R_z(roll), V = C⁻¹";
constexpr std::string_view frustum_formula = "d = f/(f−n) − f·n/((f−n)·z) (perspective, standard depth)";
constexpr std::string_view window_call = "glFrustum | glOrtho";
constexpr std::string_view shadow_formula = "S = (Π·L) I − L Πᵀ";
constexpr std::string_view mirror_formula = "R p = p − 2 (n·p + d) n, |n| = 1";

using enum Idle;

const Field all_fields[] = {
    {.path = "version",
     .place = IN(version),
     .label = "version",
     .has_control = false,
     .min = 1,
     .max = 1,
     .step = 1,
     .help = "The version of the state file format. This program reads version 1."},
    {.path = "scene",
     .place = IN(scene),
     .label = "scene",
     .has_control = false,
     .help = "The scene to look at: the name of a built-in scene, the path of a scene or OBJ file, or the objects "
             "themselves."},

    // camera
    {.path = "camera.position",
     .place = IN(camera.position),
     .label = "position",
     .unit = length,
     .min = -position_limit,
     .max = position_limit,
     .step = 0.05,
     .help = "The eye's position in world coordinates. Moving the camera by +10 along z gives the same picture as "
             "moving the world by −10.",
     .formula = camera_formula},
    {.path = "camera.yaw",
     .place = IN(camera.yaw),
     .label = "yaw",
     .unit = degrees,
     .min = -turns_limit_deg,
     .max = turns_limit_deg,
     .step = 0.5,
     .help = "Yaw (heading on the slides): the rotation about the y axis, positive to the left. At 0, the camera looks "
             "along −z. Walking changes only this angle.",
     .formula = camera_formula},
    {.path = "camera.pitch",
     .place = IN(camera.pitch),
     .label = "pitch",
     .unit = degrees,
     .min = -180,
     .max = 180,
     .step = 0.5,
     .help = "Looking up (positive) or down (negative): the rotation about the camera's own x axis, after yaw. Beyond "
             "±90°, the camera is upside down.",
     .formula = camera_formula},
    {.path = "camera.roll",
     .place = IN(camera.roll),
     .label = "roll",
     .unit = degrees,
     .min = -turns_limit_deg,
     .max = turns_limit_deg,
     .step = 0.5,
     .help = "Tilting the head: the rotation about the view direction, after yaw and pitch. Positive leans the camera "
             "to the left, so the picture turns clockwise.",
     .formula = camera_formula},
    {.path = "camera.target",
     .place = IN(camera.target),
     .label = "target",
     .unit = length,
     .min = -position_limit,
     .max = position_limit,
     .step = 0.05,
     .help = "The point that the camera orbits about; the depth step is reported at its distance. Changing this point "
             "does not move anything by itself."},
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
     .idle = {p_by_hand},
     .help = "Perspective makes distant objects small; orthographic keeps parallel lines parallel and sizes the same "
             "at every distance. A frustum and an orthographic window take the picture's four edges as glFrustum and "
             "glOrtho do: they need not be centered on the view axis, and they fill the view whatever its shape.",
     .gl_call = "glm::perspective | glm::ortho | glm::frustum"},
    {.path = "projection.fovy",
     .place = IN(projection.fovy),
     .label = "fovy",
     .unit = degrees,
     .min = 1,
     .max = 179,
     .step = 0.5,
     .idle = {p_by_hand, orthographic, has_window},
     .help =
         "The full vertical field of view of the perspective projection. GLM takes it in radians: glm::radians(fovy).",
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
     .idle = {p_by_hand, not_orthographic, has_window},
     .help = "The full vertical size of the orthographic view; the width follows from the aspect ratio.",
     .formula = "P₂₂ = 2 / height",
     .gl_call = "glm::ortho"},
    {.path = "projection.near",
     .place = IN(projection.near),
     .label = "z-near",
     .unit = length,
     .min = -1e6,
     .max = 1e6,
     .step = 0.01,
     .logarithmic = true,
     .idle = {p_by_hand},
     .help =
         "Distance of the near plane: everything closer is clipped. In perspective with standard depth, this distance "
         "decides the precision: a tenth of the distance makes the depth steps far away ten times as wide. Perspective "
         "and logarithmic depth need at least 1e-6; an orthographic near may be 0 or negative, as in glOrtho.",
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
     .may_be_infinite = true,
     .idle = {p_by_hand},
     .help = "Distance of the far plane: everything beyond is clipped. In perspective, it hardly affects depth "
             "precision; the near plane does. Unless depth is logarithmic, it may be infinite in perspective and in a "
             "frustum: then nothing is too far, and with standard depth, P's third row is 0, 0, −1, −2n.",
     .formula = frustum_formula,
     .gl_call = "glm::perspective | glm::ortho"},

    {.path = "projection.aspect",
     .place = IN(projection.aspect),
     .label = "aspect",
     .min = 0,
     .max = 10,
     .step = 0.01,
     .least_above_zero = min_aspect,
     .idle = {p_by_hand, has_window},
     .help = "The aspect ratio (width ÷ height) that the projection assumes; 0 uses the view's own. With another "
             "value, GL stretches the picture to the view: perspective(45, 1, …) is right only in a square window.",
     .formula = "P₁₁ = P₂₂ / aspect",
     .gl_call = "glm::perspective | glm::ortho"},
    {.path = "projection.left",
     .place = IN(projection.left),
     .label = "left",
     .unit = length,
     .min = -window_limit,
     .max = window_limit,
     .step = 0.01,
     .idle = {p_by_hand, no_window},
     .help = "The left edge of the picture, measured to the right of the view axis: at the near plane in a frustum, at "
             "every distance in an orthographic window. Must be less than right.",
     .formula = "P₁₁ = 2n / (r − l), P₁₃ = (r + l) / (r − l)",
     .gl_call = window_call},
    {.path = "projection.right",
     .place = IN(projection.right),
     .label = "right",
     .unit = length,
     .min = -window_limit,
     .max = window_limit,
     .step = 0.01,
     .idle = {p_by_hand, no_window},
     .help = "The right edge of the picture, measured to the right of the view axis, at the same distance as left. If "
             "left and right are not opposite numbers, the view axis does not meet the middle of the picture.",
     .formula = "P₁₁ = 2n / (r − l), P₁₃ = (r + l) / (r − l)",
     .gl_call = window_call},
    {.path = "projection.bottom",
     .place = IN(projection.bottom),
     .label = "bottom",
     .unit = length,
     .min = -window_limit,
     .max = window_limit,
     .step = 0.01,
     .idle = {p_by_hand, no_window},
     .help = "The lower edge of the picture, measured upward from the view axis, at the same distance as left. Must be "
             "less than top.",
     .formula = "P₂₂ = 2n / (t − b), P₂₃ = (t + b) / (t − b)",
     .gl_call = window_call},
    {.path = "projection.top",
     .place = IN(projection.top),
     .label = "top",
     .unit = length,
     .min = -window_limit,
     .max = window_limit,
     .step = 0.01,
     .idle = {p_by_hand, no_window},
     .help = "The upper edge of the picture, measured upward from the view axis, at the same distance as left.",
     .formula = "P₂₂ = 2n / (t − b), P₂₃ = (t + b) / (t − b)",
     .gl_call = window_call},

    // depth
    {.path = "depth.buffer",
     .place = IN(depth.buffer),
     .label = "depth buffer",
     .idle = {no_gl_depth_test},
     .help = "Requests a depth buffer for the window. Without one there is nothing to compare with: whatever the "
             "settings, the depth test always passes and the last fragment drawn wins.",
     .gl_call = "glutInitDisplayMode(… | GLUT_DEPTH)"},
    {.path = "depth.test",
     .place = IN(depth.test),
     .label = "depth test",
     .idle = {no_gl_depth_test, no_depth_buffer},
     .help = "Compares each new fragment with the depth buffer. When off, the last fragment drawn wins, and no depth "
             "is written either.",
     .gl_call = "glEnable(GL_DEPTH_TEST)"},
    {.path = "depth.func",
     .place = IN(depth.func),
     .label = "depth function",
     .idle = {no_gl_depth_test, no_depth_buffer, no_depth_test},
     .help = "The comparison that a new depth must pass against the stored one. ALWAYS is not the same as no test: it "
             "still writes depth. With reversed depth, the program swaps less and greater.",
     .gl_call = "glDepthFunc"},
    {.path = "depth.write",
     .place = IN(depth.write),
     .label = "depth mask",
     .idle = {no_gl_depth_test, no_depth_buffer, no_depth_test},
     .help = "Lets fragments that pass write their depth. When off, objects are tested but hide nothing that is drawn "
             "later.",
     .gl_call = "glDepthMask"},
    {.path = "depth.clear",
     .place = IN(depth.clear),
     .label = "clear depth",
     .idle = {no_gl_depth_test, no_depth_buffer},
     .help = "Clears the depth buffer at the start of every frame. Otherwise, depths from earlier frames keep hiding "
             "new fragments.",
     .gl_call = "glClear(GL_DEPTH_BUFFER_BIT)"},
    {.path = "depth.format",
     .place = IN(depth.format),
     .label = "depth format",
     .unit = "bits",
     .help = "Bits per stored depth: 16 or 24 as an integer, 32 as a float; 4 to 12 bits are emulated, so that depth "
             "fighting is visible to the naked eye.",
     .formula = "Δz ≈ z² (f−n) / (f·n·(2ᵇ − 1))",
     .gl_call = "glRenderbufferStorage"},
    {.path = "depth.mapping",
     .place = IN(depth.mapping),
     .label = "depth mapping",
     .help = "How eye distance maps to window depth: standard has 0 at near; reversed has 1 at near and spends a "
             "float's precision far away; logarithmic spreads precision evenly over the decades.",
     .formula = "reversed: d = n (f−z) / ((f−n)·z); logarithmic: d = ln(z/n) / ln(f/n)",
     .gl_call = "glClipControl, glClearDepth"},
    {.path = "depth.offset.factor",
     .place = IN(depth.offset.factor),
     .label = "offset factor",
     .min = -offset_limit,
     .max = offset_limit,
     .step = 0.1,
     .idle = {no_decals, no_decal_offset},
     .help = "Polygon offset of objects marked as decals, as a multiple of the polygon's steepest depth slope m. A "
             "negative value pulls decals toward the eye.",
     .formula = "offset = factor · m + units · r",
     .gl_call = "glPolygonOffset"},
    {.path = "depth.offset.units",
     .place = IN(depth.offset.units),
     .label = "offset units",
     .min = -offset_limit,
     .max = offset_limit,
     .step = 0.1,
     .idle = {no_decals, no_decal_offset},
     .help = "Polygon offset of objects marked as decals, in the smallest steps r that the depth buffer can resolve. "
             "With too little, decals are stippled; with too much, they bleed through nearer surfaces.",
     .formula = "offset = factor · m + units · r",
     .gl_call = "glPolygonOffset"},
    {.path = "depth.decals",
     .place = IN(depth.decals),
     .label = "decals by",
     .idle = {no_decals},
     .help = "How objects marked as decals are kept from fighting with the surface below: by a polygon offset; by "
             "drawing them last where depth is EQUAL, which needs identical triangles; or by a stencil mark on the "
             "surface below, with no depth test at all.",
     .gl_call = "glPolygonOffset | glDepthFunc(GL_EQUAL) | glStencilFunc"},
    {.path = "depth.clear_value",
     .place = IN(depth.clear_value),
     .label = "clear value",
     .min = 0,
     .max = 1,
     .step = 0.01,
     .idle = {no_gl_depth_test, no_depth_buffer, no_depth_clear},
     .help =
         "The depth that every pixel starts with: 1 is the farthest, so that every surface is nearer. With 0, nothing "
         "is nearer, and nothing is drawn. Reversed depth is cleared to 1 minus this value.",
     .gl_call = "glClearDepth(1)"},
    {.path = "depth.write_while_clearing",
     .place = IN(depth.write_while_clearing),
     .label = "mask on while clearing",
     .idle = {no_depth_buffer, no_depth_clear},
     .help = "glClear obeys the depth mask. When off, glClear is called with the mask off and clears no depth: new "
             "fragments are tested against depths from the previous frame.",
     .gl_call = "glDepthMask(GL_TRUE); glClear(GL_DEPTH_BUFFER_BIT)"},
    {.path = "depth.reversed_zero_to_one",
     .place = IN(depth.reversed_zero_to_one),
     .label = "clip range 0 to 1",
     .idle = {not_reversed},
     .help = "Reversed depth pays off only if z in clip space goes from 0 to 1. When off, z goes from −1 to 1, and "
             "halving it and adding a half rounds away the precision that a float has near 0.",
     .gl_call = "glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE)"},
    {.path = "depth.reversed_clear",
     .place = IN(depth.reversed_clear),
     .label = "clear to 0",
     .idle = {no_depth_buffer, not_reversed, no_depth_clear},
     .help = "Reversed depth is 0 at the far plane, so the buffer is cleared to 0. When off, it is cleared to 1 as "
             "usual: nothing is greater than 1, so nothing is drawn.",
     .gl_call = "glClearDepth(0)"},
    {.path = "depth.reversed_offset",
     .place = IN(depth.reversed_offset),
     .label = "flip the offset's sign",
     .idle = {not_reversed},
     .help = "With reversed depth, nearer means greater, so both signs of a polygon offset flip. When off, the signs "
             "do not flip, and surfaces are pushed away from the eye instead of pulled toward it.",
     .gl_call = "glPolygonOffset(−factor, −units)"},
    {.path = "depth.logarithm_per_vertex",
     .place = IN(depth.logarithm_per_vertex),
     .label = "per vertex",
     .idle = {not_logarithmic},
     .help = "Computes the logarithm in the vertex shader and lets GL interpolate it. Cheaper, but wrong inside large "
             "triangles: between vertices, the depth is too large, or too small in an orthographic view.",
     .formula = "z_clip = (2 ln(w/n)/ln(f/n) − 1) · w",
     .gl_call = "gl_Position.z instead of gl_FragDepth"},

    // coplanar
    {.path = "coplanar.gap",
     .place = IN(coplanar.gap),
     .label = "gap",
     .unit = length,
     .min = 0,
     .max = 10,
     .step = 0.001,
     .idle = {no_pairs},
     .help = "Distance from the back quad to the front quad of each pair in the scene `coplanar`, along their normal."},
    {.path = "coplanar.tilt",
     .place = IN(coplanar.tilt),
     .label = "tilt",
     .unit = degrees,
     .min = 0,
     .max = 85,
     .step = 0.5,
     .idle = {no_pairs},
     .help = "Angle by which the pairs of the scene `coplanar` are rotated out of the picture plane. The larger the "
             "angle, the more depth codes each quad spans and the narrower the stripes."},
    {.path = "coplanar.distance",
     .place = IN(coplanar.distance),
     .label = "distance",
     .unit = length,
     .min = 1,
     .max = 1000,
     .step = 0.1,
     .logarithmic = true,
     .idle = {no_pairs},
     .help = "Distance from the eye to the nearest pair of the scene `coplanar`. All pairs move and grow in "
             "proportion, so only the depth fighting in the picture changes."},

    // cull
    {.path = "cull.enabled",
     .place = IN(cull.enabled),
     .label = "cull face",
     .help = "Culls polygons before rasterization, depending on the side they show: about half the polygons of a "
             "closed object. The enum is GL_CULL_FACE, not GL_CULL.",
     .gl_call = "glEnable(GL_CULL_FACE)"},
    {.path = "cull.face",
     .place = IN(cull.face),
     .label = "culled side",
     .idle = {no_culling},
     .help = "The side to cull. BACK is the usual choice; FRONT shows objects from inside. Shadows are the same either "
             "way.",
     .gl_call = "glCullFace"},
    {.path = "cull.front_face",
     .place = IN(cull.front_face),
     .label = "front face",
     .idle = {no_facing},
     .help = "The winding on screen that counts as front-facing: counterclockwise (CCW), the winding of the objects as "
             "built, or clockwise (CW), which turns them inside out.",
     .gl_call = "glFrontFace"},

    // light
    {.path = "light.position",
     .place = IN(lights[element].position),
     .label = "light",
     .unit = length,
     .min = -position_limit,
     .max = position_limit,
     .step = 0.05,
     .is_light = true,
     .help = "The light ℓ = (x, y, z, w): w = 1 is a point light at (x, y, z), w = 0 a parallel light from the "
             "direction (x, y, z). With w in between, the light lies at (x, y, z) ÷ w.",
     .formula = shadow_formula},
    {.path = "lights",
     .place = [](Params& params, std::size_t) -> FieldRef { return Further<LightParams>{&params.lights}; },
     .label = "more lights",
     .has_control = false,
     .help = "More lights, each like the first and each with its own shadow."},

    // plane
    {.path = "plane.equation",
     .place = IN(planes[element].equation),
     .label = "plane",
     .min = -position_limit,
     .max = position_limit,
     .step = 0.01,
     .help = "The plane a x + b y + c z + d = 0 that receives the shadow and is the mirror. (a, b, c) is its normal; "
             "its length and sign do not change the picture.",
     .formula = "n·p + d = 0"},
    {.path = "plane.extent",
     .place = IN(planes[element].extent),
     .label = "extent",
     .unit = length,
     .min = 1e-3,
     .max = 1e4,
     .step = 0.05,
     .logarithmic = true,
     .help = "Half the side length of the square patch that represents the plane. The plane itself is infinite: that "
             "is why shadows and reflections need the stencil at the patch's edge."},
    {.path = "plane.receives_shadow",
     .place = IN(planes[element].receives_shadow),
     .label = "receives shadows",
     .idle = {no_shadow},
     .help = "Shadows fall on this plane."},
    {.path = "plane.mirrors",
     .place = IN(planes[element].mirrors),
     .label = "mirrors",
     .idle = {no_reflection},
     .help = "This plane mirrors the scene."},
    {.path = "plane.gloss",
     .place = IN(planes[element].gloss),
     .label = "gloss",
     .help = "Gives the patch a highlight, which a shadow must remove: blending only darkens the highlight, whereas "
             "leaving out the light removes it."},
    {.path = "planes",
     .place = [](Params& params, std::size_t) -> FieldRef { return Further<PlaneParams>{&params.planes}; },
     .label = "more planes",
     .has_control = false,
     .help = "More planes, each with its equation and extent, and with settings for whether it receives shadows and "
             "whether it is a mirror."},

    // shadow
    {.path = "shadow.enabled",
     .place = IN(shadow.enabled),
     .label = "shadow",
     .idle = {no_receiver},
     .help = "Draws every object a second time, flattened onto the plane by S.",
     .formula = shadow_formula},
    {.path = "shadow.color",
     .place = IN(shadow.color),
     .label = "shadow color",
     .idle = {no_shadow, no_receiver, missing_light},
     .help = "The color of the flattened objects."},
    {.path = "shadow.opacity",
     .place = IN(shadow.opacity),
     .label = "opacity",
     .min = 0,
     .max = 1,
     .step = 0.01,
     .idle = {no_shadow, no_receiver, missing_light},
     .help = "How much of the shadow's color replaces the color of the surface below: 0 none, 1 all.",
     .formula = "color = opacity · shadow + (1 − opacity) · plane",
     .gl_call = "glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA)"},
    {.path = "shadow.stencil_once",
     .place = IN(shadow.stencil_once),
     .label = "stencil once",
     .idle = {no_shadow, no_receiver},
     .help = "Darkens each pixel only once. When off, a pixel covered by several flattened polygons is blended several "
             "times and gets darker.",
     .gl_call = "glStencilOp(GL_KEEP, GL_KEEP, GL_INVERT)"},
    {.path = "shadow.clip_to_receiver",
     .place = IN(shadow.clip_to_receiver),
     .label = "clip to receiver",
     .idle = {no_shadow, no_receiver},
     .help = "Keeps the shadow inside the patch by its stencil mark. When off, the shadow hangs in the air beyond the "
             "floor's edge.",
     .gl_call = "glStencilFunc(GL_EQUAL, …)"},
    {.path = "shadow.clip_casters",
     .place = IN(shadow.clip_casters),
     .label = "clip casters",
     .idle = {no_shadow, no_receiver},
     .help = "Only parts that are between the light and the plane can cast a shadow. When off, objects behind the "
             "plane cast a false shadow.",
     .gl_call = "gl_ClipDistance"},
    {.path = "shadow.offset",
     .place = IN(shadow.offset),
     .label = "shadow offset",
     .idle = {no_shadow, no_receiver, missing_light},
     .help = "How the shadow is kept from fighting with its plane: not at all, by a polygon offset in depth, by "
             "lifting it along the normal, or by drawing it without the depth test.",
     .gl_call = "glPolygonOffset | glDisable(GL_DEPTH_TEST)"},
    {.path = "shadow.offset_factor",
     .place = IN(shadow.offset_factor),
     .label = "factor",
     .min = -offset_limit,
     .max = offset_limit,
     .step = 0.1,
     .idle = {no_shadow, no_receiver, missing_light, no_shadow_offset},
     .help = "The slope part of the shadow's polygon offset. Negative pulls the shadow toward the eye.",
     .formula = "offset = factor · m + units · r",
     .gl_call = "glPolygonOffset"},
    {.path = "shadow.offset_units",
     .place = IN(shadow.offset_units),
     .label = "units",
     .min = -offset_limit,
     .max = offset_limit,
     .step = 0.1,
     .idle = {no_shadow, no_receiver, missing_light, no_shadow_offset},
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
     .idle = {no_shadow, no_receiver, missing_light, no_lift},
     .help = "Height of the shadow above the plane, on the eye's side, when the offset is \"lift\". At a grazing "
             "angle, the shadow separates from its object."},
    {.path = "shadow.style",
     .place = IN(shadow.style),
     .label = "style",
     .idle = {no_shadow, no_receiver},
     .help = "With blend, the shadow's color is painted over the plane. With missing_light, this light's contribution "
             "is left out, so that highlights vanish in the shadow and textures stay."},
    {.path = "shadow.clip_at_light",
     .place = IN(shadow.clip_at_light),
     .label = "clip at the light",
     .idle = {no_shadow, no_receiver},
     .help = "Parts beyond the light cast no shadow: each triangle is clipped to w > 0. When off, triangles stretch to "
             "infinity if they cross the plane w = 0, which contains the light and is parallel to the receiver.",
     .gl_call = "gl_ClipDistance"},
    {.path = "shadow.sign",
     .place = IN(shadow.sign),
     .label = "sign of S",
     .help = "The factor by which S is multiplied before it is uploaded. With plane_dot_light, it is the sign of "
             "n·ℓ + d, so w is positive between light and plane. With none, S is uploaded unchanged, and every shadow "
             "vanishes when the normal points away from the light. With forced, each vertex with a negative w is "
             "negated, and "
             "casters beyond the light cast an anti-shadow.",
     .formula = "sign(n·ℓ + d) S"},
    {.path = "shadow.write_depth",
     .place = IN(shadow.write_depth),
     .label = "write depth",
     .idle = {no_shadow, no_receiver, missing_light},
     .help = "Lets the shadow write its depth, including the offset: the depths stored for the plane are then no "
             "longer the plane's own.",
     .gl_call = "glDepthMask"},
    {.path = "shadow.own_stencil",
     .place = IN(shadow.own_stencil),
     .label = "own stencil",
     .idle = {no_shadow, no_receiver},
     .help =
         "Gives each plane its own stencil value and each light its own bit. When off, all planes share one value and "
         "all lights one bit: where one shadow was counted, the next is missing, and shadows leak from plane to plane.",
     .gl_call = "glStencilMask"},

    // reflection
    {.path = "reflection.enabled",
     .place = IN(reflection.enabled),
     .label = "reflection",
     .idle = {no_mirror},
     .help = "Draws the scene a second time, mirrored by R, and blends the plane over it.",
     .formula = mirror_formula},
    {.path = "reflection.reflectance",
     .place = IN(reflection.reflectance),
     .label = "reflectance",
     .min = 0,
     .max = 1,
     .step = 0.01,
     .idle = {no_reflection, no_mirror},
     .help = "How much of the mirrored picture shows in the plane: 0 is a dull floor, 1 a perfect mirror.",
     .formula = "color = reflectance · mirrored + (1 − reflectance) · plane"},
    {.path = "reflection.stencil",
     .place = IN(reflection.stencil),
     .label = "stencil mirror",
     .idle = {no_reflection, no_mirror},
     .help = "Draws the mirrored scene only where the stencil buffer marks the patch. When off, it also shows beyond "
             "the mirror's edge.",
     .gl_call = "glStencilFunc(GL_EQUAL, …)"},
    {.path = "reflection.clip",
     .place = IN(reflection.clip),
     .label = "clip at the plane",
     .idle = {no_reflection, no_mirror},
     .help = "How objects behind the mirror are kept out of the mirror image: not at all, by a clip plane per vertex, "
             "or by an oblique near plane in the projection. The oblique plane needs no extra hardware, but depth is "
             "then measured from the mirror and is finer or coarser, depending on where you look.",
     .formula = "oblique: row₃ = 2 c / (c·q) − row₄",
     .gl_call = "glEnable(GL_CLIP_DISTANCE0)"},
    {.path = "reflection.flip_winding",
     .place = IN(reflection.flip_winding),
     .label = "flip winding",
     .idle = {no_facing, no_reflection, no_mirror},
     .help = "A mirror reverses the winding from counterclockwise to clockwise (det R = −1), so front and back must be "
             "swapped while the mirrored scene is drawn. When off, the wrong faces are culled, and the image appears "
             "inside out.",
     .formula = "det R = −1",
     .gl_call = "glFrontFace"},
    {.path = "reflection.reflect_light",
     .place = IN(reflection.reflect_light),
     .label = "reflect light",
     .idle = {no_reflection, no_mirror},
     .help = "Mirrors the light together with the scene. When off, mirrored objects are lit from the wrong side.",
     .formula = "l′ = R l"},
    {.path = "reflection.bounces",
     .place = IN(reflection.bounces),
     .label = "bounces",
     .min = 0,
     .max = 16,
     .step = 1,
     .idle = {no_reflection, no_mirror},
     .help = "How many mirrors a line of sight may hit in a row. One plane needs 1; mirrors that face each other show "
             "more with each bounce."},
    {.path = "reflection.mirrored",
     .place = IN(reflection.mirrored),
     .label = "what to mirror",
     .idle = {no_reflection, no_mirror},
     .help = "Mirrors the scene by R and keeps the camera, or mirrors the camera and flips the picture left to right: "
             "the result is the same.",
     .formula = "P V R = F P (F V R)"},
    {.path = "reflection.same_projection",
     .place = IN(reflection.same_projection),
     .label = "same projection",
     .idle = {no_reflection, no_mirror, scene_mirrored},
     .help = "Gives the mirrored camera the camera's own projection. When off, the mirrored camera uses the aspect "
             "ratio of a square picture, and the mirror image does not fit the mirror."},
    {.path = "reflection.fovy",
     .place = IN(reflection.fovy),
     .label = "mirror fovy",
     .unit = degrees,
     .min = 0,
     .max = 179,
     .step = 0.5,
     .least_above_zero = 1,
     .idle = {no_field_of_view, no_reflection, no_mirror},
     .help = "The vertical field of view of the picture in a mirror, as if the mirrored camera had a projection of its "
             "own; 0 uses the camera's. With any other value, the mirror image is too small or too large for its "
             "mirror.",
     .formula = "P′ V R"},
    {.path = "reflection.printed_by_rows",
     .place = IN(reflection.printed_by_rows),
     .label = "as printed",
     .help = "Fills R row by row, as in the lecture's printed code. OpenGL reads it column by column and so gets the "
             "transpose, which is correct only if d = 0.",
     .formula = mirror_formula,
     .gl_call = "glUniformMatrix4fv"},
    {.path = "reflection.mask_writes_depth",
     .place = IN(reflection.mask_writes_depth),
     .label = "mask writes depth",
     .idle = {no_reflection, no_mirror},
     .help = "Lets the mask write the mirror's own depth: the mirror image lies beyond that depth and is hidden.",
     .gl_call = "glDepthMask"},
    {.path = "reflection.after_objects",
     .place = IN(reflection.after_objects),
     .label = "mirror last",
     .idle = {no_reflection, no_mirror},
     .help = "Draws the objects first and then the mirror, without a depth test: the mirror then covers even the "
             "objects in front of it.",
     .gl_call = "glDisable(GL_DEPTH_TEST)"},
    {.path = "reflection.side_of_eye",
     .place = IN(reflection.side_of_eye),
     .label = "side of the eye",
     .help = "Mirrors the objects on the eye's side of the plane. When off, the objects on the normal's side are "
             "mirrored, and a mirror seen from behind shows the objects behind it."},
    {.path = "reflection.shadows",
     .place = IN(reflection.shadows),
     .label = "shadows inside",
     .idle = {no_shadow, no_receiver, no_reflection, no_mirror},
     .help = "Shows the shadows on the other planes in the mirror too."},

    // overrides, follow
    {.path = "overrides.view_from_world",
     .place = IN(camera_overrides.view_from_world),
     .label = "V by hand",
     .has_control = false,
     .help = "Four rows that replace the view matrix V, right or wrong, and show what each entry does; null computes V "
             "from the camera.",
     .formula = "V = C⁻¹"},
    {.path = "overrides.clip_from_view",
     .place = IN(camera_overrides.clip_from_view),
     .label = "P by hand",
     .has_control = false,
     .help = "Four rows that replace the projection P, right or wrong, and show what each entry does; null computes P "
             "from the projection. With reversed depth and a clip range of 0 … 1, P is made for that range."},
    {.path = "overrides.shadow_from_world",
     .place = IN(overrides[0].shadowed_world_from_world[0]),
     .label = "S by hand",
     .has_control = false,
     .help = "Four rows that replace the shadow matrix S and show what each entry does; null computes S from the light "
             "and the plane.",
     .formula = shadow_formula},
    {.path = "overrides.mirror_from_world",
     .place = IN(overrides[0].mirrored_world_from_world),
     .label = "R by hand",
     .has_control = false,
     .help = "Four rows that replace the reflection matrix R and show what each entry does; null computes R from the "
             "plane.",
     .formula = mirror_formula},
    {.path = "overrides.further",
     .place = [](Params& params, std::size_t) -> FieldRef { return FurtherOverrides{&params.overrides}; },
     .label = "more S and R by hand",
     .has_control = false,
     .help = "Matrices that replace S and R of additional planes and lights, each with its plane and light number, "
             "counted from 1.",
     .formula = shadow_formula},
    {.path = "follow",
     .place = IN(follow),
     .label = "follow a point",
     .has_control = false,
     .min = -position_limit,
     .max = position_limit,
     .help = "A point p, followed through the matrices to its place in the picture, its shadow s = S p and its mirror "
             "image R p: an object's vertex or a point that you choose; null means none.",
     .formula = "s = S p ÷ w"},

    // visibility
    {.path = "visibility.method",
     .place = IN(visibility.method),
     .label = "method",
     .help = "How hidden surfaces are removed: by the GPU's depth buffer, not at all, by sorting (painter, Newell), "
             "with a BSP tree, with a depth buffer in software, or with a ray through each pixel. All methods except "
             "the GPU's depth buffer turn GL's depth test off. The slide puts hidden-surface removal before "
             "rasterization: that is true for sorting, but the depth test comes afterward, fragment by fragment."},
    {.path = "visibility.step",
     .place = IN(visibility.step),
     .label = "step",
     .min = -1,
     .max = 1e9,
     .step = 1,
     .help = "Stops the method after this many steps, so that you can watch it work; −1 runs all of them."},
    {.path = "visibility.sort_key",
     .place = IN(visibility.sort_key),
     .label = "sort key",
     .idle = {not_painter},
     .help = "The painter's sort key for polygons: the distance of the nearest vertex, the farthest vertex, or the "
             "centroid. Each of these keys fails in some scenes."},
    {.path = "visibility.splitter",
     .place = IN(visibility.splitter),
     .label = "splitter",
     .idle = {not_bsp},
     .help = "The polygon that becomes the root when a BSP tree is built: the first, a random one, the one that splits "
             "the fewest others, or the one that divides them most evenly."},
    {.path = "visibility.walk",
     .place = IN(visibility.walk),
     .label = "walk",
     .idle = {not_bsp},
     .help = "How a BSP tree is drawn: back to front, each polygon over the earlier ones; or front to back, with a "
             "mask of covered pixels that protects what is already drawn. The traversal order depends on the eye; the "
             "tree itself does not, although the slide divides it \"according to the viewer direction\"."},
    {.path = "visibility.epsilon",
     .place = IN(visibility.epsilon),
     .label = "epsilon",
     .unit = "scene diagonals",
     .min = 1e-12,
     .max = 0.1,
     .step = 1e-9,
     .logarithmic = true,
     .idle = {no_splits},
     .help = "How near to a plane a vertex may be and still count as lying on the plane when BSP and Newell split "
             "polygons. If this distance is too large, polygons that should be split are not: seams tear, and the "
             "drawing order is wrong."},
    {.path = "visibility.exact_curves",
     .place = IN(visibility.exact_curves),
     .label = "exact curves",
     .idle = {not_ray_cast, culling},
     .help = "Rays intersect spheres, cylinders, cones and tori by their equations, not their triangles: silhouettes "
             "are round at any distance, a noted strength of ray casting."},
    {.path = "visibility.compare_with",
     .place = IN(visibility.compare_with),
     .label = "compare with",
     .idle = {no_difference},
     .help = "The method that the difference view compares with the current one: pixels away from edges are red where "
             "the two methods see different polygons."},
    {.path = "visibility.numbers",
     .place = IN(visibility.numbers),
     .label = "numbers",
     .idle = {ray_cast},
     .help = "Labels each polygon with its number in the drawing order."},
    {.path = "visibility.raster",
     .place = IN(visibility.raster),
     .label = "raster",
     .has_control = false,
     .unit = "pixels",
     .min = 1,
     .max = 256,
     .step = 1,
     .idle = {gl_resolution},
     .help = "Columns and rows of the picture that a method computes, shown as large squares with their depths; null "
             "uses the view's own pixels, as GL's depth buffer always does. With a size set, shadows and mirrors are "
             "not drawn."},
    {.path = "visibility.pixel",
     .place = IN(visibility.pixel),
     .label = "chosen pixel",
     .has_control = false,
     .unit = "pixels",
     .min = 0,
     .max = 16383,
     .step = 1,
     .idle = {gl_resolution},
     .help = "A pixel of the method's picture, counted from the top left: its fragments and ray are shown, and you can "
             "step to its next fragment; null means no pixel."},

    // view
    {.path = "view.shows",
     .place = IN(view.shows),
     .label = "shows",
     .help = "The buffer that the camera view shows: color, depth (black is near, white is far), stencil, which side "
             "of each polygon faces the eye, how often each pixel was drawn, where two hidden-surface methods differ, "
             "or where the gap between two flat surfaces is smaller than depth can reliably resolve (fighting)."},
    {.path = "view.depth_scale",
     .place = IN(view.depth_scale),
     .label = "depth scale",
     .help = "With window, the picture shows depth as stored, which is nearly white for standard depth in perspective. "
             "With linear, it shows the distance from the eye, between near and far."},
    {.path = "view.depth_colors",
     .place = IN(view.depth_colors),
     .label = "depth colors",
     .help = "Depth as grays, or as color bands that distinguish neighboring depths and show their distribution."},
    {.path = "view.depth_range",
     .place = IN(view.depth_range),
     .label = "depth range",
     .has_control = false,
     .unit = length,
     .min = 1e-6,
     .max = 1e9,
     .step = 0.01,
     .logarithmic = true,
     .help = "The eye distances that depth pictures show as black and as white. With null, these are near and far in "
             "the camera's own picture, and the visible range in the pictures beside and below it. The stored depths "
             "do not change."},
    {.path = "view.samples",
     .place = IN(view.samples),
     .label = "samples",
     .has_control = false,
     .min = 0,
     .max = 4,
     .step = 4,
     .only = sample_counts,
     .help = "Multisampling of the color picture: 4 samples for smooth edges, 0 for none.",
     .gl_call = "glRenderbufferStorageMultisample"},
    {.path = "view.plane",
     .place = IN(view.plane),
     .label = "chosen plane",
     .has_control = false,
     .min = 1,
     .max = most_planes,
     .step = 1,
     .help = "The plane used by derivations, the followed point, the lecture's code, S and R entered by hand, the "
             "handles and the light's view: 1 is `plane`, 2 is the first of `planes`."},
    {.path = "view.light",
     .place = IN(view.light),
     .label = "chosen light",
     .has_control = false,
     .min = 1,
     .max = most_lights,
     .step = 1,
     .help = "The light that derivations and code use and that can orbit: 1 is `light`, 2 is the first of `lights`."},
    {.path = "view.beside.shows",
     .place = IN(view.beside.shows),
     .label = "2nd picture",
     .help =
         "A second picture in the camera view: the depth buffer, the same picture with a different depth format and "
         "mapping, or the same picture with other settings."},
    {.path = "view.beside.layout",
     .place = IN(view.beside.layout),
     .label = "layout",
     .idle = {no_second_picture},
     .help = "Two whole pictures, or one picture with a line to drag across it."},
    {.path = "view.beside.share",
     .place = IN(view.beside.share),
     .label = "divider",
     .has_control = false,
     .min = 0,
     .max = 1,
     .step = 0.01,
     .idle = {no_second_picture, halves},
     .help = "The fraction of the camera view to the left of the divider."},
    {.path = "view.beside.format",
     .place = IN(view.beside.format),
     .label = "other format",
     .unit = "bits",
     .idle = {no_second_picture, same_depth},
     .help = "The depth format of the second picture."},
    {.path = "view.beside.mapping",
     .place = IN(view.beside.mapping),
     .label = "other mapping",
     .idle = {no_second_picture, same_depth},
     .help = "The depth mapping of the second picture."},
    {.path = "view.beside.set",
     .place = IN(view.beside.set),
     .label = "differences",
     .has_control = false,
     .idle = {no_second_picture, same_settings},
     .help = "The fields that are different in the second picture, with their values there."},
    {.path = "view.pixel",
     .place = IN(view.pixel),
     .label = "pinned pixel",
     .has_control = false,
     .unit = "pixels",
     .min = 0,
     .max = 16383,
     .step = 1,
     .help = "The pixel of the camera view that the pixel and cell views describe, counted from the top left; null "
             "means the pixel under the pointer."},
    {.path = "view.pin",
     .place = IN(view.pin),
     .label = "pin",
     .has_control = false,
     .min = 0,
     .max = 1,
     .step = 0.01,
     .help =
         "Pins a pixel relative to an object, so that the pixel stays in place at every picture size. Give a scene "
         "object and a fraction of the object's box in the picture, from the top left (default: the middle of the "
         "object's visible part); or, without an object, a fraction of the view. Overrides the pinned pixel, unless "
         "it is null."},
    {.path = "view.cells",
     .place = IN(view.cells),
     .label = "cells",
     .has_control = false,
     .unit = "pixels",
     .min = 1,
     .max = 64,
     .step = 1,
     .help = "Columns and rows of the block that the cell view shows around the pinned pixel, or in the middle of the "
             "picture if no pixel is pinned; null shows as many as are readable."},
    {.path = "view.call",
     .place = IN(view.call),
     .label = "draw call",
     .has_control = false,
     .min = -1,
     .max = 1e9,
     .step = 1,
     .help = "Draws the frame only up to this draw call, counted from 0, so that you can watch the buffers fill; −1 "
             "draws all."},
    {.path = "view.triangle",
     .place = IN(view.triangle),
     .label = "triangle",
     .has_control = false,
     .min = -1,
     .max = 1e9,
     .step = 1,
     .help = "Draws only this many triangles of the chosen draw call; −1 draws all of them."},
    {.path = "view.pass",
     .place = IN(view.pass),
     .label = "pass",
     .has_control = false,
     .min = -1,
     .max = 1e6,
     .step = 1,
     .help = "Stops the frame after this pass, counted from 0, so that you can see what each pass leaves in color, "
             "depth and stencil; −1 draws all of them."},
    {.path = "view.derivation_step",
     .place = IN(view.derivation_step),
     .label = "derivation step",
     .has_control = false,
     .min = -1,
     .max = 1000,
     .step = 1,
     .help =
         "How many lines to show in the derivation of the shadow or the mirror image, not counting headings; −1 shows "
         "all lines."},
    {.path = "view.division",
     .place = IN(view.division),
     .label = "division by w",
     .has_control = false,
     .min = 0,
     .max = 1,
     .step = 0.01,
     .help =
         "What the view 'Clip space' shows: 0 is eye space with the frustum as a pyramid, 1 is NDC, where the division "
         "by w has made it a box. In between, each point is divided by a blend of a constant and w.",
     .formula = "p = ((1 − t) c E + t P) p_eye, then ÷ its w",
     .gl_call = "gl_Position / gl_Position.w"},
    {.path = "view.way",
     .place = IN(view.way),
     .label = "path of a point",
     .has_control = false,
     .min = 0,
     .max = 4,
     .step = 0.01,
     .help =
         "The space that the view 'The path of a point' has reached: 0 is the world, 1 eye space after V, 2 clip space "
         "after P, 3 NDC after the division by w, 4 the window. In between, the point is on its way.",
     .formula = "p → V p → P V p → ÷ w → window",
     .gl_call = "glViewport"},
    {.path = "view.lower_left",
     .place = IN(view.lower_left),
     .label = "lower left",
     .has_control = false,
     .help = "The content of the lower view on the left; automatic shows the observer."},
    {.path = "view.lower_right",
     .place = IN(view.lower_right),
     .label = "lower right",
     .has_control = false,
     .help =
         "The content of the lower view on the right; automatic chooses a view that suits the hidden-surface method."},

    {.path = "view.layout.big",
     .place = IN(view.layout.big),
     .label = "large",
     .has_control = false,
     .help = "Shows one view, or the matrices, in the space of all views; 'none' restores the usual layout."},
    {.path = "view.layout.matrices",
     .place = IN(view.layout.matrices),
     .label = "matrices",
     .has_control = false,
     .names = matrix_names,
     .help = "The matrices to show, in this order: S, R, the followed point, V, C, P and the lecture's display(); an "
             "empty list shows all as usual."},
    {.path = "view.layout.controls",
     .place = IN(view.layout.controls),
     .label = "controls",
     .has_control = false,
     .help = "The controls that the panel shows, given as paths of fields and groups; an empty list shows all."},
    {.path = "view.layout.folded",
     .place = IN(view.layout.folded),
     .label = "folded",
     .has_control = false,
     .names = column_names,
     .help = "The columns that are folded away: the panel, the matrices, or both."},

    // observer
    {.path = "observer.target",
     .place = IN(observer.target),
     .label = "observer target",
     .unit = length,
     .min = -position_limit,
     .max = position_limit,
     .step = 0.05,
     .help = "The point that the observer looks at and turns about. From outside, the observer sees the camera, the "
             "frustum, the light and the plane."},
    {.path = "observer.yaw",
     .place = IN(observer.yaw),
     .label = "observer yaw",
     .unit = degrees,
     .min = -turns_limit_deg,
     .max = turns_limit_deg,
     .step = 0.5,
     .help = "The observer's rotation about the y axis through its target."},
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
     .help = "Distance of the observer from its target."},
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
     .help = "The scene drawn again behind the mirror, where its image seems to be."},

    // slips
    {.path = "slips.walk_slows",
     .place = IN(slips.walk_slows),
     .label = "walk slows",
     .idle = {not_walking},
     .help = "A common mistake: walking moves along the view direction and then restores the height, so the farther "
             "you look up or down, the slower you walk."},
    {.path = "slips.creeping_roll",
     .place = IN(slips.creeping_roll),
     .label = "creeping roll",
     .idle = {flying},
     .help = "A common mistake: walking and orbiting apply yaw about the camera's own axis instead of the world's, so "
             "an unwanted roll creeps in."},
    {.path = "slips.pole_flip",
     .place = IN(slips.pole_flip),
     .label = "pole flip",
     .idle = {not_orbiting},
     .help = "A common mistake: orbiting builds the view from a fixed up vector with no limit on pitch, so the picture "
             "flips over at the pole.",
     .gl_call = "glm::lookAt"},
    {.path = "slips.swapped_order",
     .place = IN(slips.swapped_order),
     .label = "R T, not T R",
     .idle = {v_by_hand},
     .help = "A common mistake: the camera's matrix is multiplied in the wrong order, so its position is rotated too.",
     .formula = "C = R T ≠ T R"},
    {.path = "slips.camera_as_view",
     .place = IN(slips.camera_as_view),
     .label = "C as V",
     .idle = {v_by_hand},
     .help = "A common mistake: the camera's own matrix is uploaded where its inverse belongs, so everything moves the "
             "wrong way.",
     .formula = "C ≠ V = C⁻¹"},
    {.path = "slips.degrees_as_radians",
     .place = IN(slips.degrees_as_radians),
     .label = "degrees as radians",
     .idle = {p_by_hand, orthographic, has_window},
     .help = "The slide's perspective(45, …) passes fovy in degrees where GLM takes radians. 45 radians look like "
             "58.3°, so the picture is plausible.",
     .formula = "P₂₂ = 1 / tan(fovy / 2), fovy read as radians",
     .gl_call = "glm::perspective(45.f, …)"},
    {.path = "slips.plus_2ab",
     .place = IN(slips.plus_2ab),
     .label = "+2ab in R",
     .idle = {no_ab},
     .help = "A sign lost in the slide's expansion: row 2, column 1 of R is +2ab instead of −2ab. The mistake shows if "
             "the plane's normal has both an x and a y component.",
     .formula = "R₂₁ = −2ab"},
    {.path = "slips.normal_not_unit",
     .place = IN(slips.normal_not_unit),
     .label = "n not divided by |n|",
     .idle = {unit_normals},
     .help = "Fills R from (a, b, c, d) as entered. The formula needs a normal of length 1; with a longer normal, "
             "points move too far.",
     .formula = mirror_formula},
    {.path = "slips.shadow_by_rows",
     .place = IN(slips.shadow_by_rows),
     .label = "S by rows",
     .help = "Fills S row by row. OpenGL reads columns and gets Sᵀ, which sends points out of the plane.",
     .formula = "Sᵀ = (Π·L) I − Π Lᵀ"},
    {.path = "slips.oblique_in_world",
     .place = IN(slips.oblique_in_world),
     .label = "oblique plane in world space",
     .idle = {no_reflection, no_mirror, not_oblique},
     .help =
         "Gives the oblique near plane in world space, although P needs it in view space: the image is cut at another "
         "plane.",
     .formula = "c = V⁻ᵀ Π"},

    // animation
    {.path = "animation.jiggle",
     .place = IN(animation.jiggle),
     .label = "jiggle",
     .help = "Jitters the camera by a thousandth of the target's distance: surfaces stay where they are, but the "
             "stripes of depth fighting crawl."},
    {.path = "animation.light_orbit",
     .place = IN(animation.light_orbit),
     .label = "light orbits",
     .help = "Lets the chosen light orbit the world's y axis."},
    {.path = "animation.light_speed",
     .place = IN(animation.light_speed),
     .label = "speed",
     .unit = "°/s",
     .min = -360,
     .max = 360,
     .step = 1,
     .idle = {no_orbiting_light},
     .help = "Speed of the light's orbit; negative reverses it."},

    // ui
    {.path = "ui.theme",
     .place = IN(ui.theme),
     .label = "theme",
     .has_control = false,
     .help =
         "The colors of the window: dark, light, or projector, with larger text and heavier lines for a bright room."},
    {.path = "ui.scale",
     .place = IN(ui.scale),
     .label = "scale",
     .has_control = false,
     .min = 0.5,
     .max = 4,
     .step = 0.05,
     .help = "The size of text and controls, on top of the screen's own scaling."},
    {.path = "ui.language",
     .place = IN(ui.language),
     .label = "language",
     .has_control = false,
     .help = "The language of the window and the lessons. States, matrices and GL calls are the same in each."},
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
