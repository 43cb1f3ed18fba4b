// The switches of the depth buffer, each with the sentence that says what it does to the picture. Part of problems.h.
#include <cmath>

#include "frame/depth/decals.h"
#include "frame/depth/depth_switches.h"
#include "frame/depth/near_advice.h"
#include "frame/object_reach.h"
#include "frame/say.h"
#include "text/words.h"

namespace viewing {
namespace {

void say_tests(Sayer& tell, const DepthParams& depth) {
    if (!depth.buffer) {
        tell.broken(true,
                    tr("the window has no depth buffer (GLUT_DEPTH is left out): whatever is set, the depth test "
                       "passes always, and whatever is drawn last wins"),
                    "depth.buffer");
        return;
    }
    if (!depth.test) {
        tell.broken(true,
                    tr("depth test off: whatever is drawn last wins, and no depth is written either, so the depth "
                       "buffer stays as it was cleared"),
                    "depth.test");
        return;
    }
    tell.broken(
        depth.func == CompareFunc::always,
        tr("GL_ALWAYS: whatever is drawn last wins, as with the test off, but here depth is written all the same"),
        "depth.func");
    tell.broken(depth.func == CompareFunc::notequal,
                tr("GL_NOTEQUAL: whatever is drawn last wins, unless it has the depth of what is there already"),
                "depth.func");
    tell.broken(depth.func == CompareFunc::never, tr("GL_NEVER: no fragment passes"), "depth.func");
    const bool clears_to_near = depth.mapping == DepthMapping::reversed && !depth.reversed_clear;
    const bool wants_farther = depth.func == CompareFunc::greater || depth.func == CompareFunc::gequal;
    tell.broken(wants_farther && !clears_to_near,
                tr("only what is farther passes, and nothing is farther than what the buffer is cleared to"),
                "depth.func");
    tell.broken(depth.func == CompareFunc::equal,
                tr("GL_EQUAL: only what has the very depth that is stored already passes"), "depth.func");
    tell.broken(!depth.write,
                tr("depth mask off: surfaces are tested but leave no depth, so they hide nothing that is drawn later"),
                "depth.write");
}

void say_clears(Sayer& tell, const DepthParams& depth) {
    if (!wants_nearer(depth)) return;
    tell.broken(!depth.clear, tr("depth is not cleared: the depths of the frame before go on hiding what is drawn now"),
                "depth.clear");
    tell.broken(depth.clear && !depth.write_while_clearing,
                tr("glClear obeys the depth mask: with the mask off it clears no depth, and the frame before goes on "
                   "hiding what is drawn now"),
                "depth.write_while_clearing");
}

/// From which eye distance on depth is stored as the code that the buffer is cleared to.
double start_of_cleared_code(const DepthParams& depth, const Lens& lens) {
    const double farthest = depth.mapping == DepthMapping::reversed ? 0.0 : 1.0;
    const double half = 0.5 * code_width(precision_of(depth.format), farthest);
    return distance_of_window_depth(lens, depth.mapping, std::abs(farthest - half));
}

/// What has the depth of the background is not nearer than it.
void say_cleared_code(Sayer& tell, const Params& params, const Derived& derived, const Scene& scene) {
    const DepthParams& depth = params.depth;
    const bool refuses_ties = depth.tests() && depth.func == CompareFunc::less;
    if (!refuses_ties || !is_cleared_to_farthest(depth) || has_bent_depth(depth)) return;
    const double start = start_of_cleared_code(depth, params.lens());
    // Nearly at far: it is cut there, and rounding decides.
    if (start > params.projection.far * (1.0 - 1e-3)) return;
    if (objects_at_most(scene, glm::transpose(derived.view_from_world)[2], -start).empty()) return;
    const std::vector<SeenThing> seen = seen_things(params, derived, scene);
    std::vector<const char*> names;
    for (const SeenThing& thing : seen)
        if (!thing.is_plane && thing.farthest > start) names.push_back(thing.name.c_str());
    tell.broken(!names.empty(),
                say("from z = {z} on depth has the very code that the buffer is cleared to: GL_LESS lets nothing of "
                    "{objects} pass there",
                    "z"_a = figures(start, 3), "objects"_a = joined(names)),
                "depth.format");
}

/// Whether a polygon offset moves anything, decals or shadows.
bool has_offset(const Params& params, const Scene& scene) {
    const DepthParams& depth = params.depth;
    const ShadowParams& shadow = params.shadow;
    const bool moves_decals = depth.offset != DepthOffset{} && depth.decals == DecalMethod::offset && has_decals(scene);
    const bool moves_shadows = shadow.enabled && shadow.offset == ShadowOffset::polygon_offset &&
                               (shadow.offset_factor != 0.0 || shadow.offset_units != 0.0);
    return moves_decals || moves_shadows;
}

void say_mappings(Sayer& tell, const Params& params, const Derived& derived, const Scene& scene) {
    const DepthParams& depth = params.depth;
    tell.broken(has_bent_depth(depth),
                tr("the logarithm is taken at the vertices only: inside large triangles depth is bent, and they hide "
                   "or show what they should not"),
                "depth.logarithm_per_vertex");
    if (depth.mapping != DepthMapping::reversed) return;
    tell.broken(!derived.clip_zero_to_one,
                depth.reversed_zero_to_one
                    ? tr("this driver has no glClipControl: reversed depth keeps the clip range −1 to 1, which rounds "
                         "a float's fine steps near 0 away, and little is won")
                    : tr("reversed depth in a clip range of −1 to 1: halving it and adding a half rounds a float's "
                         "fine steps near 0 away, and little is won"));
    tell.broken(!depth.reversed_clear && wants_nearer(depth),
                tr("reversed depth has 0 at the far plane, but the buffer is cleared to 1: nothing is nearer, and "
                   "nothing is drawn"),
                "depth.reversed_clear");
    tell.broken(!depth.reversed_offset && has_offset(params, scene),
                tr("with reversed depth nearer is greater, but the offset keeps its sign: it pushes away what it "
                   "should pull nearer"),
                "depth.reversed_offset");
}

/// What the driver was asked for and does not store.
void say_driver(Sayer& tell, const DepthParams& depth, const DepthPrecision& stored) {
    const DepthPrecision asked = precision_of(depth.format);
    if (stored == asked) return;
    if (stored.is_float)
        return tell(true, say("this driver stores {bits} bits of depth as a 32-bit float, whose steps are finer than "
                              "codes of {bits} bits below a depth of 1/2",
                              "bits"_a = asked.bits));
    tell(true, say("this driver stores {bits} bits of depth, where {asked} were asked for", "bits"_a = stored.bits,
                   "asked"_a = asked.bits));
}

void say_decals(Sayer& tell, const Params& params, const Derived& derived, const Scene& scene) {
    const DecalMethod method = params.depth.decals;
    if (method == DecalMethod::offset || !has_decals(scene)) return;
    tell.broken(method == DecalMethod::equal, tr("GL_EQUAL: a decal passes only where its triangles round to the very "
                                                 "depth of what they lie on; with triangles of its own it stipples"));
    for (std::size_t i = 0; i < derived.object_marks.size(); ++i)
        if (scene.objects[i].description.decal && derived.object_marks[i] == 0)
            return tell.broken(true,
                               tr("a decal that lies on no flat object has no mark to be drawn at, and is left out"));
}

/// What is left out of the picture, or out of its quality, without being wrong.
void say_omissions(Sayer& tell, const Params& params) {
    tell.broken(params.view.call >= 0,
                tr("the frame is drawn only as far as the step of the cell view: release it there, or undo"),
                "view.call");
    tell.broken(params.view.pass >= 0,
                tr("the frame is drawn only as far as one of its passes: release it in the list of passes, or undo"),
                "view.pass");
    const bool has_masks = params.shadow.enabled || params.reflection.enabled;
    tell.broken(params.depth.format == DepthFormat::d16 && params.view.samples > 0 && has_masks,
                tr("16 bits have no stencil beside them: the masks of shadow and mirror have one value for each pixel, "
                   "so there is no multisampling"));
}

}  // namespace

void find_depth_problems(std::vector<Problem>& problems, const Params& params, const Derived& derived,
                         const Scene& scene) {
    Sayer tell(problems, "depth");
    if (is_drawn_by_gl_alone(params.visibility.method)) say_omissions(tell, params);
    if (params.visibility.method != VisibilityMethod::depth_buffer) return;
    say_tests(tell, params.depth);
    say_clears(tell, params.depth);
    say_cleared_code(tell, params, derived, scene);
    say_driver(tell, params.depth, derived.stored_depth.precision);
    say_mappings(tell, params, derived, scene);
    say_decals(tell, params, derived, scene);
}

}  // namespace viewing
