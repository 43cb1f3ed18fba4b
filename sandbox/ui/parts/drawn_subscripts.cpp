#include "ui/parts/drawn_subscripts.h"

#include <algorithm>
#include <string_view>

#include "text/subscripts.h"

namespace viewing {

ImVec2 draw_with_subscripts(ImDrawList* draw, ImFont* font, ImVec2 corner, ImU32 color, const std::string& lines) {
    constexpr float small = 0.78F, lowered_by = 0.36F;  // in line heights
    const float size = font->FontSize;
    ImVec2 all;
    for (std::size_t begin = 0; begin <= lines.size();) {
        const std::size_t end = std::min(lines.find('\n', begin), lines.size());
        float x = corner.x;
        for (const TextPart& part : subscript_parts(std::string_view(lines).substr(begin, end - begin))) {
            const char* const first = part.text.data();
            const char* const last = first + part.text.size();
            const float part_size = part.is_lowered ? size * small : size;
            const float y = corner.y + all.y + (part.is_lowered ? size * lowered_by : 0.0F);
            draw->AddText(font, part_size, {x, y}, color, first, last);
            x += font->CalcTextSizeA(part_size, FLT_MAX, 0.0F, first, last).x;
        }
        all = {std::max(all.x, x - corner.x), all.y + size};
        begin = end + 1;
    }
    return all;
}

void text_with_subscripts(const std::string& lines, float base) {
    if (subscript_parts(lines).size() < 2) return ImGui::TextUnformatted(lines.c_str());
    const ImVec2 cursor = ImGui::GetCursorScreenPos();
    const ImVec2 size = draw_with_subscripts(ImGui::GetWindowDrawList(), ImGui::GetFont(), {cursor.x, cursor.y + base},
                                             ImGui::GetColorU32(ImGuiCol_Text), lines);
    ImGui::Dummy({size.x, size.y + base});
}

}  // namespace viewing
