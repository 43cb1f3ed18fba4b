// Planar shadows: S flattens the casters onto a patch. A shadow is painted over the patch or, as missing light, marked
// before the patch is drawn. Each light has a stencil bit. Source: lecture, Planar Shadow and Projection Shadow;
// Kilgard 1999.
#include <algorithm>
#include <cmath>

#include "frame/object_reach.h"
#include "frame/plan/plan_parts.h"
#include "frame/say.h"

namespace viewing {
namespace {

/// Returns clip planes that keep the space between the light and the plane: in front of the plane, with a positive w.
/// If triangles may land many patch sizes away and `ends_at_patch` is set, also clips them around the patch: float32 is
/// too coarse to compare the depths of such long triangles with the plane's.
std::vector<ClipPlane> caster_clips(const ShadowParams& shadow, const DerivedPlane& plane, const CastShadow& cast,
                                    bool ends_at_patch) {
    const glm::dvec4 towards_light = plane_facing(plane.unit_plane, cast.light_world);
    std::vector<ClipPlane> clips;
    if (shadow.clip_casters) clips.push_back(towards_light);
    if (shadow.clip_at_light && cast.light_world.w > 0.0) {
        // Clips slightly before w = 0, since float32 may get the sign of w wrong there, and a light may almost touch a
        // caster.
        constexpr double smallest_w = 1e-5;
        glm::dvec4 w_of_point = -cast.light_world.w * towards_light;
        w_of_point.w += (1.0 - smallest_w) * std::abs(cast.plane_dot_light);
        clips.push_back(w_of_point);
    }
    if (cast.lands_far && ends_at_patch) {
        // The stencil decides exactly where the shadow ends.
        constexpr double margin = 1.25;
        PlanePatch around = plane.patch;
        around.extent *= margin;
        for (const glm::dvec4& edge : forms_of_edges(cast.sign * cast.shadowed_world_from_world, around))
            clips.push_back(edge);
    }
    return clips;
}

void set_offset(Pass& pass, const Level& level, std::size_t plane) {
    const ShadowParams& shadow = level.params.shadow;
    const double turned = offset_sign(level.params.depth);
    switch (shadow.offset) {
        case ShadowOffset::none:
            break;
        case ShadowOffset::polygon_offset:
            pass.offset = DepthOffset{turned * shadow.offset_factor, turned * shadow.offset_units};
            break;
        case ShadowOffset::lift: {
            glm::dmat4 lifted_from_plane(1.0);
            lifted_from_plane[3] = glm::dvec4(glm::dvec3(level.plane_towards_eye(plane)) * shadow.lift, 1.0);
            const CastShadow& cast = level.plane(plane).shadows[pass.light];
            pass.world_from_scene =
                level.world_from_scene * lifted_from_plane * (cast.sign * cast.shadowed_world_from_world);
            break;
        }
        case ShadowOffset::no_depth_test:
            pass.depth.test = false;
            break;
    }
}

/// Returns a pass that flattens the casters onto the plane with S and draws them as the level sees them.
Pass shadow_pass(const Level& level, std::size_t plane, std::size_t light, const Message& name, const Message& reason) {
    const CastShadow& cast = level.plane(plane).shadows[light];
    Pass pass = level.pass(name, reason, Subject::objects);
    pass.plane = plane;
    pass.light = light;
    pass.shading = Shading::flat;
    pass.depth.write = false;
    pass.world_from_scene = level.world_from_scene * (cast.sign * cast.shadowed_world_from_world);
    pass.matrices = level.matrices + " " + level.shadow_symbol(plane, light);
    // If casters are clipped at the light, no negative w remains, so no sign has to be forced.
    const ShadowParams& shadow = level.params.shadow;
    pass.forces_sign = shadow.sign == ShadowSign::forced && !shadow.clip_at_light;
    pass.cull = CullParams{};  // culling must never remove a shadow
    const bool ends_at_patch = (shadow.clip_to_receiver || !level.is_real()) && !pass.forces_sign;
    pass.clip_planes = caster_clips(shadow, level.plane(plane), cast, ends_at_patch);
    return pass;
}

Message name_without(const Level& level, std::span<const std::size_t> missing) {
    if (missing.empty()) return message("Patch in the light");
    if (level.derived.lights_world.size() == 1) return message("Patch in shadow");
    return message("Patch without light {lights}", "lights"_a = numbers_name(missing));
}

}  // namespace

void add_shadows(std::vector<Pass>& passes, const Level& level, std::size_t plane) {
    const ShadowParams& shadow = level.params.shadow;
    const std::vector<std::size_t> lights = level.casting_lights(plane);
    // All shadows together are as dark as the shadow of a single light.
    const auto share = 1.0 / static_cast<double>(lights.size());
    const double opacity = lights.size() == 1 ? shadow.opacity : 1.0 - std::pow(1.0 - shadow.opacity, share);
    const bool is_alone = level.derived.lights_world.size() == 1;
    for (const std::size_t light : lights) {
        Pass pass =
            shadow_pass(level, plane, light,
                        is_alone ? message("Shadow") : message("Shadow of light {light}", "light"_a = light + 1),
                        message("draws the casters once more through S, flattened onto the plane"));
        pass.color = color_of(shadow.color, opacity);
        pass.blend = Blend::alpha;
        pass.depth.write = shadow.write_depth && level.params.depth.write;
        pass.stencil = stencil_of_shadow(level, plane, light);
        set_offset(pass, level, plane);
        passes.push_back(pass);
    }
}

void add_missing_light(std::vector<Pass>& passes, const Level& level, std::size_t plane) {
    const bool mirrors = level.mirrors(plane);
    if (!(mirrors && level.params.reflection.stencil))
        passes.push_back(patch_mask(level, plane, {marked("Receiver mask"), marked("Receiver mask {plane}")},
                                    message("marks the patch in the stencil buffer as a shadow receiver")));
    const std::vector<std::size_t> lights = level.casting_lights(plane);
    const bool is_alone = level.derived.lights_world.size() == 1;
    for (const std::size_t light : lights) {
        Pass mask = shadow_pass(
            level, plane, light,
            is_alone ? message("Shadow mask") : message("Shadow mask of light {light}", "light"_a = light + 1),
            message("marks the pixels that the light does not reach; draws no color yet"));
        mask.color_write = false;
        mask.depth.test = false;
        mask.stencil = stencil_of_shadow(level, plane, light);
        passes.push_back(mask);
    }

    for (unsigned int set = 0; set < 1U << lights.size(); ++set) {
        std::vector<std::size_t> shining, missing;
        for (std::size_t i = 0; i < lights.size(); ++i) {
            const bool is_missing = (set >> i & 1U) != 0;
            (is_missing ? missing : shining).push_back(lights[i]);
        }
        Pass patch = patch_surface(level, plane, shining, mirrors);
        patch.name = level.placed(name_without(level, missing));
        patch.reason =
            missing.empty() ? message("where the stencil marks no shadow, the patch is fully lit")
            : shining.empty()
                ? message("where the stencil marks a shadow, only ambient light arrives")
                : message("where the stencil marks the shadows of these lights, only the other lights arrive");
        patch.stencil = stencil_of_patch_without(level, plane, missing);
        passes.push_back(patch);
    }
}

}  // namespace viewing
