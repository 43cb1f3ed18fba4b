// The technique, pass by pass: mirror image in the stencilled patch, patch, shadow on the patch, objects.
// Nothing here depends on the sign or length of the plane's equation: everything is said relative to the eye's
// and the light's side. Source: lecture, Planar Shadow and Planar Reflection; Kilgard 1999.
#include "frame/plan.h"

#include "frame/ground.h"

#include <algorithm>
#include <cmath>

namespace viewing {
namespace {

constexpr int patch_reference = 1;  ///< the stencil value of the patch; shadowed pixels have one more

/// Reversed depth keeps "less is nearer" in the parameters and turns the comparison around for GL.
CompareFunc func_for(CompareFunc func, DepthMapping mapping) {
    if (mapping != DepthMapping::reversed) return func;
    switch (func) {
        case CompareFunc::less:
            return CompareFunc::greater;
        case CompareFunc::lequal:
            return CompareFunc::gequal;
        case CompareFunc::greater:
            return CompareFunc::less;
        case CompareFunc::gequal:
            return CompareFunc::lequal;
        default:
            return func;
    }
}

glm::dvec4 color_of(const Color& color, double alpha) {
    return {color.r / 255.0, color.g / 255.0, color.b / 255.0, alpha};
}

/// What all passes of one frame share.
struct Frame {
    const Params& params;
    const Derived& derived;
    glm::dmat4 clip_from_view;
    glm::dmat4 view_from_world;
    glm::dvec4 eye_world;
    double eye_side;  ///< of this frame's eye

    glm::dvec4 plane_towards_eye() const { return derived.unit_plane * (eye_side < 0.0 ? -1.0 : 1.0); }
    bool light_reaches_seen_side() const { return light_reaches(derived, eye_side); }

