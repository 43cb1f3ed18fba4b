// Params in, every number out. Matrices multiply from right to left: clip ← view ← world.
// Read plan.cpp next: what is done with these numbers.
#include "frame/derive.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "frame/decals.h"
#include "frame/matrix_facts.h"
#include "frame/problems.h"
#include "geometry/camera.h"
#include "geometry/projection.h"

namespace viewing {
namespace {

void derive_camera(Derived& derived, const Params& params, const Viewport& viewport) {
    const CameraParams& camera = params.camera;
    const glm::dmat4 rotation = rotation_from_angles(camera.angles());
    if (params.slips.swapped_order) {
        glm::dmat4 translation(1.0);
        translation[3] = glm::dvec4(camera.position, 1.0);
        derived.world_from_view = rotation * translation;
    } else {
        derived.world_from_view = world_from_view(camera.position, camera.angles());
    }
    // C as V: then C⁻¹ is what the eye's axes are taken from.
    const glm::dmat4 inverse_camera = view_from_world(derived.world_from_view);
    const bool swapped = params.slips.camera_as_view;
    derived.view_from_world = swapped ? derived.world_from_view : inverse_camera;
    const glm::dmat4& seen_from = swapped ? inverse_camera : derived.world_from_view;
    // Parallel lines of sight see a plane's side by their direction alone, wherever the camera stands.
    derived.eye_world = seen_from[params.projection.type == ProjectionType::orthographic ? 2 : 3];
    derived.facts.view_residual = largest_entry(derived.view_from_world * derived.world_from_view - glm::dmat4(1.0));

    const Lens lens = params.projection.lens();
    const bool reversed = params.depth.mapping == DepthMapping::reversed;
    derived.aspect = viewport.aspect();
    derived.clip_zero_to_one = reversed && viewport.clip_control && params.depth.reversed_zero_to_one;
    derived.clip_from_view = clip_from_view(lens, derived.aspect);
    if (reversed) {
        derived.clip_from_view = clip_from_view_reversed(lens, derived.aspect);
        if (!derived.clip_zero_to_one) {  // back to −1 … 1: z′ = 2 z − w
            for (int column = 0; column < 4; ++column)
                derived.clip_from_view[column][2] =
                    2.0 * derived.clip_from_view[column][2] - derived.clip_from_view[column][3];
        }
    }
    derived.clip_from_world = derived.clip_from_view * derived.view_from_world;

    const glm::dvec4 target_view = derived.view_from_world * glm::dvec4(camera.target, 1.0);
    derived.facts.target_distance = std::clamp(-target_view.z, lens.near, lens.far);
    derived.facts.depth_step_at_target = resolvable_depth_step(
        lens, params.depth.mapping, precision_of(params.depth.format), derived.facts.target_distance);
}

CastShadow cast_shadow(const glm::dvec4& unit_plane, const glm::dvec4& light, ShadowSign sign) {
    CastShadow cast;
    cast.light_world = light;
    cast.plane_dot_light = glm::dot(unit_plane, light);
    // Touching counts as lying in the plane when P·L is this small against the light's own size.
    cast.light_in_plane = std::abs(cast.plane_dot_light) <= 1e-9 * std::max(1.0, glm::length(light));
    cast.shadow_from_world = shadow_matrix(unit_plane, light);
    cast.sign = sign == ShadowSign::plane_dot_light ? shadow_sign(unit_plane, light) : 1.0;
    return cast;
}

DerivedPlane derive_one_plane(const PlaneParams& plane, const Derived& derived, const Params& params) {
    DerivedPlane made;
    made.unit_plane = unit_plane(plane.equation);
    made.patch = plane_patch(plane.equation, plane.extent);
    made.receives_shadow = plane.receives_shadow;
    made.mirrors = plane.mirrors;
    made.gloss = plane.gloss;
    made.mirror_from_world = mirror_matrix(made.unit_plane);
    // The lecture's array is filled by rows; GL reads columns.
    if (params.reflection.printed_by_rows) made.mirror_from_world = glm::transpose(made.mirror_from_world);
    for (const glm::dvec4& light : derived.lights_world)
        made.shadows.push_back(cast_shadow(made.unit_plane, light, params.shadow.sign));
    return made;
}

void derive_planes(Derived& derived, const Params& params) {
    derived.lights_world = {params.light.position};
    for (const LightParams& light : params.lights) derived.lights_world.push_back(light.position);
    derived.planes = {derive_one_plane(params.plane, derived, params)};
    for (const PlaneParams& plane : params.planes) derived.planes.push_back(derive_one_plane(plane, derived, params));

    DerivedPlane& first = derived.planes.front();
    CastShadow& cast = first.shadows.front();
    if (params.overrides.shadow_from_world) cast.shadow_from_world = *params.overrides.shadow_from_world;
    if (params.overrides.mirror_from_world) first.mirror_from_world = *params.overrides.mirror_from_world;
    derived.unit_plane = first.unit_plane;
    derived.patch = first.patch;
    derived.eye_side = glm::dot(derived.unit_plane, derived.eye_world);
    derived.light_in_plane = cast.light_in_plane;
    derived.shadow_from_world = cast.shadow_from_world;
    derived.shadow_sign = cast.sign;
    derived.mirror_from_world = first.mirror_from_world;

    Facts& facts = derived.facts;
    facts.plane_dot_light = cast.plane_dot_light;
    facts.det_shadow = glm::determinant(derived.shadow_from_world);
    facts.det_mirror = glm::determinant(derived.mirror_from_world);
    facts.rank_shadow = rank_of(derived.shadow_from_world);
    facts.shadow_residual = largest_entry(derived.shadow_from_world * derived.shadow_from_world -
                                          facts.plane_dot_light * derived.shadow_from_world);
    facts.mirror_residual = largest_entry(derived.mirror_from_world * derived.mirror_from_world - glm::dmat4(1.0));
}

std::optional<FollowedPoint> derive_followed(const Derived& derived, const Params& params, const Scene& scene) {
    if (!params.follow) return std::nullopt;
    const SceneObject* object = scene.find(params.follow->object);
    if (!object || !object->mesh) return std::nullopt;
    const auto vertex = static_cast<std::size_t>(params.follow->vertex);
    if (vertex >= object->mesh->positions.size()) return std::nullopt;

    FollowedPoint followed;
    const glm::dvec4 point(glm::dvec3(object->world_from_model * glm::dvec4(object->mesh->positions[vertex], 1.0)),
                           1.0);
    followed.point_world = glm::dvec3(point);
    followed.shadow_homogeneous = derived.shadow_from_world * point;
    if (std::abs(followed.shadow_homogeneous.w) > 1e-12)
        followed.shadow_world = glm::dvec3(followed.shadow_homogeneous) / followed.shadow_homogeneous.w;
    followed.plane_distance = glm::dot(derived.unit_plane, point);
    followed.foot_world = followed.point_world - followed.plane_distance * glm::dvec3(derived.unit_plane);
    const glm::dvec4 mirrored = derived.mirror_from_world * point;
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
            return {4 + static_cast<int>(format), false};  // d4 … d12 stand first in the enumeration
    }
}

Derived derive(const Params& params, const Scene& scene, const Viewport& viewport) {
    Derived derived;
    derive_camera(derived, params, viewport);
    derive_planes(derived, params);
    derived.followed = derive_followed(derived, params, scene);
    if (params.depth.decals == DecalMethod::stencil) derived.object_marks = decal_marks(scene);
    if (params.view.shows == Shows::fighting) derived.heat = heat_map(params, derived, scene);
    derived.problems = find_problems(params, derived, scene);
    return derived;
}

bool light_reaches(const Derived& derived, double eye_side) {
    return derived.planes.front().shadows.front().reaches(eye_side);
}

ObserverView derive_observer(const ObserverParams& observer, const Viewport& viewport) {
    ObserverView view;
    const Angles angles{observer.yaw, observer.pitch, 0.0};
    const glm::dvec3 back = glm::dvec3(rotation_from_angles(angles)[2]);
    view.eye_world = {observer.target + back * observer.distance, 1.0};
    view.world_from_view = world_from_view(glm::dvec3(view.eye_world), angles);
    view.view_from_world = view_from_world(view.world_from_view);
    // A narrow view keeps the width of what it shows: the camera stays in the picture.
    constexpr double usual_aspect = 1.8;
    const double widening = std::max(1.0, usual_aspect / viewport.aspect());
    const double fovy_deg = glm::degrees(2.0 * std::atan(std::tan(glm::radians(20.0)) * widening));
    const Lens lens{false, fovy_deg, 6.0, observer.distance * 0.01, observer.distance * 100.0};
    view.clip_from_world = clip_from_view(lens, viewport.aspect()) * view.view_from_world;
    return view;
}

ObserverView derive_light_view(const Params& params, const Derived& derived, const Viewport& viewport) {
    const glm::dvec4& light = params.light.position;
    const PlanePatch& patch = derived.patch;
    const double radius = patch.extent * std::numbers::sqrt2;
    const bool parallel = light.w < 1e-6;
    const glm::dvec3 away =
        parallel ? glm::normalize(glm::dvec3(light)) * (4.0 * radius) : glm::dvec3(light) / light.w - patch.center;
    const double distance = std::max(glm::length(away), 1e-6);
    const bool is_at_center = glm::length(away) < 1e-6;  // then it looks down the normal
    const glm::dvec3 back = is_at_center ? patch.normal : away / distance;

    // Looking from straight above or below there is no y axis to hold upright.
    const glm::dvec3 up = std::abs(back.y) > 0.999 ? glm::dvec3(0.0, 0.0, -1.0) : glm::dvec3(0.0, 1.0, 0.0);
    const glm::dvec3 right = glm::normalize(glm::cross(up, back));
    ObserverView view;
    view.world_from_view = {{right, 0.0}, {glm::cross(back, right), 0.0}, {back, 0.0}, {patch.center + away, 1.0}};
    view.view_from_world = view_from_world(view.world_from_view);
    view.eye_world = view.world_from_view[parallel ? 2 : 3];
    // As wide as the patch, with a little room; from within the patch's own depth as wide as can be looked at.
    constexpr double room = 1.1, widest_slope = 4.0;
    double half_height = 1e-3 * radius, slope = 1e-3;
    for (const glm::dvec3& corner : patch.corners()) {
        const glm::dvec3 seen(view.view_from_world * glm::dvec4(corner, 1.0));
        const double half = room * std::max(std::abs(seen.y), std::abs(seen.x) / viewport.aspect());
        half_height = std::max(half_height, half);
        slope = std::max(slope, -seen.z > half / widest_slope ? half / -seen.z : widest_slope);
    }
    const double fovy_deg = glm::degrees(2.0 * std::atan(slope));
    const Lens lens{parallel, fovy_deg, 2.0 * half_height, distance * 0.02, distance + 40.0 * radius};
    view.clip_from_world = clip_from_view(lens, viewport.aspect()) * view.view_from_world;
    return view;
}

ObserverView derive_moving_world(const ObserverParams& observer, const Derived& derived, const Viewport& viewport) {
    ObserverParams beside_camera = observer;
    beside_camera.target = {0.0, 0.0, -0.4 * observer.distance};
    const ObserverView fixed = derive_observer(beside_camera, viewport);
    ObserverView view;
    view.view_from_world = fixed.view_from_world * derived.view_from_world;
    view.world_from_view = glm::inverse(view.view_from_world);
    view.clip_from_world = fixed.clip_from_world * derived.view_from_world;
    view.eye_world = view.world_from_view[3];
    return view;
}

std::array<glm::dvec3, 8> frustum_corners(const Params& params, const Derived& derived) {
    const Lens lens = params.projection.lens();
    std::array<glm::dvec3, 8> corners{};
    const double slope = std::tan(glm::radians(lens.fovy_deg) * 0.5);
    for (int corner = 0; corner < 8; ++corner) {
        const double distance = corner < 4 ? lens.near : lens.far;
        const double half_height = lens.orthographic ? lens.height * 0.5 : slope * distance;
        const double x = (corner % 4 == 1 || corner % 4 == 2) ? 1.0 : -1.0;
        const double y = corner % 4 >= 2 ? 1.0 : -1.0;
        const glm::dvec4 corner_view(x * half_height * derived.aspect, y * half_height, -distance, 1.0);
        corners[static_cast<std::size_t>(corner)] = glm::dvec3(derived.world_from_view * corner_view);
    }
    return corners;
}

}  // namespace viewing
