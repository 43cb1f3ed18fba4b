// The context that all widgets share: start of a frame, highlights, groups, and the recorder that tests use to click by
// name. Read widgets.h first.
#include <algorithm>
#include <cassert>
#include <utility>

#include "widgets/inner.h"

namespace widgets {

namespace {
Context* current = nullptr;
}

void NewFrame(Context& context) {
    current = &context;
    context.hovered = context.hovered_next;
    context.hovered_next = 0;
    context.entry_hovered = context.entry_hovered_next;
    context.entry_hovered_next = false;
    context.recorded.clear();
    context.seen_share = 1.0F;
    context.used_share = 0.0F;
    context.scrolled_count = 0;
    context.offered.clear();
    context.sections.clear();
    context.label_path.clear();
    inner::BeginTargets(context.targets);
    if (IsCovered("links")) context.hovered = 0;

    Editing& editing = context.editing;
    const int frame = ImGui::GetFrameCount();
    if (editing.typing_frame < frame - 1) editing.typing = 0;  // its panel was folded
    editing.ends = std::exchange(editing.ends_next, false);
    editing.entered = 0;
    editing.type_now = editing.type_next;
    editing.type_next = 0;
    editing.tab = 0;
    editing.last_number = 0;
    editing.redraw_in_s = -1.0F;
}

Context& CurrentContext() {
    assert(current && "call widgets::NewFrame first");
    return *current;
}

namespace {

/// Marks the lower edge of the current window if its content continues below.
void DrawMoreBelow(float fade) {
    if (CurrentContext().printed || ImGui::GetScrollMaxY() - ImGui::GetScrollY() < inner::Px(4)) return;
    const Palette& palette = CurrentContext().palette;
    const ImVec2 min = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    const ImVec2 max(min.x + size.x, min.y + size.y);
    const ImU32 ground = inner::Shown(palette.ground), clear = inner::Shown(inner::WithAlpha(palette.ground, 0.0F));
    ImDrawList* draw = ImGui::GetWindowDrawList();
    draw->AddRectFilledMultiColor({min.x, max.y - inner::Px(fade)}, max, clear, clear, ground, ground);
    inner::DrawTriangle(draw, ImVec2(0.5F * (min.x + max.x), max.y - inner::Px(8)), inner::Px(5), true,
                        inner::Shown(palette.accent));
}

}  // namespace

void CountScrolled(bool is_filled, float fade) {
    DrawMoreBelow(fade);
    const auto share = [](float size, float hidden) { return size / std::max(size + hidden, 1.0F); };
    const float width = ImGui::GetWindowWidth(), height = ImGui::GetWindowHeight();
    Context& context = CurrentContext();
    context.seen_share =
        std::min({context.seen_share, share(width, ImGui::GetScrollMaxX()), share(height, ImGui::GetScrollMaxY())});
    ++context.scrolled_count;
    if (!is_filled)
        context.used_share =
            std::max(context.used_share, (ImGui::GetCursorPosY() + ImGui::GetScrollY()) / std::max(height, 1.0F));
}

float RedrawIn(const Context& context) {
    const Editing& editing = context.editing;
    if (context.hovered != context.hovered_next || context.entry_hovered != context.entry_hovered_next) return 0.0F;
    if (editing.type_next || (editing.typing && !editing.focused) || context.targets.frames_of_search > 0) return 0.0F;
    if (MayBeTakenBack(context)) return ImGui::GetIO().MouseDoubleClickTime;
    return editing.redraw_in_s;
}

void AskForRedraw(float in_s) {
    float& redraw_in_s = CurrentContext().editing.redraw_in_s;
    redraw_in_s = redraw_in_s < 0.0F ? in_s : std::min(redraw_in_s, in_s);
}

void GoOnWhileHeld() {
    if (ImGui::IsItemActive()) AskForRedraw(ImGui::GetIO().KeyRepeatRate);
}

bool MayBeTakenBack(const Context& context) {
    const double jumped_at_s = context.editing.jumped_at_s;
    return jumped_at_s >= 0.0 && ImGui::GetTime() - jumped_at_s <= ImGui::GetIO().MouseDoubleClickTime;
}

void EndTyping(Context& context) {
    context.editing.ends_next = true;
}

bool IsTyping(const Context& context) {
    return context.editing.typing != 0 || std::any_of(context.text_fields.begin(), context.text_fields.end(),
                                                      [](const auto& field) { return field.second.entry.has_value(); });
}

Group::Group(const char* name) {
    CurrentContext().label_path.emplace_back(inner::RecordedPart(name));
    ImGui::PushID(name);
}

Group::~Group() {
    ImGui::PopID();
    CurrentContext().label_path.pop_back();
}

void Record(const char* label, std::string_view text) {
    inner::RecordRect(label, ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), text);
}

