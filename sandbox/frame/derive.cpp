// Params in, every number out. Matrices multiply from right to left: clip ← view ← world.
// Read plan.cpp next: what is done with these numbers.
#include "frame/derive.h"

#include <algorithm>
#include <cmath>

#include "frame/decals.h"
#include "frame/problems.h"
#include "geometry/camera.h"
#include "geometry/projection.h"

namespace viewing {
namespace {

double largest_entry(const glm::dmat4& matrix) {
    double largest = 0.0;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) largest = std::max(largest, std::abs(matrix[column][row]));
    return largest;
}

/// Rank by Gaussian elimination with full pivoting; entries below 1e-9 of the largest count as zero.
int rank_of(glm::dmat4 matrix) {
    const double threshold = largest_entry(matrix) * 1e-9;
    int rank = 0;
    for (int step = 0; step < 4; ++step) {
        int pivot_column = step, pivot_row = step;
        for (int column = step; column < 4; ++column)
            for (int row = step; row < 4; ++row)
                if (std::abs(matrix[column][row]) > std::abs(matrix[pivot_column][pivot_row])) {
                    pivot_column = column;
                    pivot_row = row;
                }
        if (std::abs(matrix[pivot_column][pivot_row]) <= threshold) break;
        std::swap(matrix[step], matrix[pivot_column]);
        for (int column = 0; column < 4; ++column) std::swap(matrix[column][step], matrix[column][pivot_row]);
        for (int column = step + 1; column < 4; ++column)
            matrix[column] -= matrix[step] * (matrix[column][step] / matrix[step][step]);
        ++rank;
    }
    return rank;
}

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

void derive_plane(Derived& derived, const Params& params) {
    const glm::dvec4& light = params.light.position;
    derived.unit_plane = unit_plane(params.plane.equation);
    derived.patch = plane_patch(params.plane.equation, params.plane.extent);
    derived.eye_side = glm::dot(derived.unit_plane, derived.eye_world);

    derived.shadow_from_world = params.overrides.shadow_from_world.value_or(shadow_matrix(derived.unit_plane, light));
    derived.mirror_from_world = params.overrides.mirror_from_world.value_or(mirror_matrix(derived.unit_plane));
    derived.shadow_sign = shadow_sign(derived.unit_plane, light);

    Facts& facts = derived.facts;
    facts.plane_dot_light = glm::dot(derived.unit_plane, light);
    facts.det_shadow = glm::determinant(derived.shadow_from_world);
    facts.det_mirror = glm::determinant(derived.mirror_from_world);
    facts.rank_shadow = rank_of(derived.shadow_from_world);
    facts.shadow_residual = largest_entry(derived.shadow_from_world * derived.shadow_from_world -
                                          facts.plane_dot_light * derived.shadow_from_world);
    facts.mirror_residual = largest_entry(derived.mirror_from_world * derived.mirror_from_world - glm::dmat4(1.0));
    // Touching counts as lying in the plane when P·L is this small against the light's own size.
    derived.light_in_plane = std::abs(facts.plane_dot_light) <= 1e-9 * std::max(1.0, glm::length(light));
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
    derive_plane(derived, params);
    derived.followed = derive_followed(derived, params, scene);
    if (params.depth.decals == DecalMethod::stencil) derived.object_marks = decal_marks(scene);
    if (params.view.shows == Shows::fighting) derived.heat = heat_map(params, derived, scene);
    derived.problems = find_problems(params, derived, scene);
    return derived;
}

bool light_reaches(const Derived& derived, double eye_side) {
    return !derived.light_in_plane && derived.facts.plane_dot_light * eye_side > 0.0;
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
