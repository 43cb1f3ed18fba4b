// The frame as a list of passes: the technique as data. The GL layer executes it, the panel lists it as GL calls in the
// lecture's words, and tests read it without a GPU. Read plan.cpp next.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "frame/derive.h"
#include "frame/plan/hidden_pictures.h"
#include "frame/plan/pass_states.h"
#include "text/message.h"

namespace viewing {

/// The geometry that a pass draws.
enum class Subject {
    objects,     ///< the scene's meshes
    patch,       ///< the square of a plane: Pass::plane
    backdrop,    ///< a square that fills the picture and resets color and depth, or only the stencil's marks
    ordered,     ///< polygons in the order that a method found: FramePlan::hidden
    pixels,      ///< surface points that a method found, one per pixel
    difference,  ///< where two methods disagree
};

/// The way in which a pass colors its fragments.
enum class Shading {
    lit,       ///< ambient, diffuse and a modest highlight
    unlit,     ///< ambient only
    flat,      ///< one color
    facing,    ///< front and back faces in two colors
    heat,      ///< gaps of flat pairs, divided by the smallest gap that depth reliably resolves
    caster_w,  ///< w after S: whether a point casts a shadow, is behind the plane, or is beyond the light

    // IDs instead of colors, for the renderer to read back: no plan contains them.
    identity,         ///< of objects and patches
    polygon_identity  ///< of polygons drawn in order
};

/// Which of the scene's objects a pass draws.
enum class Chosen { all, bases, decals };

enum class Blend { none, alpha, add };

/// A plane in the space before Pass::world_from_scene is applied. The part on its negative side is clipped.
using ClipPlane = glm::dvec4;

/// The largest number of clip planes in one pass.
inline constexpr std::size_t most_clip_planes = 6;

struct Pass {
    Message name;
    Message reason;  ///< one sentence: its purpose
    Subject subject = Subject::objects;
    std::size_t plane = 0;        ///< index in Derived::planes: the patch, or a shadow's receiver
    std::size_t light = 0;        ///< index in Derived::lights_world: the light whose shadow the pass draws
    Chosen chosen = Chosen::all;  ///< all objects, those that are not decals, or only decals
    bool marks_objects = false;   ///< each object has its own stencil reference: FramePlan::object_marks
    Shading shading = Shading::lit;
    std::string matrices = "P V";      ///< the uploaded product, in the lecture's letters
    glm::dmat4 world_from_scene{1.0};  ///< I, S with its sign, or R: applied after each object's own matrix
    glm::dmat4 clip_from_world{1.0};
    glm::dmat4 view_from_world{1.0};
    bool is_mirror_image = false;            ///< also true if the pass draws only part of one
    std::vector<std::size_t> mirrors_met{};  ///< planes, in the order in which the line of sight meets them
    std::vector<ClipPlane> clip_planes;      ///< at most most_clip_planes
    DepthState depth;
    StencilState stencil;
    CullParams cull;
    Blend blend = Blend::none;
    bool color_write = true;
    std::optional<DepthOffset> offset;  ///< glPolygonOffset
    bool forces_sign = false;           ///< negates vertices that world_from_scene gives a negative w
    bool has_gloss = false;             ///< patches only
    std::vector<glm::dvec4> lights_world{{0.0, 1.0, 0.0, 0.0}};  ///< the lights that illuminate it: at most four
    std::vector<std::size_t> lights{0};                          ///< which lights of the state they are
    double light_strength = 1.0;                                 ///< of each light
    glm::dvec4 eye_world{0.0, 0.0, 0.0, 1.0};                    ///< w = 0: parallel view rays, from this direction
    glm::dvec3 sky_world{0.0, 1.0, 0.0};                         ///< direction of the strongest ambient light
    glm::dvec4 color{0.0, 0.0, 0.0, 1.0};                        ///< flat: the color; patch: its alpha, in w

    bool operator==(const Pass&) const = default;
};

/// The point at which a frame stops when it is viewed call by call. Calls are numbered as in frame/plan/draw_calls.h.
struct DrawLimit {
    int call = -1;       ///< the last call drawn, from 0; −1: all
    int triangles = -1;  ///< how many of that call's triangles are drawn; −1: all
    int pass = -1;       ///< the last pass drawn, from 0; −1: all
    bool operator==(const DrawLimit&) const = default;
};

struct FramePlan {
    Color background;
    Color unwritten;                            ///< the depth view's color where nothing was drawn
    Color patch_light, patch_dark, patch_line;  ///< the ground's two tones and its lines
    bool clear_depth = true;
    bool mask_on_while_clearing = true;  ///< off: glClear runs, but clears no depth
    double clear_depth_value = 1.0;
    DepthFormat depth_format = DepthFormat::d24;
    StoredDepth stored_depth;  ///< of that format
    DepthMapping depth_mapping = DepthMapping::standard;
    bool logarithm_per_vertex = false;
    Lens lens;                  ///< for logarithmic depth, and to show depth in eye units
    bool has_distances = true;  ///< Derived::has_distances: near and far of the lens have a meaning
    bool clip_zero_to_one = false;
    Shows shows = Shows::color;
    DepthScale depth_scale = DepthScale::linear;
    DepthColors depth_colors = DepthColors::grey;
    glm::dvec2 shown_range{0.5, 40.0};  ///< eye distances shown as black and white, on either scale
    int samples = 0;
    std::vector<PlanePatch> patches;  ///< one per plane
    HiddenPictures hidden;
    bool has_decals = false;
    DepthOffset decal_offset;       ///< for objects marked as decals
    std::vector<int> object_marks;  ///< per object: its own stencil mark or, for a decal, its base's; empty: no marks
    DrawLimit limit;
    std::optional<HeatMap> heat;                 ///< for Shading::heat
    glm::dvec4 caster_w{0.0, 0.0, 0.0, 1.0};     ///< caster_w · p is the w of p's projection: for Shading::caster_w
    glm::dvec4 caster_side{0.0, 0.0, 0.0, 1.0};  ///< caster_side · p is positive on the light's side of the plane
    int reflection_depth = 0;                    ///< reflection_depth() of this frame
    std::vector<Pass> passes;