std::string LabelText(const char* label) {
    return std::string(tr_part(inner::ShownPart(label))) + "###" + label;
}

namespace inner {

std::string_view ShownPart(const char* label) {
    const std::string_view whole = label;
    return whole.substr(0, whole.find("##"));
}

std::string_view RecordedPart(const char* label) {
    const std::string_view whole = label, shown = ShownPart(label);
    constexpr std::string_view id_mark = "###";
    if (const std::size_t id = whole.find(id_mark); id != std::string_view::npos)
        return whole.substr(id + id_mark.size());
    if (!shown.empty()) return shown;
    const std::size_t begin = whole.find_first_not_of('#');
    return begin == std::string_view::npos ? std::string_view{} : whole.substr(begin);
}

void RecordRect(const char* label, ImVec2 min, ImVec2 max, std::string_view text) {
    Context& context = CurrentContext();
    if (!context.record) return;
    RecordedItem item;
    const char* window = ImGui::GetWindowDrawList()->_OwnerName;
    item.window = window ? window : "";
    for (const std::string& name : context.label_path) item.label.append(name).append("/");
    item.label.append(RecordedPart(label));
    item.min = min;
    item.max = max;
    item.enabled = !IsDisabled();
    item.text = text;
    context.recorded.push_back(std::move(item));
}

void RecordSwitch(const char* label, ImVec2 min, ImVec2 max, std::string_view text) {
    RecordRect(label, min, max, text);
    if (CurrentContext().record) CurrentContext().recorded.back().is_switch = true;
}

bool FollowLinks(Links links) {
    Context& context = CurrentContext();
    const bool under_pointer = ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled) || ImGui::IsItemActive();
    if (under_pointer) context.hovered_next |= links;
    return (links & context.hovered) != 0;
}

void PointAtEntry(Links own, Links links) {
    Context& context = CurrentContext();
    context.hovered_next |= own | links;
    context.entry_hovered_next = true;
}

bool IsEntryLit(Links own, Links links) {
    const Context& context = CurrentContext();
    const Links lighting = context.entry_hovered ? own : own | links;
    return (lighting & context.hovered) != 0;
}

bool TooltipDue(bool hovered, ImVec2 min, ImVec2 max) {
    const Context& context = CurrentContext();
    const float delay_s = context.is_on_stage ? 0.2F : 0.5F;
    const ImGuiIO& io = ImGui::GetIO();
    Editing& editing = CurrentContext().editing;
    if (!hovered) return false;
    const int frame = ImGui::GetFrameCount();
    const ImVec4 item(min.x, min.y, max.x, max.y);
    const bool same_item = editing.tooltip_of.x == item.x && editing.tooltip_of.y == item.y &&
                           editing.tooltip_of.z == item.z && editing.tooltip_of.w == item.w;
    if (!same_item && editing.tooltip_frame == frame) return false;
    if (!same_item || editing.tooltip_frame < frame - 1) {
        editing.tooltip_of = item;
        editing.tooltip_time_s = editing.tooltip_rest_s = 0.0F;
        editing.tooltip_muted = false;
    } else if (editing.tooltip_frame < frame) {
        const bool moves = io.MouseDelta.x != 0.0F || io.MouseDelta.y != 0.0F;
        const bool is_shown = editing.tooltip_time_s >= delay_s;
        editing.tooltip_time_s = moves && !is_shown ? 0.0F : editing.tooltip_time_s + io.DeltaTime;
        editing.tooltip_rest_s = moves ? 0.0F : editing.tooltip_rest_s + io.DeltaTime;
    }
    editing.tooltip_frame = frame;
    const bool typing = io.WantTextInput && ImGui::IsAnyItemActive();
    editing.tooltip_muted |= ImGui::IsAnyMouseDown() || typing;
    if (editing.tooltip_muted) return false;
    // On stage, a tooltip must not keep covering anything while the pointer rests.
    constexpr float longest_rest_s = 1.0F;
    if (context.is_on_stage) {
        if (editing.tooltip_rest_s >= longest_rest_s) return false;
        AskForRedraw(longest_rest_s - editing.tooltip_rest_s);
    }
    if (editing.tooltip_time_s >= delay_s) {
        // ImGui hides a new window in its first frame, so the tooltip needs more frames to appear.
        constexpr int frames_to_appear = 3;
        if (editing.tooltip_frames_due++ < frames_to_appear) AskForRedraw(0.0F);
        return true;
    }
    editing.tooltip_frames_due = 0;
    AskForRedraw(delay_s - editing.tooltip_time_s);
    return false;
}

}  // namespace inner

bool FollowEntry(Links own, Links links) {
    if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) inner::PointAtEntry(own, links);
    return inner::IsEntryLit(own, links);
}

}  // namespace widgets
