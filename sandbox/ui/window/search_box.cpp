#include "ui/window/search_box.h"

#include <imgui.h>
//

#include <algorithm>
#include <cmath>
#include <utility>

#include "text/catalogue.h"
#include "text/words.h"
#include "ui/parts/look.h"
#include "widgets/widgets.h"

namespace viewing {
namespace {

constexpr std::size_t most_rows = 12;

bool is_key_pressed(ImGuiKey key) {
    return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key));
}

/// Returns the width of the left column, which fits the longest name of a kind.
float width_of_kinds() {
    float width = 0.0F;
    for (int kind = 0; kind <= static_cast<int>(EntryKind::exercise); ++kind)
        width = std::max(width, ImGui::CalcTextSize(tr(name_of_kind(static_cast<EntryKind>(kind)))).x);
    return width + px(14.0F);
}

/// Draws a row: its kind, its title, and, at the right, its note. Returns whether it was clicked.
bool draw_row(const SearchEntry& entry, std::size_t place, bool is_marked, float kinds) {
    const float width = ImGui::GetContentRegionAvail().x, height = ImGui::GetTextLineHeight() + px(8.0F);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::PushID(static_cast<int>(place));
    const bool clicked = ImGui::Selectable("##row", is_marked, 0, {width, height});
    ImGui::PopID();
    const float most_note = 0.42F * width;
    const std::string note = widgets::Shortened(entry.note, most_note);
    const float note_width = ImGui::CalcTextSize(note.c_str()).x, inset = px(6.0F);
    const std::string title = widgets::Shortened(entry.title, width - kinds - note_width - inset - px(16.0F));
    ImDrawList* const draw = ImGui::GetWindowDrawList();
    const float top = std::round(at.y + px(4.0F));
    draw->AddText({at.x + inset, top}, palette().quiet, tr(name_of_kind(entry.kind)));
    draw->AddText({at.x + inset + kinds, top}, palette().text, title.c_str());
    draw->AddText({at.x + width - inset - note_width, top}, palette().quiet, note.c_str());
    widgets::Record(("row " + std::to_string(place + 1)).c_str(), entry.title + " | " + entry.note);
    return clicked;
}

}  // namespace

std::optional<SearchChoice> SearchBox::draw(const std::function<std::vector<SearchEntry>()>& offered) {
    const widgets::Group group("search");
    if (std::exchange(requested_, false)) {
        typed_.clear();
        entries_ = offered();
        found_ = found(entries_, typed_, most_rows);
        marked_ = 0;
        takes_focus_ = true;
        ImGui::OpenPopup("search");
    }
    const widgets::Context& context = widgets::CurrentContext();
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const float width = std::min(px(780.0F), window.x - px(16.0F));
    ImGui::SetNextWindowPos({window.x * 0.5F, std::min(px(48.0F), 0.06F * window.y)}, ImGuiCond_Always, {0.5F, 0.0F});
    ImGui::SetNextWindowSize({width, 0.0F});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {px(10.0F), px(10.0F)});
    is_open_ = ImGui::BeginPopup("search", ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoScrollbar);
    ImGui::PopStyleVar();
    if (!is_open_) {
        entries_.clear();
        return std::nullopt;
    }
    ImGui::PushFont(context.is_on_stage ? context.fonts.caption : context.fonts.text);
    const std::string before = typed_;
    ImGui::SetNextItemWidth(-1.0F);
    if (std::exchange(takes_focus_, false)) ImGui::SetKeyboardFocusHere();
    const bool entered =
        widgets::TextField("##text", typed_, tr("a name, a word from a question, or a setting: near 0.01"),
                           ImGuiInputTextFlags_EnterReturnsTrue, &continues_);
    widgets::Record("text");
    if (typed_ != before) {
        found_ = found(entries_, typed_, most_rows);
        marked_ = 0;
    }
    const int step = (is_key_pressed(ImGuiKey_DownArrow) ? 1 : 0) - (is_key_pressed(ImGuiKey_UpArrow) ? 1 : 0);
    marked_ = std::clamp(marked_ + step, 0, std::max(0, static_cast<int>(found_.size()) - 1));

    std::optional<SearchEntry> chosen;
    const float kinds = width_of_kinds();
    const ImVec2 moved = ImGui::GetIO().MouseDelta;
    for (std::size_t i = 0; i < found_.size(); ++i) {
        if (draw_row(found_[i], i, static_cast<int>(i) == marked_, kinds)) chosen = found_[i];
        if (ImGui::IsItemHovered() && (moved.x != 0.0F || moved.y != 0.0F)) marked_ = static_cast<int>(i);
    }
    if (found_.empty()) widgets::Note(marked("No entry contains these words."));
    ImGui::PopFont();
    if (entered && !found_.empty()) chosen = found_[marked_];

    // A setting without a value stays in the field, so that the user can type its value next.
    const auto* const setting = chosen ? std::get_if<FieldChoice>(&chosen->choice) : nullptr;
    if (setting && setting->setting.empty()) {
        typed_ = std::string(setting->path) + " ";
        found_ = found(entries_, typed_, most_rows);
        takes_focus_ = continues_ = true;
        chosen.reset();
    }
    if (chosen || is_key_pressed(ImGuiKey_Escape)) {
        ImGui::CloseCurrentPopup();
        is_open_ = false;  // the next frame's keys no longer go to the text field
    }
    ImGui::EndPopup();
    return chosen ? std::optional(chosen->choice) : std::nullopt;
}

}  // namespace viewing
