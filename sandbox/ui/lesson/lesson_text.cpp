#include "ui/lesson/lesson_text.h"

#include <algorithm>

#include "ui/parts/drawn_subscripts.h"

namespace viewing {

Paragraph paragraph(const std::string& text, ImFont* font, float width) {
    if (!font || text.empty()) return {"", font, 0.0F};
    Paragraph result{widgets::BrokenAtBlanks(text, std::max(width, 1.0F), *font), font, 0.0F};
    const auto lines = static_cast<float>(1 + std::count(result.lines.begin(), result.lines.end(), '\n'));
    result.height = lines * font->FontSize;
    return result;
}

void Paragraph::draw(const char* label, ImU32 color) const {
    if (lines.empty()) return;
    ImGui::PushFont(font);
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    text_with_subscripts(lines);
    ImGui::PopStyleColor();
    ImGui::PopFont();
    widgets::Record(label);
}

}  // namespace viewing
