#include "ui/parts/table_parts.h"

#include <algorithm>
#include <cmath>

namespace viewing {

float padding_to_fill(int rows, float height) {
    const float line = ImGui::GetTextLineHeight(), usual = px(cell_padding_y);
    if (!widgets::HasPlainTitles()) return usual;
    return std::clamp(std::floor(0.5F * (height / static_cast<float>(rows) - line)), usual, line + usual);
}

float width_of(const std::string& text, ImFont* font) {
    ImGui::PushFont(font);
    const float width = ImGui::CalcTextSize(text.c_str()).x;
    ImGui::PopFont();
    return width;
}

void text_at_right(const std::string& text) {
    const float indent = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(text.c_str()).x;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(indent, 0.0F));
    ImGui::TextUnformatted(text.c_str());
}

void shortened_text(const std::string& text, float width, const std::string& brief) {
    std::string shown = widgets::Shortened(text, width);
    if (shown != text && !brief.empty()) shown = widgets::Shortened(brief, width);
    ImGui::TextUnformatted(shown.c_str());
    if (shown == text) return;
    ImGui::PushStyleColor(ImGuiCol_Text, palette().text);
    widgets::Tooltip("", text.c_str());
    ImGui::PopStyleColor();
}

}  // namespace viewing
