// The observer's view, which shows the camera from outside, and the lecture's second interpretation of camera movement:
// the camera stays fixed, and the world moves.
#include <algorithm>
#include <cmath>

#include "state/fields.h"
#include "text/catalogue.h"
#include "topics/hidden/shown/hidden_overlay.h"
#include "topics/planes/shown/derivation_views.h"
#include "ui/parts/look.h"
#include "ui/parts/view_parts.h"
#include "ui/views/lower_view.h"
#include "ui/views/observer_parts.h"
#include "ui/views/outside.h"

namespace viewing {

void world_axes(Overlay& overlay) {
    static constexpr const char* names[] = {"x", "y", "z"};
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 tip(0.0);
        tip[axis] = 1.0;
        overlay.arrow(glm::dvec3(0.0), tip, palette().quiet, 1.5F);
        overlay.label(tip, names[axis], palette().quiet);
    }
}

void observer_mouse(ViewState& state, Session& session) {
    const ImGuiIO& io = ImGui::GetIO();
    ObserverParams& observer = session.params.observer;
    if (ImGui::IsItemActive() && state.grip.handle == Handle::none) {
        if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
            const glm::dvec2 turn_deg = turn_of_drag(state.mouse, 0.4);  // faster: the view is small
            observer.yaw += turn_deg.x;
            observer.pitch = std::clamp(observer.pitch + turn_deg.y, -89.0, 89.0);
        } else {
            const glm::dmat4 turned = rotation_from_angles({observer.yaw, observer.pitch, 0.0});
            const double step = observer.distance * 0.002 / widgets::CurrentContext().scale;
            observer.target +=
                glm::dvec3(turned[0]) * (-io.MouseDelta.x * step) + glm::dvec3(turned[1]) * (io.MouseDelta.y * step);
        }
    }
    if (ImGui::IsItemHovered() && io.MouseWheel != 0.0F) observer.distance *= std::pow(0.88, io.MouseWheel);
    clamp_to_ranges(session.params);
}

namespace {

void draw_observer_view(const FrameContext& frame) {
    const auto& [state, session, derived, plan, pictures, rect, picture] = frame;
    header_note("camera frustum, light, plane", rect.max.x);
    const widgets::Group group("observer");
    picture_item("observer view", rect, picture);
    const bool over = ImGui::IsItemHovered();

    const ObserverView observer = derive_observer(session.params.observer, {rect.size_px()});
    Overlay overlay(ImGui::GetWindowDrawList(), rect, observer.clip_from_world);
    const HandlePlaces places = observer_handle_places(session.params, derived);
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    Handle hovered = state.grip.handle;
    if (hovered == Handle::none && over) hovered = movable_handle(state, handle_at(overlay, places, mouse));
    if (hovered != Handle::none) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    if (over && ImGui::IsMouseClicked(ImGuiMouseButton_Left) && hovered != Handle::none)
        state.grip = take(overlay, places, hovered, session.params, mouse);
    if (ImGui::IsItemActive() && state.grip.handle != Handle::none)
        drag(session.params, overlay, state.grip, mouse, ImGui::GetIO().KeyShift);
    observer_mouse(state, session);
    if (ImGui::IsMouseReleased(ImGuiMouseButton_Left)) state.grip = {};

    draw_patches(overlay, derived);
    draw_frustum(overlay, session.params, derived, placed_camera(session.params));
    draw_effective_eye(overlay, session.params, derived);
    const ObserverParams& shows = session.params.observer;
    if (shows.light_rays) draw_light_rays(overlay, state.light_rays.of(session, derived), derived.chosen_light());
    if (shows.mirrored_eye) draw_mirrored_eye(overlay, session.params, derived);
    if (shows.image_space) label_image_space(overlay, derived);
    draw_hidden_observer(state.hidden.links.now, pictures.hidden, overlay);
    draw_why_overlay(state.why, overlay);
    if (state.target) overlay.target(state.target->point_world, state.target->label.c_str(), palette().accent);
    draw_plane_handles(overlay, places, hovered);
    draw_light_handles(overlay, places, derived, hovered);
    if (!state.target || session.params.follow) draw_derivation_overlay(overlay, session.params, derived);
}

void draw_moving_world_view(const FrameContext& frame) {
    const auto& [state, session, derived, plan, pictures, rect, picture] = frame;
    picture_item("lower view", rect, picture);
    observer_mouse(state, session);
    const ObserverView view = derive_moving_world(session.params.observer, derived, {rect.size_px()});
    Overlay overlay(ImGui::GetWindowDrawList(), rect, view.clip_from_world);
    world_axes(overlay);
    draw_patches(overlay, derived);
    draw_frustum(overlay, session.params, derived, effective_camera(derived));
    const glm::dvec3 light = lamp_place(derived.chosen_light(), derived);
    overlay.dot(light, palette().light, 6.0F);
    overlay.label(light, "ℓ", palette().light);
    if (derived.followed) {
        overlay.dot(derived.followed->point_world, palette().point, 5.0F);
        overlay.label(derived.followed->point_world, "p", palette().point);
    }
    const char* whole = tr("the camera stays, the world moves by V = C⁻¹: the same picture");
    const char* brief = tr("the world moves by V = C⁻¹");
    if (session.params.camera_overrides.view_from_world) {
        whole = tr("the camera stays, the world moves by the V entered by hand");
        brief = tr("the world moves by V");
    } else if (session.params.slips.camera_as_view) {
        whole = tr("C is sent instead of V = C⁻¹: the camera stays, and the world moves by C");
        brief = tr("the world moves by C, not by V");
    }
    overlay.keep_labels_off(sentence_over_picture(overlay.draw(), rect, palette().camera, whole, brief));
}

}  // namespace

const LowerView lower_views::observer{
    .title = marked("Observer"),
    .draw = draw_observer_view,
    .camera = [](const Params& params, const Derived&, const Scene&,
                 const Rect& rect) { return derive_observer(params.observer, {rect.size_px()}); },
    .turns = true,
};

const LowerView lower_views::moving_world{
    .title = marked("Moving the world"),
    .draw = draw_moving_world_view,
    .camera = [](const Params& params, const Derived& derived, const Scene&,
                 const Rect& rect) { return derive_moving_world(params.observer, derived, {rect.size_px()}); },
    .turns = true,
};

}  // namespace viewing
