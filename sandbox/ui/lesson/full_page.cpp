#include "ui/lesson/full_page.h"

#include <algorithm>

#include "text/catalogue.h"
#include "ui/parts/look.h"

namespace viewing {

Page::Page(const char* name) {
    ImGui::SetNextWindowPos({0.0F, 0.0F});
    ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
    if (!ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup)) ImGui::SetNextWindowFocus();  // an open search stays on top
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {px(page_margin), px(22.0F)});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, palette().ground);
    ImGui::Begin(name, nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
}

Page::~Page() {
    ImGui::End();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
}

void page_heading(const std::string& text, const char* label, float room) {
    const widgets::Context& context = widgets::CurrentContext();
    paragraph(text, context.fonts.caption, ImGui::GetContentRegionAvail().x - px(room)).draw(label, palette().text);
}

bool button_at_right(const char* label) {
    const float width = ImGui::CalcTextSize(tr(label)).x + 2.0F * ImGui::GetStyle().FramePadding.x;
    ImGui::SameLine(ImGui::GetContentRegionMax().x - width);
    return widgets::Button(label);
}

ImTextureID texture_in(const Pictures& pictures, const std::string& key) {
    const auto at = std::find_if(pictures.cards.begin(), pictures.cards.end(),
                                 [&](const PresetPicture& picture) { return picture.name == key; });
    return at == pictures.cards.end() ? nullptr : at->texture;
}

}  // namespace viewing
