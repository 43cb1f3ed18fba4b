#include "ui/window/preset_picker.h"

#include <imgui.h>
//

#include <algorithm>

#include "state/slides.h"
#include "text/catalogue.h"
#include "text/words.h"
#include "ui/parts/look.h"
#include "ui/parts/view_parts.h"
#include "ui/window/search_entries.h"

namespace viewing {
namespace {

bool is_pressed(ImGuiKey key) {
    return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key));
}

std::ptrdiff_t place_of(const std::vector<const NamedFile*>& found, const std::string& name) {
    return std::find_if(found.begin(), found.end(), [&](const NamedFile* one) { return one->name == name; }) -
           found.begin();
}

std::vector<const NamedFile*> found_by(std::span<const NamedFile> presets, const std::string& search) {
    std::vector<const NamedFile*> found;
    for (const NamedFile& preset : presets)
        if (is_found(preset, search)) found.push_back(&preset);
    return found;
}

/// Returns the first preset whose title alone matches or, if there is none, the first preset. `found` must not be
/// empty.
const NamedFile& best_of(const std::vector<const NamedFile*>& found, const std::string& search) {
    const auto best = std::find_if(found.begin(), found.end(), [&](const NamedFile* preset) {
        NamedFile only_titled;
        only_titled.title = preset->title;
        return is_found(only_titled, search);
    });
    return best == found.end() ? *found.front() : **best;
}

/// Draws the marked preset's picture and text beside the list.
void draw_beside(const NamedFile* preset, const PresetPicture& picture) {
    if (!preset) return;
    const float width = ImGui::GetContentRegionAvail().x, height = std::round(width * 9.0F / 16.0F);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const Rect rect{at, {at.x + width, at.y + height}};
    ImGui::GetWindowDrawList()->AddRectFilled(rect.min, rect.max, palette().view_ground, px(3.0F));
    if (picture.name == preset->name) draw_picture(rect, picture.texture);
    ImGui::Dummy({width, height});
    widgets::Record("picture");
    ImGui::PushTextWrapPos(0.0F);
    ImGui::PushFont(widgets::CurrentContext().fonts.heading);
    ImGui::TextUnformatted(widgets::BrokenAtBlanks(tr(preset->title.c_str()), width).c_str());
    ImGui::PopFont();
    ImGui::TextUnformatted(widgets::BrokenAtBlanks(tr(preset->about.c_str()), width).c_str());
    widgets::Record("about");
    ImGui::PushStyleColor(ImGuiCol_Text, palette().quiet);
    ImGui::PushFont(widgets::CurrentContext().fonts.small_number);
    ImGui::TextUnformatted(preset->name.c_str());
    ImGui::PopFont();
    ImGui::PopStyleColor();
    ImGui::PopTextWrapPos();
}

}  // namespace

bool is_found(const NamedFile& preset, std::string_view search) {
    if (const std::optional<int> slide = searched_slide(search))
        return std::find(preset.slides.begin(), preset.slides.end(), *slide) != preset.slides.end();
    std::string all = preset.name;
    for (const std::string* text : {&preset.title, &preset.about, &preset.group})
        all.append("\n").append(*text).append("\n").append(tr(text->c_str()));
    return contains_words(in_lower_case(std::move(all)), search);
}

const NamedFile* PresetPicker::at(const Session& session, int places) const {
    // A preset that is loading counts as open, so that pressing Page down twice advances by two.
    const OpenPreset* const open = session.preset();
    const std::string name = !session.opening().empty() ? session.opening() : open ? open->name : "";
    const auto at =
        std::find_if(all_.begin(), all_.end(), [&](const NamedFile& preset) { return preset.name == name; });
    // Without an open preset, the first one is next.
    std::ptrdiff_t place = at == all_.end() ? places - 1 : at - all_.begin() + places;
    const auto preset = [&]() -> const NamedFile* {
        return place >= 0 && place < std::ssize(all_) ? &all_[place] : nullptr;
    };
    if (places != 0)
        while (preset() && preset()->sets_looks) place += places;
    return preset();
}

bool PresetPicker::draw_search(const std::vector<const NamedFile*>& found) {
    ImGui::SetNextItemWidth(-1.0F);
    const bool entered = widgets::TextField("##search", search_, tr("search"), ImGuiInputTextFlags_EnterReturnsTrue);
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere(-1);
    widgets::Record("search");
    const int step = (is_pressed(ImGuiKey_DownArrow) ? 1 : 0) - (is_pressed(ImGuiKey_UpArrow) ? 1 : 0);
    const auto count = static_cast<std::ptrdiff_t>(found.size());
    if (step != 0 && count > 0)
        marked_ = found[std::clamp(place_of(found, marked_) + step, std::ptrdiff_t{0}, count - 1)]->name;
    return entered;
}

