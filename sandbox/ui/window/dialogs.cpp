#include "ui/window/dialogs.h"
#include "text/catalogue.h"
#include "ui/parts/look.h"

#include <imgui.h>
//
#include <imgui_stdlib.h>

#include <algorithm>

#include "widgets/widgets.h"

namespace viewing {
namespace {

/// A popup in the middle of the window, as large as asked for where that fits.
bool begin_dialog(const char* name, ImVec2 size) {
    const ImGuiViewport& screen = *ImGui::GetMainViewport();
    const ImVec2 fitting(std::min(size.x, screen.Size.x - px(20.0F)), std::min(size.y, screen.Size.y - px(20.0F)));
    ImGui::SetNextWindowSize(fitting);
    ImGui::SetNextWindowPos({screen.Size.x * 0.5F, screen.Size.y * 0.5F}, ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {px(18.0F), px(14.0F)});
    const bool is_open = ImGui::BeginPopupModal(name, nullptr,
                                                ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                                    ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
    ImGui::PopStyleVar();
    return is_open;
}

void title(const char* text) {
    ImGui::PushFont(widgets::CurrentContext().fonts.heading);
    ImGui::TextUnformatted(tr(text));
    ImGui::PopFont();
}

bool is_known_file(const std::filesystem::path& file) {
    return file.extension() == ".json" || is_obj_file(file);
}

}  // namespace

void FileDialog::show(Purpose purpose) {
    purpose_ = purpose;
    requested_ = true;
    error_.clear();
    to_replace_.clear();
    std::error_code ignored;
    if (folder_.empty()) folder_ = std::filesystem::current_path(ignored);
    name_ = purpose == Purpose::save ? "state.json" : "";
    list_folder();
}

void FileDialog::list_folder() {
    entries_.clear();
    std::error_code failed;
    for (std::filesystem::directory_iterator at(folder_, failed), end; !failed && at != end; at.increment(failed)) {
        const std::string name = at->path().filename().string();
        std::error_code ignored;
        const bool is_folder = at->is_directory(ignored);
        if (name.starts_with('.') || (!is_folder && !is_known_file(at->path()))) continue;
        entries_.push_back({name, is_folder});
    }
    if (failed) error_ = folder_.string() + ": " + failed.message();
    std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
        return a.is_folder != b.is_folder ? a.is_folder : a.name < b.name;
    });
}

bool FileDialog::confirm(Session& session) {
    if (name_.empty()) return false;
    const std::filesystem::path file = folder_ / name_;
    std::error_code ignored;
    if (std::filesystem::is_directory(file, ignored)) {
        folder_ = file.lexically_normal();
        name_.clear();
        list_folder();
        return false;
    }
    if (purpose_ == Purpose::save && std::filesystem::exists(file, ignored) && to_replace_ != file) {
        to_replace_ = file;
        error_ = say("{file} exists: save once more to replace it", "file"_a = file.filename().string());
        return false;
    }
    const Status done = purpose_ == Purpose::open ? session.open(file.string()) : session.save(file);
    error_ = done ? "" : done.error();
    return static_cast<bool>(done);
}

