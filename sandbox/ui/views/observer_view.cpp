// The observer's view, which shows the camera from outside; and the lecture's second reading of camera movement: the
// camera stays fixed, and the world moves.
#include <algorithm>
#include <array>
#include <cmath>

#include "frame/camera_way.h"
#include "frame/depth/depth_precision.h"
#include "state/fields.h"
#include "text/catalogue.h"
#include "ui/hidden/hidden_overlay.h"
#include "ui/parts/controls.h"
#include "ui/parts/look.h"
#include "ui/parts/view_parts.h"
#include "ui/planes/derivation_views.h"
#include "ui/views/observer_parts.h"
#include "ui/views/views.h"

namespace viewing {
namespace {

/// Draws the x, y and z axes at the world's origin, one unit long.
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
    draw_hidden_observer(state.hidden.links.now, hidden, overlay);
    draw_why_overlay(state.why, overlay);
    if (state.target) overlay.target(state.target->point_world, state.target->label.c_str(), palette().accent);
    draw_plane_handles(overlay, places, hovered);
    draw_light_handles(overlay, places, derived, hovered);
    if (!state.target || session.params.follow) draw_derivation_overlay(overlay, session.params, derived);
}

void draw_moving_world_view(Session& session, ViewState& state, const Derived& derived, const Rect& rect,
                            ImTextureID picture) {
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
    const char* whole = tr("the camera stays, the world moves by V = C⁻¹: the same picture");
    const char* brief = tr("the world moves by V = C⁻¹");
    if (session.params.slips.camera_as_view) {
        whole = tr("C is sent instead of V = C⁻¹: the camera stays, and the world moves by C");
        brief = tr("the world moves by C, not by V");
    }
    overlay.keep_labels_off(sentence_over_picture(overlay.draw(), rect, palette().camera, whole, brief));
}

namespace {

/// Draws where equal steps of the stored code lie, across the frustum's lower and left faces.
void draw_code_steps(Overlay& overlay, const Params& params, const Derived& derived) {
    constexpr int most_steps = 16;
    const DepthCoding coding = depth_coding(params, derived);
    const Lens& lens = coding.lens;
    const glm::dmat4 world_from_view = effective_camera(derived);
    const ImU32 color = with_alpha(palette().camera, 150);
    for (const double z : depth_codes(lens, coding.mapping, coding.precision, most_steps).eye_distances) {
        if (!(z >= lens.near && z <= lens.shown_far())) continue;
        const Edges edges = lens.edges_at(z, derived.aspect);
        const auto corner = [&](double x, double y) {
            return glm::dvec3(world_from_view * glm::dvec4(edges.at({x, y}), -z, 1.0));
        };
        overlay.line(corner(-1, -1), corner(1, -1), color, 1.0F);
        overlay.line(corner(-1, -1), corner(-1, 1), color, 1.0F);
    }
}

/// Draws the followed point on its view ray, and the face of the frustum that cuts it off.
void draw_point_on_its_way(Overlay& overlay, const Params& params, const Derived& derived) {
    if (!derived.followed) return;
    const glm::dvec3& point = derived.followed->point_world;
    const glm::dmat4 world_from_view = effective_camera(derived);
    const double division = params.view.division;
    if (!params.projection.is_orthographic())
        overlay.line(glm::dvec3(world_from_view[3]), point, with_alpha(palette().point, 170), 1.0F);
    overlay.dot(point, palette().point, 5.0F);
    overlay.label(point, division <= 0.0 ? "V p" : division >= 1.0 ? "P V p ÷ w" : "p", palette().point);
    const FrustumPlane cut_by = camera_way(params, derived, point).cut_by;
    if (cut_by == FrustumPlane::none || widgets::IsPartCovered("matrix:V") || widgets::IsPartCovered("matrix:P"))
        return;
    static constexpr std::array<std::array<std::size_t, 4>, 6> faces = {
        {{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 3, 7, 4}, {1, 2, 6, 5}, {0, 1, 5, 4}, {3, 2, 6, 7}}};
    const std::array<glm::dvec3, 8> corners = frustum_corners(params, derived, world_from_view);
    const auto& [a, b, c, d] = faces[static_cast<std::size_t>(cut_by) - 1];
    overlay.fill({corners[a], corners[b], corners[c], corners[d]}, with_alpha(palette().trouble, 70));
    overlay.label(0.5 * (corners[a] + corners[c]), outcome_of(cut_by), palette().trouble);
}

/// A sentence, and a shorter one for a narrow view.
struct ClipWords {
    const char *whole, *brief;
};

ClipWords clip_words(const Params& params) {
    if (params.projection.is_orthographic())
        return {tr("orthographic: w = 1, so eye space is only moved and scaled"), tr("orthographic: w = 1")};
    const bool are_even =
        !precision_of(params.depth.format).is_float && params.depth.mapping != DepthMapping::logarithmic;
    if (params.view.division <= 0.0)
        return {are_even ? tr("eye space: a pyramid, its depth codes crowded at the near plane")
                         : tr("eye space: the frustum is a pyramid"),
                tr("eye space: a pyramid")};
    if (params.view.division >= 1.0)
        return {are_even ? tr("NDC: after ÷ w a box, its depth codes equally spaced")
                         : tr("NDC: after ÷ w the frustum is a box"),
                tr("NDC: a box")};
    return {tr("between: each point is divided by a share of its w"), tr("between: ÷ a share of w")};
}

/// Draws the slider from eye space to NDC at the lower edge; returns the part of the picture that it takes.
Rect division_slider(Params& params, const Rect& rect) {
    const float gap = px(8.0F), height = ImGui::GetFrameHeight() + gap;
    const Rect row{{rect.min.x, rect.max.y - height}, rect.max};
    const char *const from = tr("eye space"), *const to = tr("NDC");
    const float words = ImGui::CalcTextSize(from).x + ImGui::CalcTextSize(to).x + 4.0F * gap;
    ImGui::GetWindowDrawList()->AddRectFilled(row.min, row.max, with_alpha(palette().view_ground, 215));
    ImGui::SetCursorScreenPos({row.min.x + gap, row.min.y + 0.5F * gap});
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(from);
    ImGui::SameLine(0.0F, gap);
    const float width = std::max(row.width() - words, px(40.0F)) / widgets::CurrentContext().scale;
    control(params, "view.division", {.decimals = 2, .slider = true, .width = width, .label = "##division"});
    ImGui::SameLine(0.0F, gap);
    ImGui::TextUnformatted(to);
    return row;
}

}  // namespace

void draw_clip_view(Session& session, ViewState& state, const Derived& derived, const Rect& rect, ImTextureID picture) {
    const widgets::Group group("clip");
    ImDrawList* const draw = ImGui::GetWindowDrawList();
    // The slider is an item before the picture, so that it gets the mouse, but it is drawn above.
    draw->ChannelsSplit(2);
    draw->ChannelsSetCurrent(1);
    const Rect row = division_slider(session.params, rect);
    draw->ChannelsSetCurrent(0);
    picture_item("lower view", rect, picture);
    observer_mouse(state, session);
    {
        const ObserverView view = derive_clip_view(session.params, derived, {rect.size_px()});
        Overlay overlay(draw, rect, view.clip_from_world);
        overlay.keep_labels_off(row);
        draw_code_steps(overlay, session.params, derived);
        draw_frustum(overlay, session.params, derived, effective_camera(derived));
        draw_point_on_its_way(overlay, session.params, derived);
        const auto [whole, brief] = clip_words(session.params);
        overlay.keep_labels_off(
            sentence_over_picture(draw, {rect.min, {rect.max.x, row.min.y}}, palette().camera, whole, brief));
    }
    draw->ChannelsMerge();
}

}  // namespace viewing
