// Clip space from outside: the frustum becomes a box. way_view.cpp shows the same spaces with a point and its matrices.
#include <algorithm>
#include <array>

#include "text/catalogue.h"
#include "topics/camera/numbers/camera_way.h"
#include "topics/camera/numbers/clip_space.h"
#include "topics/depth/numbers/depth_precision.h"
#include "ui/parts/field_controls.h"
#include "ui/parts/look.h"
#include "ui/parts/view_parts.h"
#include "ui/views/lower_view.h"
#include "ui/views/outside.h"

namespace viewing {
namespace {

/// Draws lines across the frustum's lower and left faces to mark equal steps of the stored depth code.
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

/// A sentence, and a shorter one for a narrow view.
struct ClipWords {
    const char *whole, *brief;
};

ClipWords clip_words(const Params& params) {
    if (params.lens().orthographic)
        return {tr("orthographic: w = 1, so eye space is only moved and scaled"), tr("orthographic: w = 1")};
    const bool are_even =
        !precision_of(params.depth.format).is_float && params.depth.mapping != DepthMapping::logarithmic;
    if (params.view.division <= 0.0)
        return {are_even ? tr("eye space: a pyramid; its depth codes crowd at the near plane")
                         : tr("eye space: the frustum is a pyramid"),
                tr("eye space: a pyramid")};
    if (params.view.division >= 1.0)
        return {are_even ? tr("NDC: after ÷ w, a box; its depth codes are equally spaced")
                         : tr("NDC: after ÷ w, the frustum is a box"),
                tr("NDC: a box")};
    return {tr("between: points are divided by a blend of a constant and w"), tr("between: ÷ (constant + part of w)")};
}

}  // namespace

void draw_point_on_ray(Overlay& overlay, const Params& params, const Derived& derived, const char* label) {
    const glm::dvec3& point = derived.followed->point_world;
    if (!params.lens().orthographic)
        overlay.line(glm::dvec3(effective_camera(derived)[3]), point, with_alpha(palette().point, 170), 1.0F);
    overlay.dot(point, palette().point, 5.0F);
    overlay.label(point, label, palette().point);
}

bool point_or_observer_mouse(ViewState& state, Session& session, const Derived& derived, const Overlay& overlay) {
    bool is_over = false;
    if (derived.followed) {
        const ImVec2 mouse = ImGui::GetIO().MousePos;
        const HandlePlaces places = handle_places(derived);
        const bool is_held = ImGui::IsItemActive() && state.grip.handle == Handle::point;
        is_over =
            is_held || (ImGui::IsItemHovered() && state.grip.handle == Handle::none &&
                        is_at(overlay, *places.point, mouse) && movable_handle(state, Handle::point) == Handle::point);
        if (is_over) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
        if (is_over && ImGui::IsMouseClicked(ImGuiMouseButton_Left))
            state.grip = take(overlay, places, Handle::point, session.params, mouse);
        else if (is_held)
            drag(session.params, overlay, state.grip, mouse, ImGui::GetIO().KeyShift);
    }
    observer_mouse(state, session);
    if (ImGui::IsMouseReleased(ImGuiMouseButton_Left)) state.grip = {};
    return is_over;
}

void mark_cutting_face(Overlay& overlay, const Params& params, const Derived& derived) {
    const FrustumPlane cut_by = camera_way(params, derived, derived.followed->point_world).cut_by;
    if (cut_by == FrustumPlane::none || widgets::IsPartCovered("matrix:V") || widgets::IsPartCovered("matrix:P"))
        return;
    static constexpr std::array<std::array<std::size_t, 4>, 6> faces = {
        {{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 3, 7, 4}, {1, 2, 6, 5}, {0, 1, 5, 4}, {3, 2, 6, 7}}};
    const std::array<glm::dvec3, 8> corners = frustum_corners(params, derived, effective_camera(derived));
    const auto& [a, b, c, d] = faces[static_cast<std::size_t>(cut_by) - 1];
    overlay.fill({corners[a], corners[b], corners[c], corners[d]}, with_alpha(palette().trouble, 70));
    overlay.label(0.5 * (corners[a] + corners[c]), tr(outcome_of(cut_by)), palette().trouble);
}

void slider_between(Params& params, const char* path, const Rect& row, const char* from, const char* to) {
    const float gap = px(8.0F), words = ImGui::CalcTextSize(from).x + ImGui::CalcTextSize(to).x + 4.0F * gap;
    // Do not use SameLine() here: the view's header has left its own pending, and newer versions of Dear ImGui would
    // put the slider on the header's line.
    const float y = row.min.y + 0.5F * gap;
    const auto text_at = [y](float x, const char* text) {
        ImGui::SetCursorScreenPos({x, y});
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted(text);
    };
    text_at(row.min.x + gap, from);
    ImGui::SetCursorScreenPos({ImGui::GetItemRectMax().x + gap, y});
    const float width = std::max(row.width() - words, px(40.0F)) / widgets::CurrentContext().scale;
    const std::string label = "##" + std::string(field(path).name());
    control(params, path, {.decimals = 2, .slider = true, .width = width, .label = label.c_str()});
    text_at(ImGui::GetItemRectMax().x + gap, to);
}

Rect slider_row(const Rect& rect, const char* path) {
    if (!widgets::Offers(target_of(path))) return {{rect.min.x, rect.max.y}, rect.max};
    const Rect row{{rect.min.x, rect.max.y - ImGui::GetFrameHeight() - px(8.0F)}, rect.max};
    ImGui::GetWindowDrawList()->AddRectFilled(row.min, row.max, with_alpha(palette().view_ground, 215));
    return row;
}

namespace {

void draw_clip_view(const FrameContext& frame) {
    const auto& [state, session, derived, plan, pictures, rect, picture] = frame;
    const widgets::Group group("clip");
    ImDrawList* const draw = ImGui::GetWindowDrawList();
    // The slider is submitted before the picture, so that it gets the mouse input, but it is drawn on top of the
    // picture.
    draw->ChannelsSplit(2);
    draw->ChannelsSetCurrent(1);
    const Rect row = slider_row(rect, "view.division");
    if (!row.empty()) slider_between(session.params, "view.division", row, tr("eye space"), tr("NDC"));
    draw->ChannelsSetCurrent(0);
    picture_item("lower view", rect, picture);
    {
        const ObserverView view = derive_clip_view(session.params, derived, {rect.size_px()});
        Overlay overlay(draw, rect, view.clip_from_world);
        const bool is_over_point = point_or_observer_mouse(state, session, derived, overlay);
        overlay.keep_labels_off(row);
        draw_code_steps(overlay, session.params, derived);
        draw_frustum(overlay, session.params, derived, effective_camera(derived));
        if (derived.followed) {
            const double division = session.params.view.division;
            draw_point_on_ray(overlay, session.params, derived,
                              division <= 0.0   ? "V p"
                              : division >= 1.0 ? "P V p ÷ w"
                                                : "p");
            if (is_over_point) overlay.ring(derived.followed->point_world, palette().point, 9.0F);
            mark_cutting_face(overlay, session.params, derived);
        }
        const auto [whole, brief] = clip_words(session.params);
        overlay.keep_labels_off(
            sentence_over_picture(draw, {rect.min, {rect.max.x, row.min.y}}, palette().camera, whole, brief));
    }
    draw->ChannelsMerge();
}

}  // namespace

const LowerView lower_views::clip{
    .title = marked("Clip space"),
    .draw = draw_clip_view,
    .camera = [](const Params& params, const Derived& derived, const Scene&,
                 const Rect& rect) { return derive_clip_view(params, derived, {rect.size_px()}); },
    .turns = true,
};

}  // namespace viewing