    /// Returns whether the frame clears depth; otherwise the previous frame's depths stay.
    bool clears_depth() const { return clear_depth && mask_on_while_clearing; }
    /// Returns whether the logarithm is computed only at the vertices. In between, GL interpolates it linearly, so the
    /// depth there is not logarithmic.
    bool has_logarithm_per_vertex() const { return logarithm_per_vertex && depth_mapping == DepthMapping::logarithmic; }
    /// Returns the hidden-surface method's result that a pass draws.
    const std::shared_ptr<const HiddenDrawing>& drawing_of(const Pass& pass) const {
        return pass.is_mirror_image ? hidden.mirrored : hidden.camera;
    }
    int mark_of(std::size_t object) const { return object < object_marks.size() ? object_marks[object] : 0; }

    /// Compares every member; hidden-surface pictures are equal only if they are the same object.
    bool operator==(const FramePlan&) const = default;
};

/// Returns whether shadows and mirror images are drawn: not while a method is shown step by step or in large pixels,
/// and not in the fighting and overdraw views.
bool shows_effects(const Params& params);

/// Returns the planes that a frame draws: only the first one for hidden-surface methods other than GL's own.
std::span<const DerivedPlane> drawn_planes(const Params& params, const Derived& derived);

/// Returns how many mirrors in a row a view ray may meet: the requested bounces, or fewer if the stencil cannot count
/// that many, or if that many would need more than 64 images or draw the scene more than 256 times. At most 1 for
/// hidden-surface methods other than GL's own.
int reflection_depth(const Params& params, const Derived& derived);

/// The eye from which add_scene_passes() sees the scene. That function adds the objects and the planes, with their
/// mirror images and shadows; it is part of plan() and plan_observer().
struct Eye {
    glm::dmat4 clip_from_view{1.0};
    glm::dmat4 view_from_world{1.0};
    glm::dvec4 eye_world{0.0, 0.0, 0.0, 1.0};
};
void add_scene_passes(std::vector<Pass>& passes, const Params& params, const Derived& derived, const Eye& eye);

/// Plans the camera view's frame. `hidden` is the result of the requested method; until it exists, the objects are
/// missing. Shadows and mirrors are left out in the fighting view, and while a method is shown step by step or in large
/// pixels.
FramePlan plan(const Params& params, const Derived& derived, const HiddenPictures& hidden = {});

/// Replaces the objects with a method's result: part of plan().
void use_hidden_surfaces(FramePlan& frame, const Params& params, const Derived& derived, const HiddenPictures& hidden);

/// Returns a pass that draws the difference in FramePlan::hidden over the picture.
Pass difference_pass(const Message& reason);

/// Sets the depth buffer's format, mapping, clear value and offsets, and the way in which it is shown: part of plan().
void set_depth(FramePlan& frame, const Params& params, const Derived& derived);

/// Returns the sRGB color unchanged, with components from 0 to 1.
glm::dvec4 color_of(const Color& color, double alpha);

/// Returns the factor for both numbers of an offset: −1 for reversed depth, which decreases with distance; 1 for other
/// mappings, or if depth.reversed_offset is off.
double offset_sign(const DepthParams& depth);

/// Moves decals that have no polygon offset into their own pass after the objects: part of plan().
void draw_decals_apart(std::vector<Pass>& passes, const Params& params);

/// Lets only the scene's own passes write color: each of their fragments adds one level of red to its pixel. Part of
/// plan().
void count_overdraw(FramePlan& frame);

/// Returns the eye distances that a depth picture with contrast shows as black and white: the state's range or, if it
/// has none that overlaps near … far, the range of the scene's bounds and the first plane's patch. Both distances are
/// clamped to near and far.
glm::dvec2 contrast_range(const Params& params, const Derived& derived, const Scene& scene);

/// The scale of a depth picture: gray = (value − first) · slope, where the value is an eye distance or a window depth.
struct GrayScale {
    double first, slope;
};
/// Returns the scale of the plan; a range of zero width gives a step from black to white.
GrayScale gray_scale(const FramePlan& plan);

/// Plans the observer's frame: the same scene, shadows and mirrors seen from outside, with plain depth and color.
FramePlan plan_observer(const Params& params, const Derived& derived, const ObserverView& observer);

/// Returns the GL calls, with their arguments, that change the state of the pass `before` into that of `pass`, then the
/// call that draws `pass`, in the lecture's words. Unchanged state needs no call. first_gl_state() is the state before
/// the first pass.
std::vector<Message> gl_calls(const FramePlan& frame, const Pass& pass, const Pass& before);
Pass first_gl_state();

/// Returns the calls that begin a frame if the previous frame had the same plan. The first calls reset the state that
/// the previous frame's last pass left behind.
std::vector<Message> clear_calls(const FramePlan& frame);

/// Return "GL_LEQUAL" and the like.
std::string gl_name(CompareFunc func);
std::string gl_name(CullFace face);
std::string gl_name(FrontFace front);

}  // namespace viewing
