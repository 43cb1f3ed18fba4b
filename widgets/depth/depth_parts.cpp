// Shared by the diagrams of depth.h. See depth_inner.h.
#include "widgets/depth/depth_inner.h"

#include <algorithm>
#include <cmath>

namespace widgets::inner {

double ValueAtPixel(const LogScale& scale, double pixel) {
    const double fraction = (pixel - scale.from) / (scale.to - scale.from);
    return std::pow(10.0, scale.low + fraction * (scale.high - scale.low));
}

ImVec2 AreaSize(ImVec2 wanted, ImVec2 least) {
    const ImVec2 room = ImGui::GetContentRegionAvail();
    return ImVec2(std::max(wanted.x > 0.0F ? wanted.x : room.x, Px(least.x)),
                  std::max(wanted.y > 0.0F ? wanted.y : room.y, Px(least.y)));
}

DragLineUse UseLine(const DragLine& line, float top, float bottom) {
    const ImGuiIO& io = ImGui::GetIO();
    Editing& editing = CurrentContext().editing;
    const float half = Px(6);
    ImGui::SetCursorScreenPos(ImVec2(line.x - half, top));
    ImGui::InvisibleButton(line.id, ImVec2(2.0F * half, std::max(bottom - top, 1.0F)));
    RecordRect(line.id, ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), line.text);

    DragLineUse use;
    use.held = ImGui::IsItemActive();
    use.hovered = ImGui::IsItemHovered();
    use.reset = use.hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Right);
    if (use.held || use.hovered) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (ImGui::IsItemActivated()) {
        editing.drag_value = line.x;
    } else if (use.held && io.MouseDelta.x != 0.0F) {
        // Do not clamp here: a pointer that has passed the end must meet the line again when it returns.
        editing.drag_value += io.MouseDelta.x * (io.KeyAlt ? 0.01 : 1.0);
        use.x = editing.drag_value;
    }
    Tooltip(line.tip_title, line.tip);
    return use;
}

DragLinesUse UseLines(const DragLine& low, const DragLine& high, float top, float bottom) {
    DragLinesUse use;
    const bool high_first = ImGui::GetIO().MousePos.x > 0.5F * (low.x + high.x);
    if (high_first) use.high = UseLine(high, top, bottom);
    use.low = UseLine(low, top, bottom);
    if (!high_first) use.high = UseLine(high, top, bottom);
    return use;
}

void DrawDragLine(ImDrawList* draw, float x, float top, float bottom, ImU32 color, const DragLineUse& use) {
    const Palette& palette = CurrentContext().palette;
    const bool lit = use.held || use.hovered;
    const float half = 0.5F * std::round(Px(lit ? 3 : 2) * palette.stroke), grip = Px(lit ? 5 : 4);
    x = std::floor(x) + 0.5F;
    draw->AddRectFilled(ImVec2(x - half, top), ImVec2(x + half, bottom), color);
    draw->AddRectFilled(ImVec2(x - grip, top - Px(3)), ImVec2(x + grip, top + Px(9)), color, Px(2));
    const ImU32 ink = Shown(InkOn(color));
    for (const float dx : {-Px(1.5F), Px(1.5F)}) {
        draw->AddLine(ImVec2(x + dx, top), ImVec2(x + dx, top + Px(6)), ink, Px(1));
    }
}

void DrawReadoutBox(ImDrawList* draw, const Box& area, ImVec2 at, const std::string& heading,
                    std::span<const std::string> lines) {
    const Context& context = CurrentContext();
    const Face heading_face = FaceOf(context.fonts.heading), face = FaceOf(context.fonts.note);
    const float padding = Px(7), gap = Px(3), away = Px(12);
    float width = heading_face.Measure(heading).x;
    for (const std::string& line : lines) width = std::max(width, face.Measure(line).x);
    const float height = heading_face.size + static_cast<float>(lines.size()) * (face.size + gap);
    const ImVec2 size(width + 2.0F * padding, height + 2.0F * padding);
    const float left = at.x + away + size.x > area.max.x ? at.x - away - size.x : at.x + away;
    const float top = at.y - away - size.y < area.min.y ? at.y + away : at.y - away - size.y;
    const ImVec2 min(std::floor(std::max(std::min(left, area.max.x - size.x), area.min.x)),
                     std::floor(std::max(std::min(top, area.max.y - size.y), area.min.y)));
    const ImVec2 max(min.x + size.x, min.y + size.y);
    draw->AddRectFilled(min, max, ImGui::GetColorU32(ImGuiCol_PopupBg), Px(6));
    draw->AddRect(min, max, Shown(context.palette.border), Px(6), 0, Px(1) * context.palette.stroke);
    ImVec2 line_at(min.x + padding, min.y + padding);
    heading_face.Draw(draw, line_at, Shown(context.palette.text), heading);
    line_at.y += heading_face.size + gap;
    std::string all = heading;
    for (const std::string& line : lines) {
        face.Draw(draw, line_at, Shown(context.palette.text), line);
        line_at.y += face.size + gap;
        all += "\n" + line;
    }
    RecordRect("readout", min, max, all);
}

}  // namespace widgets::inner
