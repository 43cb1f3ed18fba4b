#include "topics/matrices/shown/display_code_view.h"

#include <algorithm>
#include <cfloat>
#include <cmath>

#include "topics/matrices/numbers/display_code.h"
#include "ui/parts/look.h"
#include "ui/parts/view_window.h"

namespace viewing {
namespace {

ImU32 color_of(const DisplayLine& line) {
    return line.moves_world ? palette().of(widgets::Role::camera) : palette().text;
}

/// The line's name in lessons.
std::string target_of_line(const DisplayLine& line) {
    return line.part.empty() ? "code:display" : "code:display." + line.part;
}

}  // namespace

void draw_display_code(const Params& params, const Derived& derived) {
    const std::vector<DisplayLine> lines = display_lines(params, derived);
    ImGui::PushFont(widgets::CurrentContext().fonts.small_number);
    const ImVec2 line_size(ImGui::GetContentRegionAvail().x, ImGui::GetTextLineHeight());
    if (widgets::IsCovered("code:display")) {
        widgets::Plate("code", {line_size.x, static_cast<float>(lines.size()) * ImGui::GetTextLineHeightWithSpacing()});
        widgets::MarkTarget("code:display");
        return ImGui::PopFont();
    }
    for (const DisplayLine& line : lines) {
        const std::string target = target_of_line(line);
        ImGui::PushStyleColor(ImGuiCol_Text, color_of(line));
        if (widgets::IsCovered(target))
            widgets::Plate("code", line_size);
        else
            ImGui::TextUnformatted(line.code.c_str());
        widgets::MarkTarget(target);
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
    constexpr float spacing = 1.15F, largest = 3.0F;
    const float margin = px(8.0F), rows = static_cast<float>(lines.size()) * spacing;
    // Use a whole number of pixels: type of any other size would be blurred.
    const float size = std::floor(std::min(
        {(rect.width() - 2.0F * margin) / longest, (rect.height() - 2.0F * margin) / rows, largest * font->FontSize}));
    ImDrawList* const draw = ImGui::GetWindowDrawList();
    for (std::size_t row = 0; row < lines.size(); ++row) {
        const DisplayLine& line = lines[row];
        const char* const code = line.code.c_str();
        const ImVec2 at(rect.min.x + margin,
                        std::floor(rect.min.y + margin + size * spacing * static_cast<float>(row)));
        const ImVec2 end(at.x + font->CalcTextSizeA(size, FLT_MAX, 0.0F, code).x, at.y + size);
        const std::string target = target_of_line(line);
        if (widgets::IsCovered(target)) {
            widgets::DrawPlate(draw, at, {std::max(end.x, rect.max.x - margin), end.y});
        } else {
            draw->AddText(font, size, at, color_of(line), code);
            ImGui::SetCursorScreenPos(at);
            ImGui::Dummy({end.x - at.x, end.y - at.y});
            widgets::Record(code);
        }
        widgets::MarkTarget(target, at, end);
    }
}

}  // namespace viewing
