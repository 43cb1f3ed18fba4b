#include "ui/panel/section_links.h"

#include <array>

#include "ui/parts/look.h"
#include "ui/parts/table_parts.h"

namespace viewing {

float SectionLinks::height_px(const Rect& panel) const {
    if (content_px_ <= panel.height()) return 0.0F;
    // Count only the sections that are out of view when the panel is scrolled to the top, so that the panel keeps its
    // height while it scrolls.
    const float bottom = panel.height() - 2.0F * line_px_, width = panel.width() - px(16.0F);
    float x = 0.0F;
    int lines = 1;
    for (const Link& link : links_) {
        if (link.place.top_px < bottom) continue;
        if (x + link.width_px > width && x > 0.0F) {
            ++lines;
            x = 0.0F;
        }
        x += link.width_px;
    }
    return static_cast<float>(lines) * line_px_ + px(4.0F);
}

void SectionLinks::note() {
    ImFont* const font = widgets::CurrentContext().fonts.note;
    const auto measures = [this] {
        float width_px = 0.0F;
        for (const Link& link : links_) width_px += link.width_px;
        return std::array{width_px, content_px_, line_px_};
    };
    const std::array before = measures();
    links_.clear();
    for (const widgets::SectionPlace& place : widgets::CurrentContext().sections)
        links_.push_back({place, width_of(place.shown, font) + px(20.0F)});
    content_px_ = ImGui::GetCursorPosY();
    scroll_px_ = ImGui::GetScrollY();
    seen_px_ = ImGui::GetWindowHeight();
    line_px_ = font->FontSize + px(8.0F);
    if (measures() != before) widgets::AskForRedraw(0.0F);  // the next frame's layout may differ
}

void SectionLinks::draw() const {
    const widgets::Group group("sections");
    const widgets::Context& context = widgets::CurrentContext();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, bottom = corner.y + ImGui::GetContentRegionAvail().y + 1.0F;
    ImVec2 at = corner;
    for (const auto& [place, needed] : links_) {
        const bool is_below = place.top_px + ImGui::GetFrameHeight() > scroll_px_ + seen_px_;
        if (!is_below && place.top_px >= scroll_px_) continue;
        if (at.x + needed > corner.x + width && at.x > corner.x) at = {corner.x, at.y + line_px_};
        if (at.y + line_px_ > bottom) return;
        ImGui::SetCursorScreenPos(at);
        if (ImGui::InvisibleButton(place.label.c_str(), {needed, line_px_})) {
            widgets::CurrentContext().section_asked = place.label;
            widgets::AskForRedraw(0.0F);
        }
        const ImU32 color = ImGui::IsItemHovered() ? context.palette.text : context.palette.accent;
        widgets::Record(place.label.c_str(), place.shown);
        const float half = px(3.5F), x = at.x + px(6.0F), y = at.y + 0.5F * line_px_;
        const float tip = is_below ? half : -half;
        ImGui::GetWindowDrawList()->AddTriangleFilled({x - half, y - 0.6F * tip}, {x, y + 0.6F * tip},
                                                      {x + half, y - 0.6F * tip}, color);
        ImFont* const font = context.fonts.note;
        ImGui::GetWindowDrawList()->AddText(font, font->FontSize, {at.x + px(13.0F), at.y + px(4.0F)}, color,
                                            place.shown.c_str());
        at.x += needed;
    }
}

}  // namespace viewing
