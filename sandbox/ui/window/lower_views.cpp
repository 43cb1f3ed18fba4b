// The two views below the camera's. Each shows a topic, and its header is a list of all topics.
#include <algorithm>
#include <cfloat>

#include "state/fields.h"
#include "text/catalogue.h"
#include "ui/depth/cell_bar.h"
#include "ui/depth/depth_views.h"
#include "ui/depth/fighting_view.h"
#include "ui/depth/pixel_view.h"
#include "ui/depth/precision_view.h"
#include "ui/matrices/display_code.h"
#include "ui/parts/look.h"
#include "ui/parts/view_parts.h"
#include "ui/planes/derivation_views.h"
#include "ui/planes/lecture_code.h"
#include "ui/planes/mirror_ways_view.h"
#include "ui/planes/passes_view.h"
#include "ui/views/views.h"
#include "ui/views/way_view.h"
#include "ui/why/why_view.h"

namespace viewing {
namespace {

Slot other_than(Slot slot) {
    return slot == Slot::left ? Slot::right : Slot::left;
}

/// Draws the header: a list of all topics or, when presenting, only the name of the current one.
void topic_choice(ViewState& state, Params& params, Slot slot, const Rect& rect, bool is_alone) {
    const Topic shown = topic_of(params, slot);
    int topic = static_cast<int>(shown);
    if (!widgets::Offers("control:view.lower"))
        return view_header(rect, topic_names()[static_cast<std::size_t>(topic)]);
    view_header(rect, "");
    const char* other = topic_names()[static_cast<std::size_t>(topic_of(params, other_than(slot)))];
    const float room_beside = rect.width() - widgets::SmallButtonWidth(other) - px(12.0F);
    const bool offers_other =
        is_alone && room_beside >= widgets::ChoiceWidth(topic_names().subspan(static_cast<std::size_t>(topic), 1));
    const float room = offers_other ? room_beside : rect.width();
    const float width = std::min(std::max(px(190.0F), widgets::ChoiceWidth(topic_names())), room);
    const auto want = [&](Slot wanted) { state.lower = {wanted, params.view.lower_left, params.view.lower_right}; };
    if (widgets::Choice("##topic", topic, topic_names(), 0, width)) {
        choose_topic(params, slot, static_cast<Topic>(topic));
        want(slot);
    }
    widgets::Tooltip(
        "What this view shows",
        "Choose the observer's view of the camera from outside, or the view from the light; the world moving while the "
        "camera stays; clip space, where the frustum becomes a box; the path of a point through the matrices; why a "
        "pixel has its color; the depth buffer and its analysis (histogram, precision, codes, one pixel, a block of "
        "pixels, depth fighting); the lecture's display(); the lecture's derivation and code for shadow and mirror, "
        "and four ways to draw a mirror; the frame as GL calls, pass by pass; or, for the hidden-surface methods, the "
        "tree, the drawing order and the growth of the cost.");
    ImGui::SameLine(0.0F, px(12.0F));
    if (!offers_other) return;  // the list also has that topic
    if (widgets::SmallButton(other)) want(other_than(slot));
    widgets::Tooltip(other, "Shows the other lower view; this window is too small for both.");
    ImGui::SameLine(0.0F, px(12.0F));
}

/// Draws the tree's legend, in the longest form that fits.
void tree_legend(float right) {
    static constexpr const char* legends[] = {
        marked("color: the polygon's color · + front, − back · small number: traversal order · thick: the eye's side"),
        marked("+ front, − back · small number: traversal order · thick: the eye's side"),
        marked("+ front, − back · thick: the eye's side"), marked("+ front, − back")};
    const float left = ImGui::GetCursorScreenPos().x;
    const ImFont* font = widgets::CurrentContext().fonts.note;
    for (const char* legend : legends) {
        if (left + font->CalcTextSizeA(font->FontSize, FLT_MAX, 0.0F, tr(legend)).x > right) continue;
        header_note(legend, right);
        return widgets::Tooltip(
            "How to read the tree",
            (std::string(tr(legends[0])) + "\n" +
             tr("The tree does not depend on the eye, although the slide's \"according to the viewer direction\" may "
                "suggest that it does. The tree is built once, and only its traversal depends on the eye."))
                .c_str());
    }
}

/// Draws the view from the light, with a sentence over the picture.
void draw_light_view(const Derived& derived, const Rect& rect, ImTextureID picture) {
    picture_item("light view", rect, picture);
    const char* whole =
        tr("the light's view: true shadows hide behind their casters, so any shadow seen here is false");
    const char* brief = tr("any shadow seen here is false");
    if (derived.chosen_shadow().light_in_plane) {
        whole = tr("the light lies in the plane and sees it edge-on: there is no shadow");
        brief = tr("there is no shadow");
    }
    sentence_over_picture(ImGui::GetWindowDrawList(), rect, palette().light, whole, brief);
}

/// The last item must be another picture from the same camera. If the pointer is over it, reports the corresponding
/// pixel of the camera's picture. A click pins that pixel if a view shows pinned pixels.
void point_at_camera(ViewState& state, Params& params, const Rect& rect) {
    if (!ImGui::IsItemHovered()) return;
    state.hovered_pixel = camera_pixel_at(rect, ImGui::GetIO().MousePos, state.camera_px, params.projection);
    if (!state.hovered_pixel) return;
    state.told_pixel = state.hovered_pixel;
    if (examines_pixel(params) && ImGui::IsMouseClicked(ImGuiMouseButton_Left))
        pin(params, state.pinned, *state.hovered_pixel);
}

}  // namespace

Slot lower_shown(const ViewState& state, const Params& params) {
    const std::optional<LowerChoice>& chosen = state.lower;
    const bool holds = chosen && chosen->left == params.view.lower_left && chosen->right == params.view.lower_right;
    return holds ? chosen->slot : telling_slot(params);
}

void draw_lower_view(Slot slot, ViewState& state, Session& session, const Derived& derived, const FramePlan& plan,
                     const Rect& rect, const Pictures& pictures, bool is_alone) {
    if (rect.empty()) return;
    const widgets::Group group(slot == Slot::left ? "left" : "lower");
    topic_choice(state, session.params, slot, rect, is_alone);
    const Topic topic = topic_of(session.params, slot);
    const ImTextureID picture = pictures.lower[static_cast<std::size_t>(slot)];
    if (ImGui::IsMouseHoveringRect(rect.min, rect.max) && ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows))
        state.hovered = slot == Slot::left ? ViewName::lower_left : ViewName::lower_right;
    const std::string target = "view:" + std::string(name_of(topic));
    widgets::MarkTarget(target, rect.min, rect.max);
    if (widgets::IsCovered(target) || (topic == Topic::lecture_code && widgets::IsCovered("code:lecture"))) {
        ImGui::SetCursorScreenPos(rect.min);
        return widgets::Plate(target.c_str(), {rect.width(), rect.height()});
    }
    if (topic == Topic::lecture_code) widgets::MarkTarget("code:lecture", rect.min, rect.max);
    switch (topic) {
        case Topic::automatic:
            break;
        case Topic::observer:
            header_note("camera frustum, light, plane", rect.max.x);
            return draw_observer_view(state, session, derived, rect, picture, pictures.hidden);
        case Topic::depth:
            draw_depth_picture(session, derived, rect, picture);
            return point_at_camera(state, session.params, rect);
        case Topic::histogram:
            return draw_histogram_view(session, derived, pictures.depth.depth_counts, rect);
        case Topic::precision:
            return draw_precision_view(session, derived, rect,
                                       pictures.depth.pixel ? -pictures.depth.pixel->eye_z : 0.0);
        case Topic::codes:
            return draw_codes_view(session, derived, rect);
        case Topic::pixel:
            return draw_pixel_view(session, derived, pictures.depth, state.pinned, rect);
        case Topic::cells:
            if (const float width = px(84.0F);
                widgets::Offers("control:view.cells") && ImGui::GetCursorScreenPos().x + width <= rect.max.x)
                choose_cells(session.params.view.cells, width);
            state.cells = cell_block_size(rect, session.params.view.cells);
            return draw_cell_view(session, pictures.depth, plan, rect, state.call_player);
        case Topic::fighting:
            return draw_fighting_view(session, pictures.depth.fighting.get(), rect);
        case Topic::moving_world:
            return draw_moving_world_view(session, state, derived, rect, picture);
        case Topic::clip:
            return draw_clip_view(session, state, derived, rect, picture);
        case Topic::way:
            return draw_way_view(state, session, derived, rect, picture);
        case Topic::passes:
            return draw_passes_view(session, plan, rect, pictures.passes, derived.aspect, state.pass_player);
        case Topic::tree:
            tree_legend(rect.max.x);
            return draw_tree_view(state.hidden.tree, state.hidden.links, session, pictures.hidden, rect);
        case Topic::order:
            return draw_order_view(state.hidden.order, state.hidden.links, session, pictures.hidden, rect);
        case Topic::growth:
            return draw_growth_view(state.hidden.growth, session, rect);
        case Topic::shadow_derivation:
            return draw_shadow_derivation(session, derived, rect, state.derivation_player);
        case Topic::mirror_derivation:
            return draw_mirror_derivation(session, derived, rect, state.derivation_player);
        case Topic::lecture_code:
            return draw_lecture_code(session, derived, rect);
        case Topic::mirror_ways:
            return draw_mirror_ways_view(session, rect, pictures.mirror_ways);
        case Topic::from_light:
            return draw_light_view(derived, rect, picture);
        case Topic::display_code:
            return draw_display_code_view(session.params, derived, rect);
        case Topic::why:
            return draw_why_view(state.why, session, state.pinned, rect);
        default:
            break;
    }
}

}  // namespace viewing
