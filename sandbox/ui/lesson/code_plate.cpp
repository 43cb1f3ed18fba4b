#include "ui/lesson/code_plate.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "image/qr_code.h"
#include "ui/lesson/lesson_text.h"
#include "ui/parts/look.h"

namespace viewing {
namespace {

/// Breaks an address, which has no spaces, into lines of at most `width` pixels.
std::vector<std::string> address_lines(const std::string& address, const ImFont& font, float width) {
    std::vector<std::string> lines;
    const char* const end = address.c_str() + address.size();
    for (const char* begin = address.c_str(); begin < end;) {
        const char* remaining = begin;
        font.CalcTextSizeA(font.FontSize, width, 0.0F, begin, end, &remaining);
        remaining = std::max(remaining, begin + 1);
        lines.emplace_back(begin, remaining);
        begin = remaining;
    }
    return lines;
}

/// Draws each run of dark modules in a row as one rectangle: blending could leave seams between separate rectangles.
void draw_modules(ImDrawList& draw, const QrCode& code, ImVec2 corner, float module_px) {
    for (int row = 0; row < code.modules; ++row)
        for (int column = 0; column < code.modules;) {
            int end = column;
            while (end < code.modules && code.is_dark(row, end)) ++end;
            const float y = corner.y + static_cast<float>(row) * module_px;
            if (end > column)
                draw.AddRectFilled({corner.x + static_cast<float>(column) * module_px, y},
                                   {corner.x + static_cast<float>(end) * module_px, y + module_px}, IM_COL32_BLACK);
            column = end + 1;
        }
}

void draw_sentence(const std::string& sentence, const Rect& room) {
    ImFont* const font = widgets::CurrentContext().fonts.caption;
    const float margin = font->FontSize, width = std::min(room.width(), font->FontSize * 30.0F);
    const Paragraph text = paragraph(sentence, font, width - 2.0F * margin);
    const ImVec2 min(std::floor((room.min.x + room.max.x - width) * 0.5F),
                     std::floor((room.min.y + room.max.y - text.height) * 0.5F - margin));
    ImDrawList* const draw = ImGui::GetForegroundDrawList();
    const ImVec2 max(min.x + width, min.y + text.height + 2.0F * margin);
    draw->AddRectFilled(min, max, palette().raised, px(6.0F));
    draw->AddRect(min, max, palette().border, px(6.0F), 0, px(1.5F));
    draw->AddText(font, font->FontSize, {min.x + margin, min.y + margin}, palette().text, text.lines.c_str());
}

}  // namespace

void draw_code_plate(const Result<std::string>& link, const std::string& address, const Rect& room) {
    if (!link) return draw_sentence(link.error(), room);
    const Result<QrCode> code = qr_code(*link);
    if (!code) return draw_sentence(code.error(), room);

    const float third = ImGui::GetIO().DisplaySize.y / 3.0F;
    const float module_px = std::ceil(third / static_cast<float>(code->modules));
    const float side = module_px * static_cast<float>(code->modules + 2 * QrCode::quiet_modules);
    const ImFont& font = *widgets::CurrentContext().fonts.caption;
    const float margin = std::floor(font.FontSize * 0.5F);
    const float widest = std::max(side, std::min(room.width(), font.FontSize * 34.0F)) - 2.0F * margin;
    constexpr std::size_t most_lines = 3;
    std::vector<std::string> lines = address_lines(*link, font, widest);
    if (lines.size() > most_lines) lines = address_lines(address + " …", font, widest);
    float width = side;
    for (const std::string& line : lines)
        width = std::max(width,
                         std::ceil(font.CalcTextSizeA(font.FontSize, FLT_MAX, 0.0F, line.c_str()).x) + 2.0F * margin);
    const float height = side + font.FontSize * static_cast<float>(lines.size()) + margin;
    const float middle = (room.min.x + room.max.x) * 0.5F;
    const ImVec2 min(std::floor(middle - width * 0.5F),
                     std::max(std::floor((room.min.y + room.max.y - height) * 0.5F), 0.0F));
    ImDrawList* const draw = ImGui::GetForegroundDrawList();
    draw->AddRectFilled(min, {min.x + width, min.y + height}, IM_COL32_WHITE);
    const float quiet = module_px * static_cast<float>(QrCode::quiet_modules);
    draw_modules(*draw, *code, {std::floor(middle - side * 0.5F) + quiet, min.y + quiet}, module_px);
    float y = min.y + side;
    for (const std::string& line : lines) {
        const float line_width = font.CalcTextSizeA(font.FontSize, FLT_MAX, 0.0F, line.c_str()).x;
        draw->AddText(&font, font.FontSize, {std::floor(middle - line_width * 0.5F), y}, IM_COL32_BLACK, line.c_str());
        y += font.FontSize;
    }
}

}  // namespace viewing
