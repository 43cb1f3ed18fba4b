#include "ui/matrices/display_code.h"

#include <algorithm>
#include <cfloat>

#include "frame/display_code.h"
#include "ui/parts/look.h"
#include "ui/parts/view_window.h"

namespace viewing {
namespace {

ImU32 color_of(const DisplayLine& line) {
    return line.moves_world ? palette().of(widgets::Role::camera) : palette().text;
}

}  // namespace

void draw_display_code(const Params& params, const Derived& derived) {
    ImGui::PushFont(widgets::CurrentContext().fonts.small_number);
    for (const DisplayLine& line : display_lines(params, derived)) {
        ImGui::PushStyleColor(ImGuiCol_Text, color_of(line));
        ImGui::TextUnformatted(line.code.c_str());
        ImGui::PopStyleColor();
    }
    ImGui::PopFont();
}

void draw_display_code_view(const Params& params, const Derived& derived, const Rect& rect) {
    const ViewWindow window("display code", rect);
    const std::vector<DisplayLine> lines = display_lines(params, derived);
    const ImFont* const font = widgets::CurrentContext().fonts.number;
    float longest = 1.0F;  // in units of the font's size
    for (const DisplayLine& line : lines)
        longest = std::max(longest, font->CalcTextSizeA(1.0F, FLT_MAX, 0.0F, line.code.c_str()).x);
    constexpr float spacing = 1.3F, largest = 3.0F;
    const float margin = px(12.0F), rows = static_cast<float>(lines.size()) * spacing;
    const float size = std::min(
        {(rect.width() - 2.0F * margin) / longest, (rect.height() - 2.0F * margin) / rows, largest * font->FontSize});
    for (std::size_t row = 0; row < lines.size(); ++row) {
        const ImVec2 at(rect.min.x + margin, rect.min.y + margin + size * spacing * static_cast<float>(row));
        ImGui::GetWindowDrawList()->AddText(font, size, at, color_of(lines[row]), lines[row].code.c_str());
    }
}

}  // namespace viewing