void FileDialog::draw(Session& session) {
    const widgets::Group group("file");
    if (requested_) ImGui::OpenPopup("file");
    is_open_ = begin_dialog("file", {px(580.0F), px(440.0F)});
    if (!is_open_) return;
    takes_keyboard_ |= std::exchange(requested_, false);

    title(purpose_ == Purpose::open ? marked("Open a state (.json) or a mesh (.obj)") : marked("Save the state"));
    widgets::Note(folder_.string().c_str());
    const float below = ImGui::GetFrameHeightWithSpacing() * 2.0F + px(error_.empty() ? 8.0F : 44.0F);
    ImGui::BeginChild("entries", {0.0F, -below}, true);
    if (folder_.has_parent_path() && ImGui::Selectable("..", false, ImGuiSelectableFlags_DontClosePopups)) {
        folder_ = folder_.parent_path();
        list_folder();
    }
    bool chosen = false;
    for (std::size_t index = 0; index < entries_.size(); ++index) {
        const Entry entry = entries_[index];
        const std::string shown = entry.is_folder ? entry.name + "/" : entry.name;
        if (ImGui::Selectable(shown.c_str(), entry.name == name_,
                              ImGuiSelectableFlags_DontClosePopups | ImGuiSelectableFlags_AllowDoubleClick)) {
            name_ = entry.name;
            chosen = entry.is_folder || ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
        }
        widgets::Record(entry.name.c_str());
    }
    ImGui::EndChild();
    ImGui::SetNextItemWidth(-1.0F);
    if (std::exchange(takes_keyboard_, false)) ImGui::SetKeyboardFocusHere();
    chosen |=
        ImGui::InputText("##name", &name_, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    widgets::Record("name");
    if (!error_.empty()) widgets::Trouble(error_.c_str());
    chosen |= widgets::Button(purpose_ == Purpose::open ? marked("Open") : marked("Save"), !name_.empty(),
                              "choose or type a name first");
    ImGui::SameLine();
    const bool cancelled = widgets::Button("Cancel") || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
    const bool is_done = chosen && confirm(session);
    takes_keyboard_ = chosen && !is_done;  // Enter took it from the field, and the next one is the answer
    if (is_done || cancelled) {
        is_open_ = false;
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

void draw_help(bool& open) {
    struct Line {
        const char* keys;
        const char* what;
    };
    static constexpr Line lines[] = {
        {"W S", marked("forward, back")},
        {"A D", marked("strafe left, right (fly) · turn (orbit)")},
        {"R F", marked("up, down (fly)")},
        {"← → ↑ ↓", marked("turn and look (walk: pan only)")},
        {"Q E", marked("roll (fly)")},
        {"Shift", marked("slow")},
        {marked("mouse drag"), marked("look · orbit")},
        {marked("right drag"), marked("shift the picture (fly, orbit)")},
        {marked("wheel"), marked("nearer, farther; Ctrl: speed (fly, walk)")},
        {marked("click"), marked("follow the nearest vertex; the background: none")},
        {"Home  G", marked("where it began · all in the picture")},
        {"L", marked("level: no roll")},
        {"X  Y  Z", marked("look along an axis; again: from behind")},
        {"", ""},
        {marked("drag a number"), marked("change it; Shift ×10, Alt ÷100")},
        {marked("double-click it"), marked("type; right-click resets")},
        {"Ctrl+Z  Ctrl+Shift+Z", marked("undo, redo")},
        {"Ctrl+C  Ctrl+V", marked("copy, paste the whole state")},
        {"Ctrl+O  Ctrl+S", marked("open, save")},
        {"", ""},
        {"F1", marked("these keys")},
        {"F2  F3", marked("fold the controls, the matrices")},
        {"M", marked("maximise the view under the pointer")},
        {"N", marked("next navigation mode")},
        {"B", marked("handles and labels on, off")},
        {"C", marked("fold the preset's sentence, unfold it")},
        {"Ctrl+P", marked("the presets; type to search")},
        {marked("Page up  Page down"), marked("the preset before, the next one")},
        {"Ctrl+plus  Ctrl+minus  Ctrl+0", marked("larger, smaller, as at first")},
        {"F11", marked("full screen")},
        {"F12", marked("snapshot of the camera view")},
    };
    const widgets::Group group("keys");
    if (open) ImGui::OpenPopup("keys");
    if (!begin_dialog("keys", {px(540.0F), px(580.0F)})) return;
    title(marked("Keys"));
    ImGui::Dummy({0.0F, px(2.0F)});
    ImGui::BeginChild("table", {0.0F, -ImGui::GetFrameHeightWithSpacing() - px(4.0F)});
    for (const Line& line : lines) {
        if (*line.keys == '\0') {
            ImGui::Dummy({0.0F, px(4.0F)});
            continue;
        }
        widgets::ValueText(tr(line.keys), widgets::Role::camera);
        ImGui::SameLine(px(200.0F));
        ImGui::TextUnformatted(tr(line.what));
    }
    ImGui::EndChild();
    if (widgets::Button("Close") || !open || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) {
        open = false;
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

}  // namespace viewing
