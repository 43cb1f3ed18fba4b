// The observer, who sees the camera from outside; and the lecture's second reading: the camera stays, the world moves.
#include <algorithm>
#include <cmath>

#include "state/fields.h"
#include "ui/look.h"
#include "ui/view_parts.h"
#include "ui/views.h"

namespace viewing {
namespace {

/// x, y and z from the world's origin, one unit long.
void world_axes(Overlay& overlay) {
    static constexpr const char* names[] = {"x", "y", "z"};
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 tip(0.0);
        tip[axis] = 1.0;
        overlay.arrow(glm::dvec3(0.0), tip, palette().quiet, 1.5F);
        overlay.label(tip, names[axis], palette().quiet);
    }
}

void frustum_lines(Overlay& overlay, const Params& params, const Derived& derived) {
    const std::array<glm::dvec3, 8> corners = frustum_corners(params, derived);
    for (std::size_t corner = 0; corner < 4; ++corner) {
        overlay.line(corners[corner], corners[(corner + 1) % 4], palette().camera);
        overlay.line(corners[corner + 4], corners[(corner + 1) % 4 + 4], palette().camera, 1.5F);
        overlay.line(corners[corner], corners[corner + 4], palette().camera, 1.5F);
    }
    const ImU32 faint = (palette().camera & ~IM_COL32_A_MASK) | (28U << IM_COL32_A_SHIFT);
    overlay.fill({corners[0], corners[1], corners[2], corners[3]}, faint);
    overlay.fill({corners[4], corners[5], corners[6], corners[7]}, faint);
    const glm::dvec3 eye(derived.world_from_view[3]);
    if (params.projection.type == ProjectionType::perspective)
        for (std::size_t corner = 0; corner < 4; ++corner) overlay.line(eye, corners[corner], palette().camera);
    overlay.dot(eye, palette().camera, 5.0F);
    overlay.label(eye, "camera", palette().camera);
    overlay.label((corners[0] + corners[1]) * 0.5, "near", palette().camera);
    overlay.label((corners[4] + corners[5]) * 0.5, "far", palette().camera);
}

void patch_outline(Overlay& overlay, const Derived& derived) {
    const std::array<glm::dvec3, 4> corners = derived.patch.corners();
    for (std::size_t corner = 0; corner < 4; ++corner)
        overlay.line(corners[corner], corners[(corner + 1) % 4], palette().plane, 1.5F);
}

void observer_mouse(ViewState& state, Session& session) {
    const ImGuiIO& io = ImGui::GetIO();
    ObserverParams& observer = session.params.observer;
    if (ImGui::IsItemActive() && state.grip.handle == Handle::none) {
        if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
            const double degrees_per_px = 0.4 / widgets::CurrentContext().scale;
            observer.yaw -= io.MouseDelta.x * degrees_per_px;
            observer.pitch = std::clamp(observer.pitch - io.MouseDelta.y * degrees_per_px, -89.0, 89.0);
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

}  // namespace

void draw_observer_view(ViewState& state, Session& session, const Derived& derived, const Rect& rect,
                        ImTextureID picture, const HiddenStatus& hidden) {
    const widgets::Group group("observer");
    picture_item("observer view", rect, picture);
    const bool over = ImGui::IsItemHovered();

    const ObserverView observer = derive_observer(session.params.observer, {rect.size_px()});
    Overlay overlay(ImGui::GetWindowDrawList(), rect, observer.clip_from_world);
    const HandlePlaces places = handle_places(session.params, derived);
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    Handle hovered = state.grip.handle;
    if (hovered == Handle::none && over) hovered = handle_at(overlay, places, mouse);
    if (over && ImGui::IsMouseClicked(ImGuiMouseButton_Left) && hovered != Handle::none)
        state.grip = take(overlay, places, hovered, session.params, mouse);
    if (ImGui::IsItemActive() && state.grip.handle != Handle::none)
        drag(session.params, overlay, state.grip, mouse, ImGui::GetIO().KeyShift);
    observer_mouse(state, session);
    if (ImGui::IsMouseReleased(ImGuiMouseButton_Left)) state.grip = {};

    patch_outline(overlay, derived);
    frustum_lines(overlay, session.params, derived);
    draw_laboratory_observer(state.laboratory, hidden, overlay);
    draw_handles(overlay, places, session.params, derived, hovered);
    draw_followed(overlay, session.params, derived);
}

void draw_moving_world_view(Session& session, ViewState& state, const Derived& derived, const Rect& rect,
                            ImTextureID picture) {
    picture_item("lower view", rect, picture);
    observer_mouse(state, session);
    const ObserverView view = derive_moving_world(session.params.observer, derived, {rect.size_px()});
    Overlay overlay(ImGui::GetWindowDrawList(), rect, view.clip_from_world);
    world_axes(overlay);
    patch_outline(overlay, derived);
    frustum_lines(overlay, session.params, derived);
    const glm::dvec3 light = handle_places(session.params, derived).light;
    overlay.dot(light, palette().light, 6.0F);
    overlay.label(light, "l", palette().light);
    widgets::HaloText(overlay.draw(), {rect.min.x + px(10.0F), rect.max.y - px(24.0F)}, palette().camera,
                      "the camera stays, the world moves by V = C⁻¹: the same picture");
}

}  // namespace viewing
