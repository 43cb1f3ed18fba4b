// The two views below the camera's view. Each shows a topic, and its header is a list of all topics. See
// lower_view_entries.cpp for what each topic draws.
#include <algorithm>

#include "state/fields.h"
#include "text/catalogue.h"
#include "ui/parts/look.h"
#include "ui/parts/view_parts.h"
#include "ui/views/lower_view.h"

namespace viewing {
namespace {

/// Draws the header: a list of all topics or, when presenting, only the name of the current one.
void topic_choice(ViewState& state, Params& params, Slot slot, const Rect& rect, bool is_alone) {
    const Topic shown = topic_of(params, slot);
    int topic = static_cast<int>(shown);
    if (!widgets::Offers("control:view.lower")) return view_header(rect, topic_titles()[topic]);
    view_header(rect, "");
    const char* other = topic_titles()[static_cast<std::size_t>(topic_of(params, other_than(slot)))];
    const float room_beside = rect.width() - widgets::SmallButtonWidth(other) - px(12.0F);
    const bool offers_other =
        is_alone && room_beside >= widgets::ChoiceWidth(topic_titles().subspan(static_cast<std::size_t>(topic), 1));
    const float room = offers_other ? room_beside : rect.width();
    const float width = std::min(std::max(px(190.0F), widgets::ChoiceWidth(topic_titles())), room);
    const auto want = [&](Slot wanted) { state.lower = {wanted, params.view.lower_left, params.view.lower_right}; };
    if (widgets::Choice("##topic", topic, topic_titles(), 0, width)) {
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
    if (!offers_other) return;  // the list of topics also leads to the other view
    if (widgets::SmallButton(other)) want(other_than(slot));
    widgets::Tooltip(other, "Shows the other lower view; this window is too small for both.");
    ImGui::SameLine(0.0F, px(12.0F));
}

}  // namespace

Slot lower_shown(const ViewState& state, const Params& params) {
    const std::optional<LowerChoice>& chosen = state.lower;
    const bool holds = chosen && chosen->left == params.view.lower_left && chosen->right == params.view.lower_right;
    return holds ? chosen->slot : telling_slot(params);
}

void draw_lower_view(Slot slot, const FrameContext& frame, bool is_alone) {
    const Rect& rect = frame.rect;
    if (rect.empty()) return;
    const widgets::Group group(slot == Slot::left ? "left" : "lower");
    topic_choice(frame.state, frame.session.params, slot, rect, is_alone);
    const Topic topic = topic_of(frame.session.params, slot);
    const LowerView& view = lower_view(topic);
    if (ImGui::IsMouseHoveringRect(rect.min, rect.max) && ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows))
        frame.state.hovered = slot == Slot::left ? ViewName::lower_left : ViewName::lower_right;
    const std::string target = "view:" + std::string(name_of(topic));
    widgets::MarkTarget(target, rect.min, rect.max);
    if (widgets::IsCovered(target) || (view.target && widgets::IsCovered(view.target))) {
        ImGui::SetCursorScreenPos(rect.min);
        return widgets::Plate(target.c_str(), {rect.width(), rect.height()});
    }
    if (view.target) widgets::MarkTarget(view.target, rect.min, rect.max);
    view.draw(frame);
}

}  // namespace viewing
