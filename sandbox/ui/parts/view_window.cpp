#include "ui/parts/view_window.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "text/catalogue.h"
#include "ui/parts/look.h"

namespace viewing {

ViewWindow::ViewWindow(const char* name, const Rect& rect, ImGuiWindowFlags flags)
    : never_scrolls_((flags & ImGuiWindowFlags_NoScrollbar) != 0),
      counted_before_(widgets::CurrentContext().scrolled_count) {
    ImGui::SetCursorScreenPos(rect.min);
    ImGui::PushStyleColor(ImGuiCol_ChildBg, palette().view_ground);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {px(8.0F), px(6.0F)});
    ImGui::BeginChild(name, {rect.width(), rect.height()}, false, flags | ImGuiWindowFlags_AlwaysUseWindowPadding);
    ImGui::PopStyleVar();
}

ViewWindow::~ViewWindow() {
    if (!never_scrolls_) widgets::CountScrolled(widgets::CurrentContext().scrolled_count > counted_before_);
    ImGui::EndChild();
    ImGui::PopStyleColor();
}

float note_height(const char* text, float width_px) {
    ImGui::PushFont(widgets::CurrentContext().fonts.note);
    const float width = std::max(1.0F, width_px > 0.0F ? width_px : ImGui::GetContentRegionAvail().x);
    const float height = ImGui::CalcTextSize(widgets::BrokenAtBlanks(text, width).c_str(), nullptr, false, width).y;
    ImGui::PopFont();
    return height;
}

void recorded_note(const std::string& sentence) {
    if (sentence.empty()) return;
    widgets::Note(sentence.c_str());
    widgets::Record(sentence.c_str());
}

bool offer(const char* english, const char* button) {
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const float width = std::max(std::min(room.x, px(360.0F)), 1.0F);
    const std::string sentence = widgets::BrokenAtBlanks(tr(english), width);
    const ImVec2 size = ImGui::CalcTextSize(sentence.c_str(), nullptr, false, width);
    const float button_height = button ? ImGui::GetFrameHeight() + px(8.0F) : 0.0F;
    const float top = from.y + std::floor(std::max(0.0F, (room.y - size.y - button_height) * 0.5F));
    const auto centered = [&](float item) { return from.x + std::floor(std::max(0.0F, (room.x - item) * 0.5F)); };

    ImGui::SetCursorScreenPos({centered(size.x), top});
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + size.x + 1.0F);
    ImGui::PushStyleColor(ImGuiCol_Text, palette().quiet);
    ImGui::TextUnformatted(sentence.c_str());
    ImGui::PopStyleColor();
    ImGui::PopTextWrapPos();
    widgets::Record(english);
    widgets::CurrentContext().offered = tr(english);
    if (!button) return false;
    const float button_width = ImGui::CalcTextSize(tr(button)).x + 2.0F * ImGui::GetStyle().FramePadding.x;
    ImGui::SetCursorScreenPos({centered(button_width), top + size.y + px(8.0F)});
    // The view has no other content, so show the button even when presenting.
    auto offered = std::exchange(widgets::CurrentContext().targets.offered, std::nullopt);
    const bool pressed = widgets::Button(button);
    widgets::CurrentContext().targets.offered = std::move(offered);
    return pressed;
}

}  // namespace viewing
