// Freely drawn areas that use the mouse wheel. Read area.h.
#include "widgets/area.h"

#include <cmath>

namespace widgets::inner {

WheelArea::WheelArea(const char* id, ImVec2 size) {
    ImGui::BeginChild(id, size, false, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoBackground);
    min = ImGui::GetWindowPos();
    max = ImVec2(min.x + size.x, min.y + size.y);
}

WheelArea::~WheelArea() {
    // ImGui passes the wheel to the parent unless this window can scroll, so add one invisible pixel of content.
    ImGui::SetCursorScreenPos(ImVec2(min.x, max.y));
    ImGui::Dummy(ImVec2(1.0F, 1.0F));
    ImGui::SetScrollY(0.0F);
    ImGui::EndChild();
}

void DrawHint(ImDrawList* draw, ImVec2 min, ImVec2 max, std::string_view sentence) {
    const Face face = FaceOf(CurrentContext().fonts.note);
    const ImVec2 size = face.Measure(sentence);
    face.Draw(draw, ImVec2(std::floor((min.x + max.x - size.x) * 0.5F), std::floor((min.y + max.y - size.y) * 0.5F)),
              Shown(CurrentContext().palette.quiet), sentence);
}

}  // namespace widgets::inner
