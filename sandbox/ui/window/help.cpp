#include "ui/window/help.h"

#include <imgui.h>

#include "text/catalogue.h"
#include "ui/parts/look.h"
#include "ui/window/dialogs.h"
#include "ui/window/window_commands.h"
#include "widgets/widgets.h"

namespace viewing {
namespace {

/// Draws a line of the list: keys, and what they do.
void draw_line(const std::string& keys, const char* what) {
    widgets::ValueText(keys.c_str(), widgets::Role::camera);
    ImGui::SameLine(px(240.0F));
    ImGui::TextUnformatted(tr(what));
}

void draw_keys() {
    struct Line {
        const char* keys;
        const char* what;
    };
    static constexpr Line of_camera[] = {
        {"W S", marked("forward, back")},
        {"A D", marked("strafe left, right (fly) · turn (orbit)")},
        {"R F", marked("up, down (fly)")},
        {"← → ↑ ↓", marked("turn and look (walk: pan only)")},
        {"Q E", marked("roll (fly)")},
        {"Shift", marked("slow")},
        {marked("mouse drag"), marked("look · orbit")},
        {marked("right drag"), marked("look · pan (orbit); more in the Look menu")},
        {marked("middle drag"), marked("orbit about the point there; Shift: pan")},
        {marked("wheel"), marked("nearer, farther; Ctrl: speed (fly, walk)")},
        {marked("click"), marked("follow the nearest vertex; on the background: stop following")},
        {marked("right click"), marked("why this pixel? Touch screen: touch and hold it")},
        {marked("drag a number"), marked("change it; Shift ×10, Alt ÷100")},
        {marked("double-click it"), marked("type; right-click resets")},
    };
    // Use tight line spacing, so that all lines are visible at once in a window of 1280 × 720.
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, px(1.0F)});
    for (const Line& line : of_camera) draw_line(tr(line.keys), line.what);
    ImGui::Dummy({0.0F, px(4.0F)});
    const std::span<const WindowCommand> commands = window_commands();
    for (std::size_t i = 0; i < commands.size();) {
        const char* const what = commands[i].help;
        std::string keys = key_text(commands[i].key);
        while (++i < commands.size() && commands[i].help && *commands[i].help == '\0')
            keys += "  " + key_text(commands[i].key);
        if (what) draw_line(keys, what);
    }
    ImGui::PopStyleVar();
}

/// Draws a table's rows, starting at `first`, with one column per cell. Returns the index of the first block after the
/// table.
std::size_t draw_table(const std::vector<ManualBlock>& blocks, std::size_t first) {
    std::size_t end = first;
    while (end < blocks.size() && blocks[end].part == ManualPart::row) ++end;
    if (!ImGui::BeginTable(std::to_string(first).c_str(), static_cast<int>(blocks[first].cells.size()),
                           ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_SizingStretchProp))
        return end;
    for (std::size_t row = first; row < end; ++row)
        for (const std::string& cell : blocks[row].cells) {
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(cell.c_str());
        }
    ImGui::EndTable();
    return end;
}

/// Draws a line of code in text small enough for 100 characters; a longer line wraps.
void draw_code(const std::string& line) {
    ImGui::PushFont(widgets::CurrentContext().fonts.small_number);
    ImGui::TextUnformatted(line.empty() ? " " : line.c_str());
    ImGui::PopFont();
}

void draw_topic(const std::vector<ManualBlock>& blocks) {
    for (std::size_t i = 0; i < blocks.size();) {
        const ManualBlock& block = blocks[i];
        const bool follows_code = i > 0 && blocks[i - 1].part == ManualPart::code;
        if (i > 0 && !(follows_code && block.part == ManualPart::code)) ImGui::Dummy({0.0F, px(3.0F)});
        if (block.part == ManualPart::row) {
            i = draw_table(blocks, i);
            continue;
        }
        const std::string& text = block.cells.front();
        if (block.part == ManualPart::heading) {
            dialog_title(text.c_str());
            widgets::Record(text.c_str());
        } else if (block.part == ManualPart::code) {
            draw_code(text);
        } else {
            ImGui::TextUnformatted(text.c_str());
        }
        ++i;
    }
}

}  // namespace

void HelpDialog::draw() {
    const widgets::Group group("keys");
    if (is_open_) ImGui::OpenPopup("keys");
    if (!begin_dialog("keys", {px(960.0F), px(700.0F)})) return;
    if (topics_.empty())
        for (const char* name : manual_topics()) topics_.push_back(manual_topic(name));
    const float above_close = -ImGui::GetFrameHeightWithSpacing() - px(4.0F);
    ImGui::BeginChild("topics", {px(170.0F), above_close});
    for (std::size_t page = 0; page <= topics_.size(); ++page) {
        const char* name = page == 0 ? tr("Keys") : topics_[page - 1].front().cells.front().c_str();
        if (ImGui::Selectable(name, page == page_, ImGuiSelectableFlags_DontClosePopups)) page_ = page;
        widgets::Record(name);
    }
    ImGui::EndChild();
    ImGui::SameLine();
    ImGui::PushID(static_cast<int>(page_));  // each page has its own scroll position
    ImGui::BeginChild("page", {0.0F, above_close});
    ImGui::PushTextWrapPos(0.0F);
    if (page_ == 0)
        draw_keys();
    else
        draw_topic(topics_[page_ - 1]);
    ImGui::PopTextWrapPos();
    ImGui::EndChild();
    ImGui::PopID();
    if (widgets::Button("Close") || !is_open_ || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) {
        is_open_ = false;
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

}  // namespace viewing
