// The technique, pass by pass: for each plane the mirror image inside the stenciled patch, the patch, and the shadows
// on it; then the objects. The world that a mirror shows is in plan_mirror.cpp, shadows in plan_shadow.cpp. Nothing
// here depends on the sign or length of the plane's equation, only on which side of the plane the eye and the light are
// on. Source: lecture, Planar Shadow and Planar Reflection; Kilgard 1999.
#include "frame/plan/plan.h"

#include <algorithm>
#include <numeric>

#include "frame/ground.h"
#include "frame/plan/plan_parts.h"
#include "frame/say.h"
#include "text/numbers.h"

namespace viewing {
namespace {

/// Flips the comparison for reversed depth; the parameters keep the convention that less is nearer.
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

CullParams with_flipped_winding(CullParams cull) {
    cull.front_face = cull.front_face == FrontFace::ccw ? FrontFace::cw : FrontFace::ccw;
    return cull;
}

/// Returns whether a patch seen in a mirror is entirely behind that mirror.
bool is_hidden(const Level& level, std::size_t plane) {
    const std::array<glm::dvec3, 4> corners = level.plane(plane).patch.corners();
    return level.clip && std::all_of(corners.begin(), corners.end(), [&](const glm::dvec3& corner) {
               return glm::dot(*level.clip, glm::dvec4(corner, 1.0)) <= 0.0;
           });
}

/// Adds passes that restore the mirror's stencil value, from which the next patch starts to count.
void give_region_back(std::vector<Pass>& passes, const Level& level, std::size_t plane) {
    Pass clear = patch_mask(level, plane, {marked("Clear lights"), marked("Clear lights {plane}")},
                            message("clears this patch's record of missing lights"));
    clear.depth.test = false;
    clear.stencil = stencil_of_forgetting_lights(level, plane);
    if (!level.casting_lights(plane).empty()) passes.push_back(clear);
    Pass back = patch_mask(level, plane, {marked("Unmark the patch"), marked("Unmark patch {plane}")},
                           message("decrements the stencil to the mirror's value"));
    back.depth.test = false;
    back.stencil = stencil_of_leaving(level, plane);
    passes.push_back(back);
}

void add_plane(std::vector<Pass>& passes, const Level& level, std::size_t plane) {
    const ReflectionParams& reflection = level.params.reflection;
    const bool mirrors = level.mirrors(plane), casts = !level.casting_lights(plane).empty();
    if (mirrors) add_mirror_image(passes, level, plane);
    if (casts && level.params.shadow.style == ShadowStyle::missing_light) {
        add_missing_light(passes, level, plane);
    } else {
        std::vector<std::size_t> all_lights(level.lights_world.size());
        std::iota(all_lights.begin(), all_lights.end(), std::size_t{0});
        passes.push_back(patch_surface(level, plane, all_lights, mirrors));
        if (casts) add_shadows(passes, level, plane);
    }
    const bool is_marked = (mirrors && reflection.stencil) || casts;
    if (!level.is_real() && is_marked) give_region_back(passes, level, plane);
}

/// Returns the shading that a view uses for the scene's objects instead of lighting; none if they are lit.
std::optional<Shading> shading_of(Shows shows) {
    switch (shows) {
        case Shows::facing:
            return Shading::facing;
        case Shows::fighting:
            return Shading::heat;
        case Shows::shadow_w:
            return Shading::caster_w;
        default:
            return std::nullopt;
    }
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
    const CastShadow& cast = derived.chosen_shadow();
    made.caster_w = cast.sign * glm::transpose(cast.shadowed_world_from_world)[3];
    made.caster_side = plane_facing(derived.chosen_plane().unit_plane, cast.light_world);
    for (const DerivedPlane& plane : derived.planes) made.patches.push_back(plane.patch);
    return made;
}

}  // namespace

glm::dvec4 color_of(const Color& color, double alpha) {
    return {color.r / 255.0, color.g / 255.0, color.b / 255.0, alpha};
}

bool Level::mirrors(std::size_t index) const {
    return plane(index).mirrors && bounces() < deepest && eye_side(index) != 0.0 &&
           (is_real() || params.reflection.stencil);
}

std::vector<std::size_t> Level::casting_lights(std::size_t index) const {
    std::vector<std::size_t> lights;
    if (!params.shadow.enabled || !plane(index).receives_shadow || !(is_real() || params.reflection.shadows))
        return lights;
    for (std::size_t light = 0; light < plane(index).shadows.size(); ++light)
        if (plane(index).shadows[light].reaches(eye_side(index))) lights.push_back(light);
    return lights;
}

std::string Level::mirror_symbol(std::size_t plane_index) const {
    const bool is_turned = params.reflection.printed_by_rows && !plane(plane_index).mirror_by_hand;
    const std::string number = derived.planes.size() > 1 ? lowered_text({plane_index + 1}) : "";
    return "R" + number + (is_turned ? "ᵀ" : "");
}

std::string Level::shadow_symbol(std::size_t plane_index, std::size_t light) const {
    const bool has_several = derived.planes.size() > 1 || derived.lights_world.size() > 1;
    const bool is_turned = params.slips.shadow_by_rows && !plane(plane_index).shadows[light].by_hand;
    const std::string symbol =
        "S" + (has_several ? lowered_text({plane_index + 1, light + 1}) : "") + (is_turned ? "ᵀ" : "");
    return plane(plane_index).shadows[light].sign < 0.0 ? "(−" + symbol + ")" : symbol;
}

int Level::region_of(std::size_t index) const {
    if (!is_real()) return region + 1;
    return params.shadow.own_stencil ? static_cast<int>(index) + 1 : 1;
}

Message Level::placed(const Message& name) const {
    if (is_real() || derived.planes.size() == 1) return name;
    return message("{pass} in mirror {mirrors}", "pass"_a = name, "mirrors"_a = numbers_name(mirrors_met));
}

Pass Level::pass(const Message& name, const Message& reason, Subject subject) const {
    Pass made;
    made.name = placed(name);
    made.reason = reason;
    made.subject = subject;
    made.is_mirror_image = !is_real();
    made.mirrors_met = mirrors_met;
    made.matrices = matrices;
    made.world_from_scene = world_from_scene;
    made.clip_from_world = clip_from_view * view_from_world;
    made.view_from_world = view_from_world;
    made.eye_world = eye_world;
    made.lights_world = lights_world;
    made.lights.resize(lights_world.size());
    std::iota(made.lights.begin(), made.lights.end(), std::size_t{0});
    made.light_strength = 1.0 / static_cast<double>(lights_world.size());
    made.sky_world = sky_world;
    made.depth = {.test = params.tests_depth(),
                  .func = func_for(params.depth.func, params.depth.mapping),
                  .write = params.depth.write};
    if (subject == Subject::objects)
        made.cull = flips_winding && params.reflection.flip_winding ? with_flipped_winding(params.cull) : params.cull;
    if (clip) made.clip_planes = {*clip};
    made.stencil = stencil_of_level(*this);
    return made;
}

Pass Level::patch_pass(const PatchName& name, const Message& reason, std::size_t index) const {
    Pass made = pass(derived.planes.size() == 1 ? message(fmt::runtime(name.alone))
                                                : message(fmt::runtime(name.numbered), "plane"_a = index + 1),
                     reason, Subject::patch);
    made.plane = index;
    made.has_gloss = plane(index).gloss;
    return made;
}

Pass objects_pass(const Level& level) {
    if (level.is_real()) return level.pass(message("Objects"), message("draws the scene itself"), Subject::objects);
    return level.pass(message("Mirror image"),
                      message("draws the scene once more through R, as if the mirror were a window"), Subject::objects);
}

Pass patch_surface(const Level& level, std::size_t plane, std::span<const std::size_t> lights, bool blends) {
    const ReflectionParams& reflection = level.params.reflection;
    Pass pass = level.patch_pass(
        {marked("Patch"), marked("Patch {plane}")},
        blends ? message("blends the plane over its mirror image and gives these pixels the plane's own depth")
               : message("draws the plane and marks it in the stencil buffer as a shadow receiver"),
        plane);
    pass.lights_world.clear();
    pass.lights.clear();
    for (const std::size_t light : lights) {
        if (!level.plane(plane).shadows[light].reaches(level.eye_side(plane))) continue;
        pass.lights_world.push_back(level.lights_world[light]);
        pass.lights.push_back(light);
    }
    pass.shading = pass.lights_world.empty() ? Shading::unlit : Shading::lit;
    if (blends) {
        pass.blend = Blend::alpha;
        pass.color.a = 1.0 - reflection.reflectance;
        if (reflection.stencil) pass.depth.func = CompareFunc::always;  // the mask decides where the patch shows
    }
    pass.stencil = stencil_of_surface(level, plane, blends);
    return pass;
}

void add_world(std::vector<Pass>& passes, Level level) {
    const bool gl_alone = is_drawn_by_gl_alone(level.params.visibility.method);
    const ReflectionParams& reflection = level.params.reflection;
    const auto planes_drawn = drawn_planes(level.params, level.derived);
    const bool mirrors = reflection.enabled && std::any_of(planes_drawn.begin(), planes_drawn.end(),
                                                           [](const DerivedPlane& plane) { return plane.mirrors; });
    const bool objects_first = level.is_real() && gl_alone && mirrors && reflection.after_objects;
    if (objects_first) {
        passes.push_back(objects_pass(level));
        level.is_fresh = false;
    }
    for (std::size_t plane = 0; plane < planes_drawn.size(); ++plane) {
        if ((!level.is_real() && level.mirrors_met.back() == plane) || is_hidden(level, plane)) continue;
        add_plane(passes, level, plane);
        level.is_fresh = false;
    }
    if (!objects_first) passes.push_back(objects_pass(level));
}

bool shows_effects(const Params& params) {
    return !is_taken_apart(params.visibility) && params.view.shows != Shows::fighting &&
           params.view.shows != Shows::overdraw;
}

std::span<const DerivedPlane> drawn_planes(const Params& params, const Derived& derived) {
    return std::span(derived.planes).first(is_drawn_by_gl_alone(params.visibility.method) ? derived.planes.size() : 1);
}

void add_scene_passes(std::vector<Pass>& passes, const Params& params, const Derived& derived, const Eye& eye) {
    Level level{.params = params,
                .derived = derived,
                .projection = eye.clip_from_view,
                .clip_from_view = eye.clip_from_view,
                .view_from_world = eye.view_from_world,
                .eye_world = eye.eye_world,
                .eye_scene = eye.eye_world,
                .lights_world = derived.lights_world,
                .deepest = reflection_depth(params, derived)};
    add_world(passes, std::move(level));
}

FramePlan plan(const Params& asked, const Derived& derived, const HiddenPictures& hidden) {
    Params params = asked;
    const bool shows_fighting = params.view.shows == Shows::fighting;
    if (shows_fighting) params.visibility = VisibilityParams{};  // this view is about the depth buffer
    if (is_taken_apart(params.visibility) || shows_fighting) params.shadow.enabled = params.reflection.enabled = false;
    FramePlan made = frame_plan(params, derived);
    set_depth(made, params, derived);
    made.shows = params.view.shows;
    made.heat = derived.heat;
    if (is_drawn_by_gl_alone(params.visibility.method))
        made.limit = {params.view.call, params.view.triangle, params.view.pass};
    if (params.view.shows == Shows::depth || params.view.shows == Shows::stencil) made.samples = 0;

    add_scene_passes(made.passes, params, derived,
                     {derived.clip_from_view, derived.view_from_world, derived.eye_world});
    made.reflection_depth = reflection_depth(params, derived);
    draw_decals_apart(made.passes, params);
    if (const std::optional<Shading> shading = shading_of(params.view.shows)) {
        const bool in_mirrors = *shading != Shading::caster_w;  // mirror images cast no shadow
        for (Pass& pass : made.passes)
            if (pass.subject == Subject::objects && pass.shading == Shading::lit &&
                (in_mirrors || !pass.is_mirror_image))
                pass.shading = *shading;
    }
    use_hidden_surfaces(made, params, derived, hidden);
    if (params.view.shows == Shows::overdraw) count_overdraw(made);
    // With 16 bits of depth, a mask replaces the stencil (gl/target.h); it has one value per pixel, not per sample.
    if (made.depth_format == DepthFormat::d16 &&
        std::any_of(made.passes.begin(), made.passes.end(), depends_on_stencil))
        made.samples = 0;
    return made;
}

FramePlan plan_observer(const Params& params, const Derived& derived, const ObserverView& observer) {
    Params plain = params;
    plain.depth = DepthParams{};
    plain.cull = CullParams{};
    plain.visibility = VisibilityParams{};
    plain.reflection.clip = MirrorClip::clip_distance;
    plain.reflection.same_projection = true;  // in mirrors, only the camera's view uses another projection or fovy
    plain.reflection.fovy = 0.0;
    FramePlan made = frame_plan(params, derived);
    if (params.observer.image_space) plain.reflection.stencil = false;  // show the whole image
    made.decal_offset = {-1.0, -2.0};
    add_scene_passes(
        made.passes, plain, derived,
        {observer.clip_from_world * observer.world_from_view, observer.view_from_world, observer.eye_world});
    return made;
}

}  // namespace viewing