const NamedFile* PresetPicker::draw_list(const std::vector<const NamedFile*>& found, const NamedFile* current,
                                         bool scroll) {
    const NamedFile* chosen = nullptr;
    const ImVec2 moved = ImGui::GetIO().MouseDelta;
    std::string heading;
    for (const NamedFile* preset : found) {
        if (std::string own = slide_heading(preset->slides); !own.empty() && own != heading) {
            heading = std::move(own);
            ImGui::Dummy({0.0F, px(3.0F)});
            ImGui::PushFont(widgets::CurrentContext().fonts.heading);
            ImGui::TextDisabled("%s", heading.c_str());
            ImGui::PopFont();
        }
        if (preset == current) {
            const ImVec2 at = ImGui::GetCursorScreenPos();
            ImGui::GetWindowDrawList()->AddText(at, palette().accent, "✓");
        }
        ImGui::SetCursorPosX(ImGui::GetCursorPosX() + px(18.0F));
        const std::string row = widgets::BrokenLabelText((preset->title + "##" + preset->name).c_str(), px(2.0F));
        if (ImGui::Selectable(row.c_str(), preset->name == marked_)) chosen = preset;
        widgets::Record(preset->name.c_str());
        if (ImGui::IsItemHovered() && (moved.x != 0.0F || moved.y != 0.0F)) marked_ = preset->name;
        if (scroll && preset->name == marked_) ImGui::SetScrollHereY(0.5F);
    }
    if (found.empty()) widgets::Note(marked("No preset contains all these words."));
    return chosen;
}

const NamedFile* PresetPicker::draw(const NamedFile* current, const std::string& shown, float width,
                                    const PresetPicture& picture) {
    is_open_ = false;
    wanted_picture_.clear();
    const bool clicked = widgets::ClosedList("##preset", shown.c_str(), width);
    widgets::Tooltip("Presets",
                     "Complete states in the order of the lecture. Page down and Page up go to the next and "
                     "the previous one.");
    const ImVec2 corner(ImGui::GetItemRectMin().x, ImGui::GetItemRectMax().y + px(2.0F));
    if (clicked) {
        search_.clear();
        marked_ = current ? current->name : all_.empty() ? "" : all_.front().name;
        ImGui::OpenPopup("presets");
    }
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const ImVec2 size(std::min(px(720.0F), window.x - px(16.0F)),
                      std::min(px(560.0F), window.y - corner.y - px(10.0F)));
    ImGui::SetNextWindowPos({std::min(corner.x, window.x - size.x - px(8.0F)), corner.y});
    ImGui::SetNextWindowSizeConstraints(size, size);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {px(10.0F), px(10.0F)});
    const bool is_open = ImGui::BeginPopup("presets", ImGuiWindowFlags_NoMove);
    ImGui::PopStyleVar();
    if (!is_open) return nullptr;
    is_open_ = true;

    std::vector<const NamedFile*> found = found_by(all_, search_);
    const std::string marked_before = marked_, search_before = search_;
    const float list_width = std::floor(size.x * 0.46F);
    ImGui::BeginChild("left", {list_width, 0.0F});
    const bool entered = draw_search(found);
    if (search_ != search_before) found = found_by(all_, search_);
    const bool is_lost = place_of(found, marked_) == static_cast<std::ptrdiff_t>(found.size());
    if (!found.empty() && (is_lost || search_ != search_before)) marked_ = best_of(found, search_).name;
    const bool scroll = clicked || marked_ != marked_before || ImGui::IsWindowAppearing();
    ImGui::BeginChild("list", {0.0F, 0.0F});
    const NamedFile* chosen = draw_list(found, current, scroll);
    ImGui::EndChild();
    ImGui::EndChild();

    const std::ptrdiff_t place = place_of(found, marked_);
    const NamedFile* marked = found.empty() ? nullptr : found[place];
    if (entered) chosen = marked;
    if (marked) wanted_picture_ = marked->name;
    ImGui::SameLine(0.0F, px(12.0F));
    ImGui::BeginChild("beside");
    draw_beside(marked, picture);
    ImGui::EndChild();
    if (chosen || is_pressed(ImGuiKey_Escape)) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    return chosen;
}

}  // namespace viewing
