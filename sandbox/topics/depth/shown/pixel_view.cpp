#include "topics/depth/shown/pixel_view.h"

#include <algorithm>
#include <cmath>

#include "text/catalogue.h"
#include "topics/depth/shown/fragment_table.h"
#include "topics/depth/shown/pixel_numbers.h"
#include "topics/depth/shown/pixel_parts.h"
#include "topics/depth/shown/pixel_words.h"
#include "ui/parts/look.h"
#include "ui/parts/table_parts.h"
#include "ui/parts/view_window.h"

namespace viewing {
namespace {

struct ViewFonts {
    ImFont *text, *number;
};

ViewFonts fonts_of(bool is_large) {
    const widgets::Fonts& fonts = widgets::CurrentContext().fonts;
    return is_large ? ViewFonts{fonts.text, fonts.number} : ViewFonts{fonts.note, fonts.small_number};
}

/// Draws one number at the cursor: its name, its value and, if it fits, its unit.
void draw_number(const PixelNumber& number, const ViewFonts& fonts, float name_width, float width, float height) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImDrawList* draw = ImGui::GetWindowDrawList();
    ImGui::InvisibleButton(number.name.c_str(), {width, height});
    if (ImGui::IsItemHovered())
        draw->AddRectFilled({at.x - px(3.0F), at.y}, {at.x + width, at.y + height}, palette().field, px(3.0F));
    widgets::Record((number.name + ": " + number.value).c_str());
    widgets::Tooltip(number.title.c_str(), number.explanation.c_str(), number.formula.c_str());

    ImGui::PushFont(fonts.text);
    const float down = std::floor(0.5F * (height - ImGui::GetTextLineHeight()));
    widgets::Formula(draw, {at.x, at.y + down}, tr(number.name.c_str()), {}, palette().quiet, fonts.text);
    ImGui::PopFont();
    ImGui::PushFont(fonts.number);
    draw->AddText({at.x + name_width, at.y + down}, palette().text, number.value.c_str());
    const float end = name_width + ImGui::CalcTextSize(number.value.c_str()).x + px(6.0F);
    ImGui::PopFont();
    if (number.unit.empty() || end + width_of(number.unit, fonts.text) > width) return;
    ImGui::PushFont(fonts.text);
    draw->AddText({at.x + end, at.y + down}, palette().quiet, number.unit.c_str());
    ImGui::PopFont();
}

/// Draws the numbers, filling the first column and then the second. The last number, the world position, has its own
/// row, which small views omit when presenting. Leaves the cursor below the numbers. `lines_below`: of the table that
/// shares the height with them, or 0 if the numbers do not spread.
void draw_numbers(const std::vector<PixelNumber>& numbers, bool is_large, float width, int lines_below) {
    const ViewFonts fonts = fonts_of(is_large);
    ImGui::PushFont(fonts.text);
    const bool has_last = is_large || !widgets::HasPlainTitles();
    const bool in_two = !is_large && width >= px(320.0F);
    const std::size_t in_columns = numbers.size() - 1, rows = in_two ? (in_columns + 1) / 2 : in_columns;
    float height = ImGui::GetTextLineHeight() + px(is_large ? 5.0F : has_last ? 2.0F : 0.0F);
    if (lines_below > 0)
        height += 2.0F * (padding_to_fill(static_cast<int>(rows) + lines_below, ImGui::GetContentRegionAvail().y) -
                          px(cell_padding_y));
    ImGui::PopFont();
    const float gap = px(16.0F), each = in_two ? std::floor(0.5F * (width - gap)) : width;
    float widest = 0.0F;
    for (const PixelNumber& number : numbers) widest = std::max(widest, width_of(tr(number.name.c_str()), fonts.text));
    const float name_width = std::ceil(widest) + px(is_large ? 20.0F : 8.0F);
    const ImVec2 from = ImGui::GetCursorScreenPos();
    for (std::size_t i = 0; i < in_columns + (has_last ? 1 : 0); ++i) {
        const bool is_last = i == in_columns;
        const std::size_t row = is_last ? rows : i % rows, column = is_last ? 0 : i / rows;
        ImGui::SetCursorScreenPos(
            {from.x + static_cast<float>(column) * (each + gap), from.y + static_cast<float>(row) * height});
        draw_number(numbers[i], fonts, name_width, is_last ? width : each, height);
    }
    ImGui::SetCursorScreenPos({from.x, from.y + static_cast<float>(rows + (has_last ? 1 : 0)) * height + px(4.0F)});
}

/// Draws the surfaces along the pixel's ray. While the cell view is visible, the draw calls are known, so a click on a
/// fragment goes to the step that draws it.
void draw_fragments(Session& session, const DepthData& data, bool is_large) {
    if (data.fragments.empty()) return widgets::Note("This pixel's ray hits no surface.");
    const std::string on_click = data.calls.empty()
                                     ? std::string()
                                     : tr("Click to stop the frame after the triangle that produces this fragment.");
    const std::optional<std::size_t> clicked =
        draw_fragment_table(data.fragments, data.pixel->precision, session.scene(), is_large, on_click);
    if (!clicked || data.calls.empty()) return;
    if (const std::optional<DrawLimit> limit = limit_after(data.fragments[*clicked], data.calls)) {
        session.params.view.call = limit->call;
        session.params.view.triangle = limit->triangles;
    }
}

/// Hides the code width and the range of codes if a lesson covers them. Lessons use the same name for the code width
/// here and in the panel.
void cover(PixelNumber& number) {
    if (widgets::IsCovered("note:codes")) number.unit.clear();
    const bool is_step = number.name == "width Δz" || number.name == "eye Δz";
    if (!is_step || !widgets::IsCovered("note:depth_step")) return;
    number.value = " ?";
    number.formula.clear();
}

/// Draws the numbers and the surfaces: side by side if they fit, otherwise one below the other.
void draw_pixel(Session& session, const Derived& derived, const DepthData& data) {
    draw_pixel_headline(session.params.view, data.pixel->pixel, data.pixel->color, surface_words(*data.pixel));
    std::vector<PixelNumber> numbers = pixel_numbers(*data.pixel, session.params, derived);
    for (PixelNumber& number : numbers) cover(number);
    const ImVec2 from = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
    const bool beside = room.x >= px(760.0F), is_large = room.x >= px(900.0F);
    const float numbers_width = beside ? px(is_large ? 340.0F : 230.0F) : room.x;
    draw_numbers(numbers, is_large, numbers_width, beside ? 0 : static_cast<int>(data.fragments.size()) + 1);
    if (beside) {
        const float left = from.x + numbers_width + px(20.0F);
        ImGui::SetCursorScreenPos({left, from.y});
        ImGui::BeginChild("on the ray", {from.x + room.x - left, room.y});
        draw_fragments(session, data, is_large);
        ImGui::EndChild();
    } else {
        draw_fragments(session, data, is_large);
    }
}

}  // namespace

void draw_pixel_view(Session& session, const Derived& derived, const DepthData& data, const PinnedPixel& pinned,
                     const Rect& rect) {
    const ViewWindow view("pixel view", rect);
    const widgets::Group group("pixel");
    if (data.pixel) return draw_pixel(session, derived, data);
    if (pinned.why_none.empty())
        offer("Point at the camera view to see what a pixel stores; click to pin the pixel.");
    else if (offer(say(pinned.why_none).c_str(), "Release"))
        release_pixel(session.params.view);
}

}  // namespace viewing
