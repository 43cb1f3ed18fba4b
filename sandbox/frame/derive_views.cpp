// Derives all views except the camera's: the observer's, the light's, and the one in which V moves the world.
#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "frame/box_tree.h"
#include "frame/derive.h"
#include "geometry/camera.h"
#include "geometry/projection.h"

namespace viewing {
namespace {

/// Returns a clip-space matrix that centers `points` in the picture and enlarges them uniformly, at most four times,
/// until they nearly fill the picture; the identity if a point is behind the eye.
glm::dmat4 centered_on(std::span<const glm::dvec3> points, const glm::dmat4& clip_from_world) {
    glm::dvec2 low(1e9), high(-1e9);
    for (const glm::dvec3& point : points) {
        const glm::dvec4 clip = clip_from_world * glm::dvec4(point, 1.0);
        if (clip.w <= 1e-6) return glm::dmat4(1.0);
        low = glm::min(low, glm::dvec2(clip) / clip.w);
        high = glm::max(high, glm::dvec2(clip) / clip.w);
    }
    constexpr double filled = 0.9, most = 4.0;
    const glm::dvec2 half = 0.5 * (high - low), center = 0.5 * (high + low);
    const double scale = std::clamp(filled / std::max({half.x, half.y, 1e-6}), 1.0, most);
    glm::dmat4 zoomed(1.0);
    zoomed[0][0] = zoomed[1][1] = scale;
    zoomed[3][0] = -scale * center.x;
    zoomed[3][1] = -scale * center.y;
    return zoomed;
}

/// Returns the corners of each object's bounds; if there are no objects, the patch's corners.
std::vector<glm::dvec3> casting(const Scene& scene, const PlanePatch& patch) {
    std::vector<glm::dvec3> points;
    for (const SceneObject& object : scene.objects) {
        const Bounds bounds = vertex_tree(object.mesh)->bounds();
        for (int corner = 0; corner < 8 && !bounds.empty(); ++corner)
            points.emplace_back(object.world_from_model * glm::dvec4(corner & 1 ? bounds.max.x : bounds.min.x,
                                                                     corner & 2 ? bounds.max.y : bounds.min.y,
                                                                     corner & 4 ? bounds.max.z : bounds.min.z, 1.0));
    }
    if (points.empty())
        for (const glm::dvec3& corner : patch.corners()) points.push_back(corner);
    return points;
}

}  // namespace

ObserverView derive_observer(const ObserverParams& observer, const Viewport& viewport) {
    ObserverView view;
    const Angles angles{observer.yaw, observer.pitch, 0.0};
    const glm::dvec3 back = glm::dvec3(rotation_from_angles(angles)[2]);
    view.eye_world = {observer.target + back * observer.distance, 1.0};
    view.world_from_view = world_from_view(glm::dvec3(view.eye_world), angles);
    view.view_from_world = view_from_world(view.world_from_view);
    // A narrow view still shows the usual horizontal extent, so that the camera stays in the picture.
    constexpr double usual_aspect = 1.8;
    const double fovy_deg = widened_fovy(40.0, viewport.aspect(), usual_aspect);
    const Lens lens{false, fovy_deg, 6.0, observer.distance * 0.01, observer.distance * 100.0};
    view.clip_from_world = clip_from_view(lens, viewport.aspect()) * view.view_from_world;
    return view;
}

ObserverView derive_light_view(const Derived& derived, const Scene& scene, const Viewport& viewport) {
    const glm::dvec4& light = derived.chosen_light();
    const PlanePatch& patch = derived.chosen_plane().patch;
    const std::vector<glm::dvec3> seen = casting(scene, patch);
    Bounds around;
    for (const glm::dvec3& point : seen) around.add(point);
    const glm::dvec3 target = around.center();
    const double radius = std::max(0.5 * glm::length(around.size()), 1e-3);
    const bool parallel = is_parallel_light(light);
    const glm::dvec3 away =
        parallel ? glm::normalize(glm::dvec3(light)) * (4.0 * radius) : glm::dvec3(light) / light.w - target;
    const double distance = std::max(glm::length(away), 1e-6);
    const bool is_at_target = glm::length(away) < 1e-6;  // then the light looks down the normal
    const glm::dvec3 back = is_at_target ? patch.normal : away / distance;

    // A view straight down or up cannot keep the y axis upright.
    const glm::dvec3 up = std::abs(back.y) > 0.999 ? glm::dvec3(0.0, 0.0, -1.0) : glm::dvec3(0.0, 1.0, 0.0);
    const glm::dvec3 right = glm::normalize(glm::cross(up, back));
    ObserverView view;
    view.world_from_view = {{right, 0.0}, {glm::cross(back, right), 0.0}, {back, 0.0}, {target + away, 1.0}};
    view.view_from_world = view_from_world(view.world_from_view);
    view.eye_world = view.world_from_view[parallel ? 2 : 3];
    // The view is as wide as the casters plus a small margin. If the light is among the casters, the view is as wide as
    // widest_slope allows.
    constexpr double room = 1.1, widest_slope = 4.0;
    double half_height = 1e-3 * radius, slope = 1e-9;
    for (const glm::dvec3& point : seen) {
        const glm::dvec3 in_view(view.view_from_world * glm::dvec4(point, 1.0));
        const double half = room * std::max(std::abs(in_view.y), std::abs(in_view.x) / viewport.aspect());
        half_height = std::max(half_height, half);
        slope = std::max(slope, -in_view.z > half / widest_slope ? half / -in_view.z : widest_slope);
    }
    const double fovy_deg = glm::degrees(2.0 * std::atan(slope));
    const double reach = 40.0 * (radius + patch.reach() + glm::distance(target, patch.center));
    const Lens lens{parallel, fovy_deg, 2.0 * half_height,
                    std::max(0.02 * std::min(distance, radius), distance - reach), distance + reach};
    view.clip_from_world = clip_from_view(lens, viewport.aspect()) * view.view_from_world;
    view.clip_from_world = centered_on(seen, view.clip_from_world) * view.clip_from_world;
    return view;
}

ObserverView derive_moving_world(const ObserverParams& observer, const Derived& derived, const Viewport& viewport) {
    ObserverParams beside_camera = observer;
    beside_camera.target = {0.0, 0.0, -0.4 * observer.distance};
    const ObserverView fixed = derive_observer(beside_camera, viewport);
    ObserverView view;
    view.view_from_world = fixed.view_from_world * derived.view_from_world;
    view.world_from_view = effective_camera(derived) * fixed.world_from_view;
    view.clip_from_world = fixed.clip_from_world * derived.view_from_world;
    view.eye_world = view.world_from_view[3];
    return view;
}

glm::dmat4 placed_camera(const Params& params) {
    return world_from_view(params.camera.position, params.camera.angles());
}

glm::dmat4 effective_camera(const Derived& derived) {
    const glm::dmat4& v = derived.view_from_world;
    if (is_rigid(v)) return view_from_world(v);  // inverted without rounding, like C
    return std::abs(glm::determinant(v)) > 1e-12 ? glm::inverse(v) : derived.world_from_view;
}

std::array<glm::dvec3, 8> frustum_corners(const Params& params, const Derived& derived) {
    return frustum_corners(params, derived, placed_camera(params));
}

std::array<glm::dvec3, 8> frustum_corners(const Params& params, const Derived& derived,
                                          const glm::dmat4& world_from_view) {
    const Lens lens = params.lens();
    const bool has_lens = !params.camera_overrides.clip_from_view || params.lens_by_hand();
    const glm::dmat4 view_from_clip = has_lens || std::abs(glm::determinant(derived.clip_from_view)) < 1e-12
                                          ? glm::dmat4(0.0)
                                          : glm::inverse(derived.clip_from_view);
    const double ndc_near = derived.clip_zero_to_one ? 0.0 : -1.0;
    std::array<glm::dvec3, 8> corners{};
    for (int corner = 0; corner < 8; ++corner) {
        const double distance = corner < 4 ? lens.near : lens.shown_far();
        const double x = (corner % 4 == 1 || corner % 4 == 2) ? 1.0 : -1.0;
        const double y = corner % 4 >= 2 ? 1.0 : -1.0;
        glm::dvec4 corner_view(lens.edges_at(distance, derived.aspect).at({x, y}), -distance, 1.0);
        if (!has_lens) {
            const glm::dvec4 unprojected = view_from_clip * glm::dvec4(x, y, corner < 4 ? ndc_near : 1.0, 1.0);
            if (std::abs(unprojected.w) > 1e-9) corner_view = unprojected / unprojected.w;
        }
        corners[corner] = glm::dvec3(world_from_view * corner_view);
    }
    return corners;
}

}  // namespace viewing
