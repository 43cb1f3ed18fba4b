// The two views below the camera's: the observer, and what a topic wants beside it.
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

void passes_list(const FramePlan& plan, const Rect& rect) {
    const widgets::Context& context = widgets::CurrentContext();
    ImGui::SetCursorScreenPos(rect.min);
    ImGui::PushStyleColor(ImGuiCol_ChildBg, context.palette.raised);
    ImGui::BeginChild("passes", {rect.width(), rect.height()}, false, ImGuiWindowFlags_AlwaysUseWindowPadding);
    for (std::size_t number = 0; number < plan.passes.size(); ++number) {
        const Pass& pass = plan.passes[number];
        ImGui::PushFont(context.fonts.heading);
        ImGui::Text("%zu  %s", number + 1, pass.name.c_str());
        ImGui::PopFont();
        widgets::Note(pass.reason.c_str());
        ImGui::PushFont(context.fonts.small_number);
        ImGui::Indent(px(12.0F));
        for (const std::string& call : gl_calls(pass)) ImGui::TextWrapped("%s", call.c_str());
        ImGui::Unindent(px(12.0F));
        ImGui::PopFont();
        ImGui::Dummy({0.0F, px(4.0F)});
    }
    ImGui::EndChild();
    ImGui::PopStyleColor();
}

/// Another method brings what is to be seen of it: the tree, the order, or the depth buffer again.
void follow_method(ViewState& state, VisibilityMethod method) {
    if (state.topic_for == method) return;
    state.topic_for = method;
    state.topic = method == VisibilityMethod::bsp ? LowerTopic::tree
                  : is_drawn_by_gl_alone(method)  ? LowerTopic::depth
                                                  : LowerTopic::order;
}

/// What black and white stand for in the depth picture beside the camera's.
void draw_depth_legend(const Session& session, const Derived& derived, const Rect& rect) {
    const glm::dvec2 range = fitting_range(session.params, derived, session.scene());
    const std::string near = "z = " + widgets::NumberText(range.x, 2), far = widgets::NumberText(range.y, 2);
    const LegendEntry entries[] = {{{0, 0, 0}, near.c_str()},
                                   {{255, 255, 255}, far.c_str()},
                                   {ground_of(session.params.ui.theme).unwritten, "never written"}};
    draw_legend(ImGui::GetWindowDrawList(), rect, entries);
}

}  // namespace

void draw_observer_view(ViewState& state, Session& session, const Derived& derived, const Rect& rect,
                        const Pictures& pictures) {
    if (rect.empty()) return;
    const widgets::Group group("observer");
    view_header(rect, "Observer");
    header_note("camera frustum, light, plane", rect.max.x);
    picture_item("observer view", rect, pictures.observer);
    const bool over = ImGui::IsItemHovered();
    if (over) state.hovered = ViewName::observer;

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
    draw_laboratory_observer(state.laboratory, pictures.hidden, overlay);
    draw_handles(overlay, places, session.params, derived, hovered);
    draw_followed(overlay, session.params, derived);
}

void draw_lower_right_view(ViewState& state, Session& session, const Derived& derived, const FramePlan& plan,
                           const Rect& rect, const Pictures& pictures) {
    if (rect.empty()) return;
    const widgets::Group group("lower");
    follow_method(state, session.params.visibility.method);
    static constexpr const char* topics[] = {"Depth buffer", "Moving the world", "GL calls, pass by pass",
                                             "BSP tree",     "Drawing order",    "Costs as they grow"};
    ImGui::SetCursorScreenPos({rect.min.x, rect.min.y - px(25.0F)});
    int topic = static_cast<int>(state.topic);
    if (widgets::Choice("##topic", topic, topics, 0, std::min(px(190.0F), rect.width())))
        state.topic = static_cast<LowerTopic>(topic);
    widgets::Tooltip(
        "What this view shows",
        "The camera's depth buffer; the world moving while the camera stays; or the passes of the frame with "
        "what GL is told in each. Of the hidden-surface methods: the tree, the order in which polygons are drawn, and "
        "what each method costs as a scene grows.");

    const bool over = ImGui::IsMouseHoveringRect(rect.min, rect.max);
    switch (state.topic) {
        case LowerTopic::passes:
            return passes_list(plan, rect);
        case LowerTopic::tree:
            if (over) state.hovered = ViewName::lower_right;
            return draw_tree_view(state.laboratory, session, pictures.hidden, rect);
        case LowerTopic::order:
            if (over) state.hovered = ViewName::lower_right;
            return draw_order_view(state.laboratory, session, pictures.hidden, rect);
        case LowerTopic::growth:
            if (over) state.hovered = ViewName::lower_right;
            return draw_growth_view(state.laboratory, session, rect);
        case LowerTopic::depth:
        case LowerTopic::moving_world:
            break;
    }
    picture_item("lower view", rect, pictures.lower_right);
    if (ImGui::IsItemHovered()) state.hovered = ViewName::lower_right;
    if (state.topic == LowerTopic::depth) {
        draw_depth_legend(session, derived, rect);
        if (session.params.visibility.method != VisibilityMethod::depth_buffer)
            widgets::HaloText(ImGui::GetWindowDrawList(), {rect.min.x + px(10.0F), rect.min.y + px(8.0F)},
                              palette().text, "This method draws with GL's depth test off: no depth is written.");
        return;
    }
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
