#include "topics/depth/shown/pixel_parts.h"

#include <algorithm>
#include <cmath>

#include "text/catalogue.h"
#include "ui/parts/look.h"
#include "ui/parts/table_parts.h"

namespace viewing {
namespace {

constexpr const char* follows = marked("follows the pointer; click to pin a pixel");

bool is_pinned(const ViewParams& view) {
    return view.pixel || view.pin;
}

/// Draws text on the header line, vertically centered.
void headline_text(const std::string& text, ImFont* font, ImU32 color) {
    ImGui::PushFont(font);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float height = px(20.0F), down = std::floor(0.5F * (height - ImGui::GetTextLineHeight()));
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    ImGui::GetWindowDrawList()->AddText({at.x, at.y + down}, color, text.c_str());
    ImGui::Dummy({size.x, height});
    widgets::Record(text.c_str());
    ImGui::PopFont();
}

void color_swatch(const Color& color) {
    const float side = px(14.0F);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 min(at.x, at.y + px(3.0F)), max(min.x + side, min.y + side);
    ImGui::GetWindowDrawList()->AddRectFilled(min, max, IM_COL32(color.r, color.g, color.b, 255), px(2.0F));
    ImGui::GetWindowDrawList()->AddRect(min, max, palette().border, px(2.0F));
    ImGui::Dummy({side, px(20.0F)});
}

/// At the right end of the header line, draws a button that releases the pin or, if nothing is pinned, a note that the
/// view follows the pointer. `room`: the width in pixels that the note may take.
void pin_state(ViewParams& view, float right, float room) {
    if (is_pinned(view)) {
        const float width = ImGui::CalcTextSize(tr("Release")).x + 2.0F * px(8.0F);
        ImGui::SameLine();
        ImGui::SetCursorScreenPos({right - width, ImGui::GetCursorScreenPos().y});
        if (widgets::SmallButton("Release")) release_pixel(view);
        widgets::Tooltip("Release", "Releases the pinned pixel: this view follows the pointer again.");
        return;
    }
    ImFont* font = widgets::CurrentContext().fonts.note;
    const char* text = width_of(tr(follows), font) <= room ? tr(follows) : tr("live");
    ImGui::SameLine();
    ImGui::SetCursorScreenPos({right - width_of(text, font), ImGui::GetCursorScreenPos().y});
    headline_text(text, font, palette().quiet);
    widgets::Tooltip("Live", "This view follows the pointer. Click the camera view to pin a pixel.");
}

}  // namespace

void release_pixel(ViewParams& view) {
    view.pixel.reset();
    view.pin.reset();
}

void draw_pixel_headline(ViewParams& view, glm::ivec2 pixel, const Color& color, const std::string& surface) {
    const widgets::Fonts& fonts = widgets::CurrentContext().fonts;
    const float left = ImGui::GetCursorScreenPos().x, right = left + ImGui::GetContentRegionAvail().x;
    const std::string place = say("pixel ({x}, {y})", "x"_a = pixel.x, "y"_a = pixel.y);
    const std::string hex = hex_color(color.r, color.g, color.b);
    const float state_width =
        std::max(width_of(tr("Release"), fonts.text) + px(16.0F), width_of(tr("live"), fonts.note));

    color_swatch(color);
    ImGui::SameLine(0.0F, px(7.0F));
    headline_text(place, fonts.text, palette().text);
    ImGui::SameLine(0.0F, px(10.0F));
    const float wanted = width_of(surface, fonts.text), hex_width = width_of(hex, fonts.small_number);
    const auto fits = [&](float width) { return ImGui::GetCursorScreenPos().x + width + state_width <= right; };
    // When presenting, the surface matters more than the hex color.
    const bool has_hex = fits(hex_width) && !(widgets::HasPlainTitles() && !fits(hex_width + wanted + px(18.0F)));
    if (has_hex) {
        headline_text(hex, fonts.small_number, palette().quiet);
        ImGui::SameLine(0.0F, px(10.0F));
    }
    const float here = ImGui::GetCursorScreenPos().x;
    const bool on_this_line = !surface.empty() && (has_hex || widgets::HasPlainTitles()) && fits(wanted + px(8.0F));
    if (on_this_line) headline_text(surface, fonts.text, palette().text);
    pin_state(view, right, right - here - (on_this_line ? wanted : 0.0F) - px(16.0F));
    if (on_this_line || surface.empty()) return;
    ImGui::PushFont(fonts.text);
    const std::string shown = widgets::Shortened(surface, right - left);
    ImGui::PopFont();
    headline_text(shown, fonts.text, palette().text);
}

}  // namespace viewing