    Pass pass(const char* name, const char* reason, Subject subject) const {
        Pass made;
        made.name = name;
        made.reason = reason;
        made.subject = subject;
        made.clip_from_world = clip_from_view * view_from_world;
        made.view_from_world = view_from_world;
        made.eye_world = eye_world;
        made.light_world = params.light.position;
        const bool gl_test = params.depth.test && params.visibility.method == VisibilityMethod::depth_buffer;
        made.depth = {gl_test, func_for(params.depth.func, params.depth.mapping), params.depth.write};
        if (subject == Subject::objects) made.cull = params.cull;
        return made;
    }
};

CullParams with_flipped_winding(CullParams cull) {
    cull.front_face = cull.front_face == FrontFace::ccw ? FrontFace::cw : FrontFace::ccw;
    return cull;
}

Pass mirror_mask(const Frame& frame) {
    Pass pass =
        frame.pass("Mirror mask", "marks the patch in the stencil buffer, so that the image stays inside the mirror",
                   Subject::patch);
    pass.shading = Shading::flat;
    pass.color_write = false;
    pass.depth.write = false;
    pass.stencil = {true, CompareFunc::always, patch_reference, StencilOp::replace};
    return pass;
}

Pass mirror_image(const Frame& frame) {
    const ReflectionParams& reflection = frame.params.reflection;
    Pass pass = frame.pass("Mirror image", "draws the scene once more through R, as if the mirror were a window",
                           Subject::objects);
    pass.is_mirror_image = true;
    pass.world_from_scene = frame.derived.mirror_from_world;
    if (reflection.stencil) pass.stencil = {true, CompareFunc::equal, patch_reference, StencilOp::keep};
    if (reflection.flip_winding) pass.cull = with_flipped_winding(pass.cull);
    if (reflection.reflect_light) {
        pass.light_world = frame.derived.mirror_from_world * frame.params.light.position;
        pass.sky_world = glm::dmat3(frame.derived.mirror_from_world) * pass.sky_world;
    }
    const bool oblique = reflection.clip == MirrorClip::oblique && frame.params.depth.mapping != DepthMapping::reversed;
    if (reflection.clip != MirrorClip::none && !oblique) pass.clip_planes = {frame.plane_towards_eye()};
    if (oblique) {
        // The image lies behind the mirror: keep what is on the far side of the plane, seen from the eye.
        const glm::dvec4 behind = -frame.plane_towards_eye();
        const glm::dvec4 behind_view = behind * glm::inverse(frame.view_from_world);
        pass.clip_from_world = with_oblique_near_plane(frame.clip_from_view, behind_view) * frame.view_from_world;
    }
    return pass;
}

/// The patch itself; over a mirror image it lets `reflectance` of it through.
Pass patch_surface(const Frame& frame, bool mirrors) {
    const ReflectionParams& reflection = frame.params.reflection;
    Pass pass = frame.pass("Patch",
                           mirrors ? "lays the plane over its mirror image and gives these pixels the plane's own depth"
                                   : "draws the plane and marks it in the stencil buffer as the receiver of shadows",
                           Subject::patch);
    pass.shading = frame.light_reaches_seen_side() ? Shading::lit : Shading::unlit;
    pass.stencil = {true, CompareFunc::always, patch_reference, StencilOp::replace};
    if (mirrors) {
        pass.blend = Blend::alpha;
        pass.color.a = 1.0 - reflection.reflectance;
        pass.depth.func = CompareFunc::always;
        if (reflection.stencil) pass.stencil = {true, CompareFunc::equal, patch_reference, StencilOp::keep};
    }
    return pass;
}

/// Casters flattened by S. The clip planes keep what is between the light and the plane.
Pass shadow_pass(const Frame& frame) {
    const ShadowParams& shadow = frame.params.shadow;
    const Derived& derived = frame.derived;
    Pass pass = frame.pass("Shadow", "draws the casters once more through S, flat on the plane", Subject::objects);
    pass.shading = Shading::flat;
    pass.color = color_of(shadow.color, shadow.opacity);
    pass.blend = Blend::alpha;
    pass.depth.write = false;
    pass.world_from_scene = derived.shadow_sign * derived.shadow_from_world;
    pass.cull = CullParams{};  // which shadows fall never depends on culling
    const glm::dvec4 towards_light = derived.unit_plane * derived.shadow_sign;
    if (shadow.clip_casters) pass.clip_planes = {towards_light};

    if (shadow.clip_to_receiver)
        pass.stencil = {true, CompareFunc::equal, patch_reference,
                        shadow.stencil_once ? StencilOp::increment : StencilOp::keep};
    else if (shadow.stencil_once)  // beside the patch the value is 0, so it is replaced, not counted up
        pass.stencil = {true, CompareFunc::notequal, patch_reference + 1, StencilOp::replace};

    const double turned = offset_sign(frame.params.depth);
    switch (shadow.offset) {
        case ShadowOffset::none:
            break;
        case ShadowOffset::polygon_offset:
            pass.offset = DepthOffset{turned * shadow.offset_factor, turned * shadow.offset_units};
            break;
        case ShadowOffset::lift: {
            glm::dmat4 lifted_from_plane(1.0);
            lifted_from_plane[3] = glm::dvec4(glm::dvec3(frame.plane_towards_eye()) * shadow.lift, 1.0);
            pass.world_from_scene = lifted_from_plane * pass.world_from_scene;
            break;
        }
        case ShadowOffset::no_depth_test:
            pass.depth.test = false;
            break;
    }
    return pass;
}

/// Missing light: shadow goes into the stencil first, then the patch is drawn lit or unlit, each pixel once.
void add_missing_light(std::vector<Pass>& passes, const Frame& frame, bool mirrors) {
    Pass receiver = mirror_mask(frame);
    receiver.name = "Receiver mask";
    receiver.reason = "marks the patch in the stencil buffer as the receiver of shadows";
    if (!(mirrors && frame.params.reflection.stencil)) passes.push_back(receiver);

    Pass mask = shadow_pass(frame);
    mask.name = "Shadow mask";
    mask.reason = "marks where the light is missing: no colour yet";
    mask.color_write = false;
    mask.depth.test = false;
    mask.offset.reset();
    mask.stencil = {true, CompareFunc::equal, patch_reference, StencilOp::increment};
    passes.push_back(mask);

    for (const bool shadowed : {false, true}) {
        Pass patch = patch_surface(frame, mirrors);
        patch.name = shadowed ? "Patch in shadow" : "Patch in the light";
        patch.reason = shadowed ? "where the stencil counts a caster, only ambient light arrives"
                                : "where the stencil is clear, the light arrives";
        if (shadowed) patch.shading = Shading::unlit;
        patch.stencil = {true, CompareFunc::equal, patch_reference + (shadowed ? 1 : 0), StencilOp::keep};
        passes.push_back(patch);
    }
}

void add_passes(std::vector<Pass>& passes, const Frame& frame) {
    const bool mirrors =
        frame.params.reflection.enabled && frame.params.reflection.bounces > 0 && frame.eye_side != 0.0;
    const bool casts = frame.params.shadow.enabled && frame.light_reaches_seen_side();
    if (mirrors) {
        if (frame.params.reflection.stencil) passes.push_back(mirror_mask(frame));
        passes.push_back(mirror_image(frame));
    }
    if (casts && frame.params.shadow.style == ShadowStyle::missing_light) {
        add_missing_light(passes, frame, mirrors);
    } else {
        passes.push_back(patch_surface(frame, mirrors));
        if (casts) passes.push_back(shadow_pass(frame));
    }
    passes.push_back(frame.pass("Objects", "draws the scene itself", Subject::objects));
}

bool depends_on_stencil(const Pass& pass) {
    return pass.stencil.test && pass.stencil.func != CompareFunc::always;
}

FramePlan frame_plan(const Params& params, const Derived& derived) {
    FramePlan made;
    const Ground ground = ground_of(params.ui.theme);
    made.background = ground.background;
    made.unwritten = ground.unwritten;
    made.patch_light = ground.light;
    made.patch_dark = ground.dark;
    made.patch_line = ground.line;
    made.samples = params.view.samples;
    made.patch = derived.patch;
    return made;
}

}  // namespace

FramePlan plan(const Params& asked, const Derived& derived, const HiddenPictures& hidden) {
    Params params = asked;
    const bool shows_fighting = params.view.shows == Shows::fighting;
    if (shows_fighting) params.visibility = VisibilityParams{};  // it is about the depth buffer
    if (params.visibility.step >= 0 || shows_fighting) params.shadow.enabled = params.reflection.enabled = false;
    FramePlan made = frame_plan(params, derived);
    set_depth(made, params, derived);
    made.shows = params.view.shows;
    made.heat = derived.heat;
    if (is_drawn_by_gl_alone(params.visibility.method)) made.limit = {params.view.call, params.view.triangle};
    if (params.view.shows == Shows::depth || params.view.shows == Shows::stencil) made.samples = 0;

    const Frame frame{params,          derived, derived.clip_from_view, derived.view_from_world, derived.eye_world,
                      derived.eye_side};
    add_passes(made.passes, frame);
    draw_decals_apart(made.passes, params);
    if (params.view.shows == Shows::facing || shows_fighting) {
        const Shading shading = shows_fighting ? Shading::heat : Shading::facing;
        for (Pass& pass : made.passes)
            if (pass.subject == Subject::objects && pass.shading == Shading::lit) pass.shading = shading;
    }
    use_hidden_surfaces(made, params, derived, hidden);
    if (params.view.shows == Shows::overdraw) count_overdraw(made);
    // GL has no stencil beside 16 bits of depth; what stands in for it holds one value a pixel.
    if (made.depth_format == DepthFormat::d16 && std::ranges::any_of(made.passes, depends_on_stencil)) made.samples = 0;
    return made;
}

FramePlan plan_observer(const Params& params, const Derived& derived, const ObserverView& observer) {
    Params plain = params;
    plain.depth = DepthParams{};
    plain.cull = CullParams{};
    plain.visibility = VisibilityParams{};
    plain.reflection.clip = MirrorClip::clip_distance;
    FramePlan made = frame_plan(params, derived);
    const glm::dmat4 clip_from_view = observer.clip_from_world * observer.world_from_view;
    const double eye_side = glm::dot(derived.unit_plane, observer.eye_world);
    made.decal_offset = {-1.0, -2.0};
    add_passes(made.passes, {plain, derived, clip_from_view, observer.view_from_world, observer.eye_world, eye_side});
    return made;
}

}  // namespace viewing
