// The frame as a list of passes: the technique as data. The GL layer executes it, the panel lists it with the GL
// calls in the lecture's words, and a test reads it without a GPU. Read plan.cpp next.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "frame/derive.h"
#include "frame/hidden/hidden_drawing.h"
#include "frame/pass_states.h"

namespace viewing {

/// What a pass draws.
enum class Subject {
    objects,     ///< the scene's meshes
    patch,       ///< the square of a plane: Pass::plane
    backdrop,    ///< everything at once, at the far end of depth: a fresh picture where the stencil allows it
    ordered,     ///< polygons in the order that a method found: FramePlan::hidden
    pixels,      ///< surface points that a method found for each pixel
    difference,  ///< where two methods disagree
};

/// How its fragments get their colour.
enum class Shading {
    lit,       ///< ambient, diffuse and a modest highlight
    unlit,     ///< ambient only
    flat,      ///< one colour
    facing,    ///< front and back faces in two colours
    heat,      ///< gaps of flat pairs, divided by the smallest that depth tells for sure
    caster_w,  ///< what S makes of w: casts a shadow, lies behind the plane, or beyond the light

    // Numbers in place of colours, which the renderer reads back: in no plan.
    identity,         ///< of objects and patches
    polygon_identity  ///< of polygons that are drawn in order
};

/// Which of the scene's objects a pass draws.
enum class Chosen { all, bases, decals };

enum class Blend { none, alpha, add };

/// A plane in world space; what lies on its negative side is cut off, before the pass's own matrix is applied.
using ClipPlane = glm::dvec4;

/// Of one pass.
inline constexpr std::size_t most_clip_planes = 2;

struct Pass {
    std::string name;
    std::string reason;  ///< one sentence: why it is there
    Subject subject = Subject::objects;
    std::size_t plane = 0;        ///< of Derived::planes: the patch, or the receiver of a shadow
    std::size_t light = 0;        ///< of Derived::lights_world: whose shadow
    Chosen chosen = Chosen::all;  ///< of the objects: all, those that are no decals, or those that are
    bool marks_objects = false;   ///< the stencil's reference is each object's own: FramePlan::object_marks
    Shading shading = Shading::lit;
    std::string matrices = "P V";      ///< the product that is uploaded, in the lecture's letters
    glm::dmat4 world_from_scene{1.0};  ///< I, S with its sign, or R: applied after each object's own matrix
    glm::dmat4 clip_from_world{1.0};
    glm::dmat4 view_from_world{1.0};
    bool is_mirror_image = false;        ///< or belongs to one
    std::vector<ClipPlane> clip_planes;  ///< at most most_clip_planes
    DepthState depth;
    StencilState stencil;
    CullParams cull;
    Blend blend = Blend::none;
    bool color_write = true;
    std::optional<DepthOffset> offset;  ///< glPolygonOffset
    bool forces_sign = false;           ///< vertices that world_from_scene gives a negative w are turned around
    bool has_gloss = false;             ///< of a patch
    std::vector<glm::dvec4> lights_world{{0.0, 1.0, 0.0, 0.0}};  ///< that shine on it: at most four
    double light_strength = 1.0;                                 ///< of each
    glm::dvec4 eye_world{0.0, 0.0, 0.0, 1.0};  ///< w = 0: parallel lines of sight, from this direction
    glm::dvec3 sky_world{0.0, 1.0, 0.0};       ///< where ambient light is strongest
    glm::dvec4 color{0.0, 0.0, 0.0, 1.0};      ///< flat: the colour; patch: its alpha is in w

    bool operator==(const Pass&) const = default;
};

/// Where a frame that is watched as it is drawn stops: the calls of frame/draw_calls.h.
struct DrawLimit {
    int call = -1;       ///< the last one that is drawn, from 0 on; −1: all
    int triangles = -1;  ///< of that call; −1: all
    int pass = -1;       ///< the last pass that is drawn, from 0 on; −1: all
    bool operator==(const DrawLimit&) const = default;
};

struct FramePlan {
    Color background;
    Color unwritten;                            ///< what the depth view shows where nothing was drawn
    Color patch_light, patch_dark, patch_line;  ///< the two tones of the ground and its lines
    bool clear_depth = true;
    bool mask_on_while_clearing = true;  ///< off: the clear is called and clears no depth
    double clear_depth_value = 1.0;
    DepthFormat depth_format = DepthFormat::d24;
    StoredDepth stored_depth;  ///< of that format
    DepthMapping depth_mapping = DepthMapping::standard;
    bool logarithm_per_vertex = false;
    Lens lens;  ///< for logarithmic depth and for showing depth in eye units
    bool clip_zero_to_one = false;
    Shows shows = Shows::color;
    DepthScale depth_scale = DepthScale::linear;
    DepthColors depth_colors = DepthColors::grey;
    glm::dvec2 shown_range{0.5, 40.0};  ///< eye distances that are shown as black and white, on either scale
    int samples = 0;
    std::vector<PlanePatch> patches;  ///< of each plane
    HiddenPictures hidden;
    DepthOffset decal_offset;       ///< for objects marked as decals
    std::vector<int> object_marks;  ///< of each object, the stencil value of what it is or lies on; empty: none
    DrawLimit limit;
    std::optional<HeatMap> heat;                 ///< for Shading::heat
    glm::dvec4 caster_w{0.0, 0.0, 0.0, 1.0};     ///< · p is the w of its projected point: for Shading::caster_w
    glm::dvec4 caster_side{0.0, 0.0, 0.0, 1.0};  ///< · p is positive on the light's side of the plane
    int reflection_depth = 0;                    ///< reflection_depth() of what it shows
    std::vector<Pass> passes;

