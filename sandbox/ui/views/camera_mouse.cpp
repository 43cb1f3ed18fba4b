// Mouse actions in the camera's view: handles, looking, panning, zooming, picking.
#include <algorithm>
#include <cmath>

#include "frame/object_reach.h"
#include "state/fields.h"
#include "text/catalogue.h"
#include "text/numbers.h"
#include "topics/hidden/shown/hidden_overlay.h"
#include "ui/parts/look.h"
#include "ui/views/lower_view.h"

namespace viewing {
namespace {

/// The frontmost object at a screen position. `hit.t` is the parameter along the overlay's ray at that position.
struct ObjectHit {
    const SceneObject* object = nullptr;
    MeshHit hit{};
};
std::optional<ObjectHit> object_at(const Overlay& overlay, const Scene& scene, ImVec2 place) {
    const Ray ray = overlay.ray_at(place);
    std::optional<ObjectHit> found;
    for (const SceneObject& object : scene.objects) {
        const glm::dmat4 model_from_world = glm::inverse(object.world_from_model);
        const Ray ray_model{glm::dvec3(model_from_world * glm::dvec4(ray.origin, 1.0)),
                            glm::dvec3(model_from_world * glm::dvec4(ray.direction, 0.0))};
        const std::optional<MeshHit> hit = intersect_mesh(ray_model, *object.mesh);
        if (hit && (!found || hit->t < found->hit.t)) found = ObjectHit{&object, *hit};
    }
    return found;
}

/// Finds the frontmost triangle at a screen position. Returns whichever of its vertices is nearest to this position on
/// screen.
std::optional<Follow> vertex_at(const Overlay& overlay, const Scene& scene, ImVec2 place) {
    const std::optional<ObjectHit> under = object_at(overlay, scene, place);
    if (!under) return std::nullopt;
    const SceneObject& object = *under->object;
    std::optional<Follow> found;
    float nearest_px = 1e30F;
    for (std::size_t corner = 0; corner < 3; ++corner) {
        const std::uint32_t vertex = object.mesh->indices[3 * under->hit.triangle + corner];
        const glm::dvec3 world(object.world_from_model * glm::dvec4(object.mesh->positions[vertex], 1.0));
        const std::optional<ImVec2> there = overlay.project(world);
        if (!there) continue;
        const float distance = std::hypot(there->x - place.x, there->y - place.y);
        if (distance >= nearest_px) continue;
        nearest_px = distance;
        found = Follow{object.description.name, static_cast<int>(vertex)};
    }
    return found;
}

/// Returns the eye distance at a screen position: that of the object there, otherwise that of the chosen plane,
/// otherwise that of the target. Returns at most ten times the target's distance.
double distance_at(const Overlay& overlay, const Scene& scene, const Derived& derived, ImVec2 place) {
    const Ray ray = overlay.ray_at(place);
    std::optional<double> t;
    if (const auto under = object_at(overlay, scene, place)) t = under->hit.t;
    if (!t) t = intersect_plane(ray, derived.chosen_plane().unit_plane);
    const double distance = t ? -(derived.view_from_world * glm::dvec4(ray.at(*t), 1.0)).z : 0.0;
    const double farthest = 10.0 * derived.facts.target_distance;
    return distance > 0.0 ? std::min(distance, farthest) : derived.facts.target_distance;
}

/// Returns the world-space point at a screen position and an eye distance.
glm::dvec3 point_at(const Overlay& overlay, const Derived& derived, ImVec2 place, double distance) {
    const Ray ray = overlay.ray_at(place);
    const double origin_z = (derived.view_from_world * glm::dvec4(ray.origin, 1.0)).z;
    const double direction_z = (derived.view_from_world * glm::dvec4(ray.direction, 0.0)).z;
    return ray.at((-distance - origin_z) / direction_z);
}

/// Returns how many world units one pixel spans at an eye distance.
double world_per_px(const Lens& lens, double distance, float height_px) {
    return picture_height(lens, distance) / static_cast<double>(height_px);
}

enum class DragAction { look, pan, orbit };

constexpr ImGuiMouseButton two_fingers = 3;  ///< held along with the right button while two fingers drag on the page

/// Returns what a drag with the right or the middle button does; none if neither is held. In orbit mode, where looking
/// around means orbiting, the right button pans.
std::optional<DragAction> action_of_drag(const MouseHabits& mouse, Navigation mode, bool holds_shift) {
    if (ImGui::IsMouseDown(ImGuiMouseButton_Middle))
        return mouse.middle_pans != holds_shift ? DragAction::pan : DragAction::orbit;
    const bool right_pans = mouse.right_pans || mode == Navigation::orbit || ImGui::IsMouseDown(two_fingers);
    if (ImGui::IsMouseDown(ImGuiMouseButton_Right)) return right_pans ? DragAction::pan : DragAction::look;
    return std::nullopt;
}

/// Adds the pointer's movement since the last frame to the motion.
void move_by_drag(DragAction action, const ViewState& state, const Lens& lens, float height_px, MotionInput& motion) {
    const glm::dvec2 way_px(ImGui::GetIO().MouseDelta.x, ImGui::GetIO().MouseDelta.y);
    const glm::dvec2 turn_deg = turn_of_drag(state.mouse, 0.22);
    motion.keeps_horizon = state.mouse.keeps_horizon;
    switch (action) {
        case DragAction::look:
            motion.look_deg += turn_deg;
            break;
        case DragAction::orbit:
            motion.orbit_deg += turn_deg;
            motion.orbit_center = state.orbit_center;
            break;
        case DragAction::pan:
            motion.pan += glm::dvec2(-way_px.x, way_px.y) * world_per_px(lens, state.pan_distance, height_px);
            break;
    }
}

/// Handles a turn of the wheel: moves the camera, zooms in orbit mode, or scales an orthographic picture. With Ctrl,
/// changes the camera's speed instead, except in orbit mode.
void turn_wheel(Session& session, const FrameInput& input, float lines, MotionInput& motion) {
    constexpr double seconds_a_line = 0.15;  // of flight per line that the wheel scrolls
    Params& params = session.params;
    const bool has_speed = params.camera.navigation != Navigation::orbit;
    if (has_speed && input.is_down(Key::ctrl)) {
        session.set_speed(session.speed() * std::pow(1.2, lines));
        session.message = {say("speed {speed} units/s", "speed"_a = number_text(session.speed(), 2)), false};
    } else if (params.projection.is_orthographic()) {
        params.projection.scale_picture(std::pow(0.88, lines));  // moving the camera would not change the picture
        clamp_to_ranges(params);
    } else if (has_speed) {
        motion.dolly += seconds_a_line * session.speed() * static_cast<double>(lines);
    } else {
        motion.zoom *= std::pow(0.88, lines);
    }
}

}  // namespace

glm::dvec2 turn_of_drag(const MouseHabits& mouse, double usual_deg) {
    const glm::dvec2 way_px(ImGui::GetIO().MouseDelta.x, ImGui::GetIO().MouseDelta.y);
    const double degrees_per_px = usual_deg * mouse.sensitivity / static_cast<double>(px(1.0F));
    return -degrees_per_px * way_px * glm::dvec2(1.0, mouse.inverts_y ? -1.0 : 1.0);
}

Handle movable_handle(const ViewState& state, Handle handle) {
    const std::string_view field = field_of(handle);
    if (!state.movable || field.empty() || ImGui::GetIO().KeyCtrl) return handle;
    const bool may_move = std::any_of(state.movable->begin(), state.movable->end(),
                                      [field](const std::string& group) { return is_in(field, group); });
    return may_move ? handle : Handle::none;
}

void camera_mouse(ViewState& state, Session& session, const Derived& derived, Overlay& overlay, Handle hovered,
                  const HiddenStatus& hidden, const FrameInput& input, MotionInput& motion) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool over = ImGui::IsItemHovered();
    const auto move_by = [&](DragAction action) {
        move_by_drag(action, state, session.params.lens(), overlay.rect().height(), motion);
    };
    if (over && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
        state.dragged_px = 0.0F;
        if (hovered != Handle::none)
            state.grip = take(overlay, handle_places(derived), hovered, session.params, io.MousePos);
        else
            state.looking = true;
    }
    if (ImGui::IsItemActive() && ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
        state.dragged_px += std::hypot(io.MouseDelta.x, io.MouseDelta.y);
        const bool is_drag = state.dragged_px > px(3.0F);
        if (is_drag && state.grip.handle != Handle::none)
            drag(session.params, overlay, state.grip, io.MousePos, input.is_down(Key::shift));
        else if (is_drag && state.looking)
            move_by(DragAction::look);
    }
    if (over && (ImGui::IsMouseClicked(ImGuiMouseButton_Right) || ImGui::IsMouseClicked(ImGuiMouseButton_Middle))) {
        state.pan_distance = distance_at(overlay, session.scene(), derived, io.MousePos);
        state.orbit_center = point_at(overlay, derived, io.MousePos, state.pan_distance);
    }
    if (over && ImGui::IsMouseClicked(ImGuiMouseButton_Right)) state.dragged_px = 0.0F;
    if (ImGui::IsItemActive() && ImGui::IsMouseDown(ImGuiMouseButton_Right))
        state.dragged_px += std::hypot(io.MouseDelta.x, io.MouseDelta.y);
    const bool is_right_click = over && ImGui::IsMouseReleased(ImGuiMouseButton_Right) && state.dragged_px <= px(3.0F);
    if (is_right_click && state.hovered_pixel && widgets::Offers("control:view.lower")) {
        state.looking = false;  // on a touchscreen, a long press also holds the left button
        pin(session.params, state.pinned, *state.hovered_pixel);
        if (!is_shown(session.params, Topic::why)) choose_topic(session.params, Slot::right, Topic::why);
        state.lower = {Slot::right, session.params.view.lower_left, session.params.view.lower_right};
    }
    const std::optional<DragAction> action =
        action_of_drag(state.mouse, session.params.camera.navigation, input.is_down(Key::shift));
    const bool is_click_so_far = action == DragAction::look && state.dragged_px <= px(3.0F);
    if (action && ImGui::IsItemActive() && !is_click_so_far) move_by(*action);
    if (ImGui::IsMouseReleased(ImGuiMouseButton_Left) && ImGui::IsItemDeactivated()) {
        const bool is_at_point = state.grip.handle == Handle::point;  // a click on the point may choose another vertex
        if ((state.looking || is_at_point) && state.dragged_px <= px(3.0F)) {
            PolygonLinks& links = state.hidden.links;
            links.next.selected_fragment = links.now.hovered_fragment;
            links.next.selected_node = links.tree.node_of(links.next.selected_fragment);
            const bool steps =
                is_taken_apart(session.params.visibility) && !is_drawn_by_gl_alone(session.params.visibility.method);
            if (steps && state.method_pixel)
                choose_pixel(session.params.visibility, *hidden.answer->camera, *state.method_pixel);
            else if (state.hovered_pixel && examines_pixel(session.params))
                pin(session.params, state.pinned, *state.hovered_pixel);
            else if (const auto vertex = vertex_at(overlay, session.scene(), io.MousePos); vertex || !is_at_point)
                session.params.follow = vertex;
        }
        state.grip = {};
        state.looking = false;
    }
    if (over && io.MouseWheel != 0.0F) turn_wheel(session, input, io.MouseWheel, motion);
}

}  // namespace viewing
