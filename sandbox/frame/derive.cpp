// Computes every number from the parameters. Matrices multiply from right to left: clip ← view ← world. Read plan.cpp
// next, which uses these numbers.
#include "frame/derive.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "frame/matrix_facts.h"
#include "frame/object_reach.h"
#include "geometry/camera.h"
#include "geometry/projection.h"
#include "topics/depth/numbers/decals.h"
#include "topics/planes/numbers/lecture_code.h"

namespace viewing {
namespace {

StoredDepth stored_depth_of(const DepthParams& depth, const Viewport& viewport) {
    const DepthPrecision asked = precision_of(depth.format);
    StoredDepth stored = viewport.stored_depth.value_or(StoredDepth{asked, std::nullopt});
    if (stores_fewer_bits(depth.format)) stored.precision = asked;
    if (writes_depth_by_shader(depth.format, depth.mapping, depth.logarithm_per_vertex)) stored.unit_codes = 1.0;
    return stored;
}

/// Converts a P for the clip range 0 … 1 to the range −1 … 1: z′ = 2 z − w.
glm::dmat4 with_range_around_zero(glm::dmat4 p) {
    for (int column = 0; column < 4; ++column) p[column][2] = 2.0 * p[column][2] - p[column][3];
    return p;
}

double aspect_of(const Params& params, double view_aspect) {
    if (const Lens lens = params.lens(); lens.window) return lens.window->aspect();
    return params.projection.aspect > 0.0 ? params.projection.aspect : view_aspect;
}

/// Returns P as the lens defines it.
glm::dmat4 projection_of(const Params& params, double aspect, bool zero_to_one) {
    if (params.depth.mapping != DepthMapping::reversed) return clip_from_view(params.lens(), aspect);
    const glm::dmat4 p = clip_from_view_reversed(params.lens(), aspect);
    return zero_to_one ? p : with_range_around_zero(p);
}

void derive_camera(Derived& derived, const Params& params, const Viewport& viewport) {
    const CameraParams& camera = params.camera;
    derived.look_at = camera.look_at();
    const glm::dmat4 rotation = rotation_from_angles(camera.angles());
    if (params.slips.swapped_order) {
        glm::dmat4 translation(1.0);
        translation[3] = glm::dvec4(camera.position, 1.0);
        derived.world_from_view = rotation * translation;
    } else {
        derived.world_from_view = world_from_view(camera.position, camera.angles());
    }
    // If C is uploaded as V, the eye's axes come from C⁻¹.
    const glm::dmat4 inverse_camera = view_from_world(derived.world_from_view);
    const bool swapped = params.slips.camera_as_view;
    const CameraOverrides& by_hand = params.camera_overrides;
    derived.view_from_world = by_hand.view_from_world.value_or(swapped ? derived.world_from_view : inverse_camera);
    const glm::dmat4& seen_from = swapped ? inverse_camera : derived.world_from_view;
    // With parallel view rays, their direction alone decides which side of a plane is visible.
    derived.eye_world = seen_from[params.projection.is_orthographic() ? 2 : 3];
    derived.facts.view_residual = largest_entry(derived.view_from_world * derived.world_from_view - glm::dmat4(1.0));

    const Lens lens = params.lens();
    const bool reversed = params.depth.mapping == DepthMapping::reversed;
    derived.view_px = glm::max(viewport.size_px, 1);
    derived.view_aspect = viewport.aspect();
    derived.aspect = aspect_of(params, derived.view_aspect);
    derived.clip_zero_to_one = reversed && viewport.clip_control && params.depth.reversed_zero_to_one;
    derived.stored_depth = stored_depth_of(params.depth, viewport);
    // A P entered by hand is made for the state's clip range, which the driver may not support.
    const bool lacks_range = params.depth.reversed_zero_to_one && reversed && !derived.clip_zero_to_one;
    derived.clip_from_view = !by_hand.clip_from_view ? projection_of(params, derived.aspect, derived.clip_zero_to_one)
                             : lacks_range           ? with_range_around_zero(*by_hand.clip_from_view)
                                                     : *by_hand.clip_from_view;
    derived.clip_from_world = derived.clip_from_view * derived.view_from_world;
    if (by_hand.view_from_world || by_hand.clip_from_view) {
        derived.eye_world = eye_of(derived.clip_from_world, reversed).value_or(derived.eye_world);
        derived.has_distances =
            is_affine(derived.view_from_world) && (!by_hand.clip_from_view || params.lens_by_hand().has_value());
    }

    const glm::dvec4 target_view = derived.view_from_world * glm::dvec4(camera.target, 1.0);
    derived.facts.target_distance = std::clamp(-target_view.z, lens.near, lens.far);
    const DepthPrecision precision = precision_of(params.depth.format);
    Facts& facts = derived.facts;
    facts.depth_step_at_target = depth_step(params, facts.target_distance);
    facts.resolvable_step_at_target =
        resolvable_depth_step(lens, params.depth.mapping, precision, facts.target_distance);
}

CastShadow cast_shadow(const glm::dvec4& unit_plane, const glm::dvec4& light, const Params& params,
                       const std::optional<glm::dmat4>& by_hand) {
    CastShadow cast;
    cast.light_world = light;
    cast.plane_dot_light = glm::dot(unit_plane, light);
    cast.light_in_plane = lies_in_plane(unit_plane, light);
    const glm::dmat4 right = shadow_matrix(unit_plane, light);
    const glm::dmat4 filled = params.slips.shadow_by_rows ? glm::transpose(right) : right;
    cast.shadowed_world_from_world = by_hand.value_or(filled);
    cast.has_slip = !by_hand && largest_entry(filled - right) > 1e-9;
    cast.by_hand = by_hand.has_value();
    // If casters are clipped at the light, the w of every remaining point has the same sign, so forcing the sign
    // negates all points or none.
    const ShadowParams& shadow = params.shadow;
    const bool forces_one_sign = shadow.sign == ShadowSign::forced && shadow.clip_at_light;
    cast.sign = shadow.sign == ShadowSign::plane_dot_light || forces_one_sign ? shadow_sign(unit_plane, light) : 1.0;
    return cast;
}

/// Returns whether part of a caster may land more than 16 times as far from the patch's center as the patch's edge.
bool lands_far(const CastShadow& cast, const DerivedPlane& plane, const Scene& scene) {
    constexpr double far_away = 16.0;
    PlanePatch around = plane.patch;
    around.extent *= far_away;
    const glm::dmat4 landed = cast.sign * cast.shadowed_world_from_world;
    const glm::dvec4 towards_light = plane_facing(plane.unit_plane, cast.light_world);
    for (const glm::dvec4& edge : forms_of_edges(landed, around)) {
        const std::array beyond = {-edge, towards_light, glm::transpose(landed)[3]};
        if (may_reach_each(scene, beyond)) return true;
    }
    return false;
}

/// Returns R as it is uploaded, with the mistakes that are switched on.
glm::dmat4 mirror_with_slips(const glm::dvec4& equation, const SlipParams& slips, bool printed_by_rows) {
    const glm::dmat4 mirror =
        mirror_matrix_as_typed(slips.normal_not_unit ? equation : unit_plane(equation), slips.plus_2ab);
    // The lecture fills its array by rows; GL reads columns.
    return printed_by_rows ? glm::transpose(mirror) : mirror;
}

DerivedPlane derive_one_plane(const PlaneParams& plane, const PlaneOverrides& by_hand, const Derived& derived,
                              const Params& params, const Scene& scene) {
    DerivedPlane made;
    made.unit_plane = unit_plane(plane.equation);
    made.patch = plane_patch(plane.equation, plane.extent);
    made.eye_side = glm::dot(made.unit_plane, derived.eye_world);
    made.receives_shadow = plane.receives_shadow;
    made.mirrors = plane.mirrors;
    made.gloss = plane.gloss;
    const bool by_rows = params.reflection.printed_by_rows;
    const glm::dmat4 mirror = mirror_with_slips(plane.equation, params.slips, by_rows);
    made.mirrored_world_from_world = by_hand.mirrored_world_from_world.value_or(mirror);
    made.mirror_by_hand = by_hand.mirrored_world_from_world.has_value();
    made.mirror_has_slip =
        !made.mirror_by_hand && largest_entry(mirror - mirror_with_slips(plane.equation, {}, by_rows)) > 1e-9;
    for (std::size_t light = 0; light < derived.lights_world.size(); ++light)
        made.shadows.push_back(cast_shadow(made.unit_plane, derived.lights_world[light], params,
                                           by_hand.shadowed_world_from_world[light]));
    for (CastShadow& cast : made.shadows)
        cast.lands_far = params.shadow.enabled && made.receives_shadow && !cast.light_in_plane && !cast.by_hand &&
                         !cast.has_slip && lands_far(cast, made, scene);
    return made;
}

void derive_planes(Derived& derived, const Params& params, const Scene& scene) {
    for (const LightParams& light : params.lights) derived.lights_world.push_back(light.position);
    for (std::size_t plane = 0; plane < params.planes.size(); ++plane)
        derived.planes.push_back(
            derive_one_plane(params.planes[plane], params.overrides[plane], derived, params, scene));
    derived.chosen = params.chosen();
}

/// Returns the position of the followed point; nullopt if none is followed, or the scene lacks the vertex.
std::optional<glm::dvec3> place_of_followed(const std::optional<Follow>& follow, const Scene& scene) {
    if (!follow || follow->point) return follow ? follow->point : std::nullopt;
    const SceneObject* object = scene.find(follow->object);
    if (!object || !object->mesh) return std::nullopt;
    const auto vertex = static_cast<std::size_t>(follow->vertex);
    if (vertex >= object->mesh->positions.size()) return std::nullopt;
    return glm::dvec3(object->world_from_model * glm::dvec4(object->mesh->positions[vertex], 1.0));
}

std::optional<FollowedPoint> derive_followed(const Derived& derived, const Params& params, const Scene& scene) {
    const std::optional<glm::dvec3> place = place_of_followed(params.follow, scene);
    if (!place) return std::nullopt;
    FollowedPoint followed;
    const glm::dvec4 point(*place, 1.0);
    followed.point_world = *place;
    const DerivedPlane& plane = derived.chosen_plane();
    followed.shadow_homogeneous = derived.chosen_shadow().shadowed_world_from_world * point;
    if (std::abs(followed.shadow_homogeneous.w) > 1e-12)
        followed.shadow_world = glm::dvec3(followed.shadow_homogeneous) / followed.shadow_homogeneous.w;
    followed.plane_distance = glm::dot(plane.unit_plane, point);
    followed.foot_world = followed.point_world - followed.plane_distance * glm::dvec3(plane.unit_plane);
    const glm::dvec4 mirrored = plane.mirrored_world_from_world * point;
    followed.mirrored_world = glm::dvec3(mirrored) / (mirrored.w != 0.0 ? mirrored.w : 1.0);
    return followed;
}

}  // namespace

DepthPrecision precision_of(DepthFormat format) {
    switch (format) {
        case DepthFormat::d16:
            return {16, false};
        case DepthFormat::d24:
            return {24, false};
        case DepthFormat::d32f:
            return {32, true};
        default:
            return {4 + static_cast<int>(format), false};  // d4 … d12 come first in the enumeration
    }
}

bool stores_fewer_bits(DepthFormat format) {
    return precision_of(format).bits < 16;
}

bool writes_depth_by_shader(DepthFormat format, DepthMapping mapping, bool logarithm_per_vertex) {
    return stores_fewer_bits(format) || (mapping == DepthMapping::logarithmic && !logarithm_per_vertex);
}

bool depends_on_stored_depth(const Params& params, const Scene& scene) {
    const DepthParams& depth = params.depth;
    if (stores_fewer_bits(depth.format)) return false;
    const bool moves_decals = depth.decals == DecalMethod::offset && depth.offset.units != 0.0 && has_decals(scene);
    // With the standard mapping, nearly all depths are above 1/2. There, floats are 2⁻²⁴ apart, just like 24-bit codes.
    return moves_decals || (depth.format == DepthFormat::d24 && depth.mapping != DepthMapping::standard);
}

double depth_step(const Params& params, double z) {
    return depth_step(params.lens(), params.depth.mapping, precision_of(params.depth.format), z);
}

glm::dmat4 projection_without_hand(const Params& params, const Derived& derived) {
    if (!params.camera_overrides.clip_from_view) return derived.clip_from_view;
    Params own = params;
    own.camera_overrides.clip_from_view.reset();
    return projection_of(own, aspect_of(own, derived.view_aspect), derived.clip_zero_to_one);
}

double w_between(const DerivedPlane& plane, const CastShadow& cast) {
    const glm::dvec4 towards_light = plane_facing(plane.unit_plane, cast.light_world);
    const double height = is_parallel_light(cast.light_world)
                              ? 1.0
                              : 0.5 * std::abs(cast.plane_dot_light) / std::max(cast.light_world.w, 1e-12);
    const glm::dvec4 between(plane.patch.center + height * glm::dvec3(towards_light), 1.0);
    return cast.sign * (cast.shadowed_world_from_world * between).w;
}

Derived derive(const Params& params, const Scene& scene, const Viewport& viewport) {
    Derived derived;
    derive_camera(derived, params, viewport);
    derive_planes(derived, params, scene);
    derived.followed = derive_followed(derived, params, scene);
    derived.has_decals = has_decals(scene);
    if (params.depth.decals == DecalMethod::stencil) derived.object_marks = decal_marks(scene);
    if (params.view.shows == Shows::fighting && derived.has_distances) derived.heat = heat_map(params, derived, scene);
    return derived;
}

}  // namespace viewing