    /// Or its depths stay those of the frame before.
    bool clears_depth() const { return clear_depth && mask_on_while_clearing; }
    /// The logarithm is taken at the corners of a triangle, and what GL interpolates between them is no logarithm.
    bool has_logarithm_per_vertex() const { return logarithm_per_vertex && depth_mapping == DepthMapping::logarithmic; }
    int mark_of(std::size_t object) const { return object < object_marks.size() ? object_marks[object] : 0; }

    /// In every member; pictures of hidden surfaces are equal if they are the same ones.
    bool operator==(const FramePlan&) const = default;
};

/// Whether pictures with shadows and mirror images are asked for: not while a method is gone through step by step.
bool shows_effects(const Params& params);

/// Those that a frame draws: hidden-surface methods other than GL's own know of the first one alone.
std::span<const DerivedPlane> drawn_planes(const Params& params, const Derived& derived);

/// How many mirrors a line of sight may meet one after another where so many planes are there: fewer than asked for
/// where the stencil cannot count them, and where they would be more than 64 images or 256 drawings of the scene.
int reflection_depth(const Params& params, const Derived& derived);

/// Planes with their mirror images and shadows, and the objects: part of plan() and plan_observer().
struct Eye {
    glm::dmat4 clip_from_view{1.0};
    glm::dmat4 view_from_world{1.0};
    glm::dvec4 eye_world{0.0, 0.0, 0.0, 1.0};
};
void add_scene_passes(std::vector<Pass>& passes, const Params& params, const Derived& derived, const Eye& eye);

/// The camera view's frame. `hidden` is what the method that is asked for has found; while there is nothing yet, the
/// objects are missing. Shadow and mirror wait while a method is gone through step by step.
FramePlan plan(const Params& params, const Derived& derived, const HiddenPictures& hidden = {});

/// Puts what a method found in the place of the objects: part of plan().
void use_hidden_surfaces(FramePlan& frame, const Params& params, const Derived& derived, const HiddenPictures& hidden);

/// Lays FramePlan::hidden's difference over the picture.
Pass difference_pass(const char* reason);

/// Format, mapping, clear and offsets of the depth buffer, and how it is shown: part of plan().
void set_depth(FramePlan& frame, const Params& params, const Derived& derived);

/// sRGB as it is, from 0 to 1.
glm::dvec4 color_of(const Color& color, double alpha);

/// 1, or −1 with reversed depth, which counts the other way and so turns both signs of an offset round.
double offset_sign(const DepthParams& depth);

/// Decals that are not left to a polygon offset get a pass of their own after the objects: part of plan().
void draw_decals_apart(std::vector<Pass>& passes, const Params& params);

/// Leaves the objects' passes alone, each of which adds one level of red to a pixel: part of plan().
void count_overdraw(FramePlan& frame);

/// The eye distances that a depth picture with contrast shows as black and white: the state's, else those between which
/// everything lies that can be seen, inside near and far.
glm::dvec2 contrast_range(const Params& params, const Derived& derived, const Scene& scene);

/// The observer's frame: the same scene, shadow and mirror seen from outside, with plain depth and colour.
FramePlan plan_observer(const Params& params, const Derived& derived, const ObserverView& observer);

/// The GL calls that lead from one pass to another, with their current values, in the lecture's words: what stays as it
/// was is not told again. Before the first pass comes first_gl_state().
std::vector<std::string> gl_calls(const Pass& pass, const Pass& before);
Pass first_gl_state();

/// How a frame begins, after another one of the same plan: first what that one's last pass left is put back.
std::vector<std::string> clear_calls(const FramePlan& frame);

/// "GL_LEQUAL" and the like.
std::string gl_name(CompareFunc func);
std::string gl_name(CullFace face);
std::string gl_name(FrontFace front);

}  // namespace viewing
