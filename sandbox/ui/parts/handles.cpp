#include "ui/parts/handles.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "state/fields.h"
#include "text/catalogue.h"

namespace viewing {
namespace {

constexpr double parallel_light_distance = 5.0;  ///< from the patch's center to a parallel or distant light's lamp

/// Whether the light is too far away to be visible; only its direction is then shown.
bool is_far_away(const glm::dvec4& light) {
    const double length = glm::length(glm::dvec3(light));
    return length > 0.0 && length >= 1e3 * light.w;
}

/// Returns the point's distance from `place` on screen; very large if the point is behind the eye.
float distance_px(const Overlay& overlay, const glm::dvec3& point, ImVec2 place) {
    const std::optional<ImVec2> there = overlay.project(point);
    return there ? std::hypot(there->x - place.x, there->y - place.y) : 1e9F;
}

/// The distance within which the pointer can grab a handle.
float reach_px() {
    return 14.0F * widgets::CurrentContext().scale;
}

/// "ℓ", "ℓ₂", …
const char* light_name(std::size_t light) {
    static constexpr const char* names[most_lights] = {"ℓ", "ℓ₂", "ℓ₃", "ℓ₄"};
    return names[light];
}

/// Returns the label of the light that has the handle, for example "ℓ₂ (parallel)".
std::string light_label(const Derived& derived) {
    const glm::dvec4& light = derived.chosen_light();
    const char* const name = light_name(derived.chosen.light);
    if (light.w == 0.0) return say("{light} (parallel)", "light"_a = name);
    return is_far_away(light) ? say("{light} (far away)", "light"_a = name) : name;
}

/// Draws a light with its name; a light that is far away also gets an arrow for its direction.
void draw_lamp(Overlay& overlay, const glm::dvec4& light, const Derived& derived, const char* name, float radius) {
    const ImU32 color = widgets::CurrentContext().palette.light;
    const glm::dvec3 place = lamp_place(light, derived);
    if (overlay.arrow_at_edge(place, name, color)) return;
    if (is_far_away(light)) overlay.arrow(place, place + 0.25 * (derived.chosen_plane().patch.center - place), color);
    overlay.dot(place, color, radius);
    overlay.label(place, name, color);
}

/// Returns the index of an edge handle among the handles of the near plane's edges.
std::size_t edge_of(Handle handle) {
    return static_cast<std::size_t>(handle) - static_cast<std::size_t>(Handle::bottom);
}

Handle handle_of_edge(std::size_t edge) {
    return static_cast<Handle>(static_cast<std::size_t>(Handle::bottom) + edge);
}

/// Returns the position of the handle being grabbed. The near and far planes have several grips; returns the one
/// nearest to `place`.
glm::dvec3 place_of(const HandlePlaces& places, Handle handle, const Overlay& overlay, ImVec2 place) {
    const auto nearest = [&](const std::array<glm::dvec3, 5>& points) {
        return *std::min_element(points.begin(), points.end(), [&](const glm::dvec3& a, const glm::dvec3& b) {
            return distance_px(overlay, a, place) < distance_px(overlay, b, place);
        });
    };
    switch (handle) {
        case Handle::light:
            return places.light;
        case Handle::plane_tilt:
            return places.normal_tip;
        case Handle::camera:
            return places.camera->eye;
        case Handle::direction:
            return places.camera->direction_tip;
        case Handle::near_plane:
            return places.camera->has_window ? places.camera->near[4] : nearest(places.camera->near);
        case Handle::far_plane:
            return nearest(places.camera->far);
        case Handle::point:
            return *places.point;
        case Handle::bottom:
        case Handle::right:
        case Handle::top:
        case Handle::left:
            return places.camera->near[edge_of(handle)];
        case Handle::none:
        case Handle::plane_offset:
            break;
    }
    return places.plane;
}

/// Intersects a ray with the plane through `point` that is perpendicular to `facing`. Returns `point` if they do not
/// intersect.
glm::dvec3 in_picture_plane(const Ray& ray, const glm::dvec3& point, const glm::dvec3& facing) {
    const std::optional<double> t = intersect_plane(ray, glm::dvec4(facing, -glm::dot(facing, point)));
    return t ? ray.at(*t) : point;
}

}  // namespace

glm::dvec3 lamp_place(const glm::dvec4& light_world, const Derived& derived) {
    return is_far_away(light_world)
               ? derived.chosen_plane().patch.center + glm::normalize(glm::dvec3(light_world)) * parallel_light_distance
               : glm::dvec3(light_world) / light_world.w;
}

const char* field_of(Handle handle) {
    switch (handle) {
        case Handle::light:
            return "light.position";
        case Handle::plane_offset:
        case Handle::plane_tilt:
            return "plane.equation";
        case Handle::near_plane:
            return "projection.near";
        case Handle::far_plane:
            return "projection.far";
        case Handle::point:
            return "follow";
        case Handle::bottom:
            return "projection.bottom";
        case Handle::right:
            return "projection.right";
        case Handle::top:
            return "projection.top";
        case Handle::left:
            return "projection.left";
        case Handle::none:
        case Handle::camera:
        case Handle::direction:
            break;
    }
    return "";
}

HandlePlaces handle_places(const Derived& derived) {
    HandlePlaces places{};
    const DerivedPlane& plane = derived.chosen_plane();
    places.plane = plane.patch.center;
    places.normal_tip = plane.patch.center + glm::dvec3(plane.unit_plane) * 1.4;
    places.light = lamp_place(derived.chosen_light(), derived);
    if (derived.followed) places.point = derived.followed->point_world;
    return places;
}

HandlePlaces observer_handle_places(const Params& params, const Derived& derived) {
    HandlePlaces places = handle_places(derived);
    const std::array<glm::dvec3, 8> corners = frustum_corners(params, derived);
    const glm::dmat4 world_from_view = placed_camera(params);
    const glm::dvec3 eye(world_from_view[3]);
    const auto middles = [&corners](std::size_t first) {
        std::array<glm::dvec3, 5> found{};
        for (std::size_t edge = 0; edge < 4; ++edge)
            found[edge] = 0.5 * (corners[first + edge] + corners[first + (edge + 1) % 4]);
        found[4] = 0.5 * (found[0] + found[2]);
        return found;
    };
    constexpr double share = 0.14;  // of the observer's distance, so that the arrow looks equally long in any picture
    const glm::dvec3 forward = -glm::dvec3(world_from_view[2]);
    const bool is_by_hand = params.camera_overrides.clip_from_view.has_value();
    places.camera = {eye,
                     eye + forward * (share * params.observer.distance),
                     middles(0),
                     middles(4),
                     !is_by_hand,
                     !is_by_hand && !std::isinf(params.projection.far),
                     !is_by_hand && params.projection.has_window()};
    return places;
}

bool is_at(const Overlay& overlay, const glm::dvec3& point, ImVec2 place) {
    return distance_px(overlay, point, place) < reach_px();
}

Handle handle_at(const Overlay& overlay, const HandlePlaces& places, ImVec2 place) {
    float nearest = reach_px();
    Handle found = Handle::none;
    const auto look = [&](const glm::dvec3& point, Handle handle) {
        const float distance = distance_px(overlay, point, place);
        if (distance >= nearest) return;
        nearest = distance;
        found = handle;
    };
    look(places.light, Handle::light);
    look(places.normal_tip, Handle::plane_tilt);
    look(places.plane, Handle::plane_offset);
    if (places.point) look(*places.point, Handle::point);
    if (!places.camera) return found;
    look(places.camera->eye, Handle::camera);
    look(places.camera->direction_tip, Handle::direction);
    for (std::size_t point = 0; places.camera->drags_near && point < places.camera->near.size(); ++point)
        look(places.camera->near[point],
             places.camera->has_window && point < 4 ? handle_of_edge(point) : Handle::near_plane);
    if (places.camera->drags_far)
        for (const glm::dvec3& point : places.camera->far) look(point, Handle::far_plane);
    return found;
}

Grip take(const Overlay& overlay, const HandlePlaces& places, Handle handle, const Params& params, ImVec2 place) {
    Grip grip;
    grip.handle = handle;
    grip.grabbed_world = place_of(places, handle, overlay, place);
    grip.center_world = places.plane;
    grip.equation = params.planes[params.chosen().plane].equation;
    const Ray ray = overlay.ray_at(place);
    grip.offset_world = grip.grabbed_world - in_picture_plane(ray, grip.grabbed_world, ray.direction);
    return grip;
}

namespace {

/// Returns how far the pointer has dragged a handle along a line through `origin`, in multiples of `along`. Measures
/// from where the pointer grabbed the handle, so that the handle does not jump. nullopt if the line points at the eye.
std::optional<double> pulled(const Overlay& overlay, const Grip& grip, ImVec2 place, const glm::dvec3& origin,
                             const glm::dvec3& along) {
    const Ray now = overlay.ray_at(place);
    const glm::dvec3 pressed = grip.grabbed_world - grip.offset_world;
    const auto to = closest_point_parameter_on_line(now, origin, along);
    const auto from = closest_point_parameter_on_line({now.origin, pressed - now.origin}, origin, along);
    if (!to || !from) return std::nullopt;
    return *to - *from;
}

/// Returns the eye distance to which the pointer drags a point of the near or far plane. The point moves along its ray
/// from the eye or, if the projection is orthographic, along the view direction.
std::optional<double> pulled_distance(const Params& params, const Overlay& overlay, const Grip& grip, ImVec2 place) {
    const glm::dvec3 eye = params.camera.position;
    const glm::dvec3 forward = -glm::dvec3(rotation_from_angles(params.camera.angles())[2]);
    const double distance = glm::dot(forward, grip.grabbed_world - eye);
    const bool is_pyramid = !params.projection.is_orthographic();
    if (is_pyramid && !(distance > 0.0)) return std::nullopt;
    const glm::dvec3 along = is_pyramid ? (grip.grabbed_world - eye) / distance : forward;
    const std::optional<double> by = pulled(overlay, grip, place, grip.grabbed_world, along);
    return by ? std::optional(distance + *by) : std::nullopt;
}

/// Moves an edge of the near window across the window; the edge does not pass the opposite one.
void drag_edge(Params& params, const Overlay& overlay, const Grip& grip, ImVec2 place) {
    ProjectionParams& projection = params.projection;
    const bool is_across = grip.handle == Handle::left || grip.handle == Handle::right;
    const glm::dvec3 along(rotation_from_angles(params.camera.angles())[is_across ? 0 : 1]);
    const std::optional<double> by = pulled(overlay, grip, place, grip.grabbed_world, along);
    if (!by) return;
    const double to = glm::dot(along, grip.grabbed_world - params.camera.position) + *by;
    double &low = is_across ? projection.left : projection.bottom,
           &high = is_across ? projection.right : projection.top;
    const double least = std::max(1e-3 * std::abs(projection.near), least_window(low, high));
    if (grip.handle == Handle::left || grip.handle == Handle::bottom)
        low = std::min(to, high - least);
    else
        high = std::max(to, low + least);
}

}  // namespace

void drag(Params& params, const Overlay& overlay, const Grip& grip, ImVec2 place, bool along_y) {
    const Ray ray = overlay.ray_at(place);
    const glm::dvec3 point = in_picture_plane(ray, grip.grabbed_world, ray.direction) + grip.offset_world;
    const double length = glm::length(glm::dvec3(grip.equation));
    const glm::dvec3 normal = glm::dvec3(grip.equation) / length;
    const Choice chosen = params.chosen();
    glm::dvec4& equation = params.planes[chosen.plane].equation;
    const glm::dvec3 target = along_y ? glm::dvec3(grip.grabbed_world.x, point.y, grip.grabbed_world.z) : point;
    switch (grip.handle) {
        case Handle::none:
            return;
        case Handle::camera:
            params.camera.position = target;
            break;
        case Handle::point:
            params.follow = Follow{.object = "", .point = target};
            break;
        case Handle::direction: {
            if (glm::distance(point, params.camera.position) < 1e-3) return;
            const Angles angles = angles_looking_at(params.camera.position, point);
            params.camera.yaw = angles.yaw_deg;
            params.camera.pitch = angles.pitch_deg;
            break;
        }
        case Handle::near_plane:
        case Handle::far_plane: {
            ProjectionParams& projection = params.projection;
            const std::optional<double> distance = pulled_distance(params, overlay, grip, place);
            if (!distance) return;
            constexpr double usual_least = 1e-3;
            const double least = least_near(params) > 0.0 ? usual_least : least_near(params);
            if (grip.handle == Handle::near_plane)
                projection.near = std::clamp(*distance, least, params.lens().shown_far() * 0.999);
            else
                projection.far = std::max(*distance, projection.near * 1.001);
            break;
        }
        case Handle::bottom:
        case Handle::right:
        case Handle::top:
        case Handle::left:
            drag_edge(params, overlay, grip, place);
            break;
        case Handle::light: {
            glm::dvec4& light = params.lights[chosen.light].position;
            params.animation.light_orbit = false;  // so that the light stays where the user puts it
            if (!is_far_away(light)) {
                light = glm::dvec4(target * light.w, light.w);
            } else if (glm::length(target - grip.center_world) > 1e-3) {
                const double size = glm::length(glm::dvec3(light));
                light = glm::dvec4(glm::normalize(target - grip.center_world) * size, light.w);
            }
            break;
        }
        case Handle::plane_offset: {
            const std::optional<double> by = pulled(overlay, grip, place, grip.center_world, normal);
            if (!by) return;
            const glm::dvec3 center = grip.center_world + normal * *by;
            equation.w = -glm::dot(glm::dvec3(grip.equation), center);
            break;
        }
        case Handle::plane_tilt: {
            if (glm::length(point - grip.center_world) < 1e-3) return;
            const glm::dvec3 tilted = glm::normalize(point - grip.center_world) * length;
            equation = glm::dvec4(tilted, -glm::dot(tilted, grip.center_world));
            break;
        }
    }
    clamp_to_ranges(params);
}

namespace {

/// Returns the label of an edge's field: "left".
const char* label_of_edge(Handle edge) {
    return field(field_of(edge)).label.data();  // a literal
}

/// Draws handles on the camera, which is already drawn, and highlights the hovered one.
void draw_camera_handles(Overlay& overlay, const HandlePlaces::Camera& camera, Handle hovered) {
    const ImU32 color = widgets::CurrentContext().palette.camera;
    overlay.arrow(camera.eye, camera.direction_tip, color);
    if (hovered == Handle::camera) overlay.ring(camera.eye, color, 9.0F);
    if (hovered == Handle::direction) overlay.ring(camera.direction_tip, color, 9.0F);
    for (std::size_t point = 0; camera.drags_near && point < camera.near.size(); ++point) {
        const bool is_edge = camera.has_window && point < 4;
        const bool is_hovered = hovered == (is_edge ? handle_of_edge(point) : Handle::near_plane);
        overlay.square(camera.near[point], color, is_hovered ? 4.0F : is_edge ? 2.5F : 1.5F);
        if (is_edge && is_hovered) overlay.label(camera.near[point], tr(label_of_edge(hovered)), color);
    }
    if (!camera.drags_far) return;
    for (const glm::dvec3& point : camera.far) overlay.square(point, color, hovered == Handle::far_plane ? 4.0F : 2.0F);
}

}  // namespace

namespace {

float radius_of(Handle handle, float usual, Handle hovered) {
    return hovered == handle ? usual + 2.0F : usual;
}

}  // namespace

void draw_plane_handles(Overlay& overlay, const HandlePlaces& places, Handle hovered) {
    const widgets::Palette& palette = widgets::CurrentContext().palette;
    if (places.camera) draw_camera_handles(overlay, *places.camera, hovered);
    overlay.arrow(places.plane, places.normal_tip, palette.plane);
    overlay.square(places.plane, palette.plane, radius_of(Handle::plane_offset, 4.0F, hovered));
    overlay.label(places.normal_tip, "n", palette.plane);
    if (hovered == Handle::plane_tilt) overlay.ring(places.normal_tip, palette.plane, 9.0F);
    if (hovered == Handle::point && places.point) overlay.ring(*places.point, palette.point, 9.0F);
}

void draw_light_handles(Overlay& overlay, const HandlePlaces& places, const Derived& derived, Handle hovered) {
    const widgets::Palette& palette = widgets::CurrentContext().palette;
    draw_lamp(overlay, derived.chosen_light(), derived, light_label(derived).c_str(),
              radius_of(Handle::light, 6.0F, hovered));
    overlay.ring(places.light, palette.light, radius_of(Handle::light, 10.0F, hovered));
    for (std::size_t light = 0; light < derived.lights_world.size(); ++light)
        if (light != derived.chosen.light)
            draw_lamp(overlay, derived.lights_world[light], derived, light_name(light), 5.0F);
}

}  // namespace viewing
