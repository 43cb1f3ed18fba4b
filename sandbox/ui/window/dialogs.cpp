#include "ui/window/dialogs.h"
#include "text/catalogue.h"
#include "text/per_enum.h"
#include "ui/parts/look.h"

#include <imgui.h>
//

#include <algorithm>

#include "image/figure_note.h"
#include "lesson/append.h"
#include "platform/file.h"
#include "platform/person_files.h"
#include "platform/text_file.h"
#include "text/words.h"
#include "widgets/widgets.h"

namespace viewing {

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

void dialog_title(const char* text) {
    ImGui::PushFont(widgets::CurrentContext().fonts.heading);
    ImGui::TextUnformatted(tr(text));
    ImGui::PopFont();
}

namespace {

bool is_known_file(const std::filesystem::path& file) {
    return file.extension() == ".json" || is_figure_name(file) || is_obj_file(file);
}

/// Adds the session's state to a lesson file as its last step, or creates the file. Runs in the background.
void append_step(Session& session, const std::filesystem::path& file, const std::vector<std::string>& highlight) {
    const std::string preset = session.preset() ? session.preset()->name : "";
    const auto work = [file, params = session.params, preset, highlight]() -> Status {
        std::error_code unknown;
        std::string existing;
        if (std::filesystem::exists(file, unknown)) {
            Result<std::string> read = read_text_file(file);
            if (!read) return Error{read.error()};
            existing = *std::move(read);
        }
        const Result<std::string> lesson = with_step(existing, file.filename().string(), params, preset, highlight);
        if (!lesson) return Error{lesson.error()};
        return write_file(file, *lesson);
    };
    session.write(work, say("the state was added to {file} as the last step: now fill in the text of that step",
                            "file"_a = file.string()));
}

}  // namespace

void FileDialog::show(Purpose purpose) {
    purpose_ = purpose;
    if (opens() && ask_for_file()) return;
    requested_ = true;
    error_.clear();
    waits_ = false;
    to_replace_.clear();
    std::error_code ignored;
    if (folder_.empty()) folder_ = std::filesystem::current_path(ignored);
    name_ = purpose == Purpose::save ? "state.json" : purpose == Purpose::save_step ? "lesson.json" : "";
    list_folder();
}

void FileDialog::show(Purpose purpose, const std::string& name, Use use) {
    show(purpose);
    name_ = name;
    use_ = std::move(use);
}

void FileDialog::show_save_step(const std::filesystem::path& own, std::vector<std::string> highlight) {
    const std::filesystem::path& known = own.empty() ? step_file_ : own;
    if (!known.empty()) folder_ = known.parent_path();
    show(Purpose::save_step);
    if (!known.empty()) name_ = known.filename().string();
    highlight_ = std::move(highlight);
}

void FileDialog::want(Syllables& korean) const {
    for (const Entry& entry : entries_) korean.want(entry.name);
    for (const std::string& text : {folder_.string(), name_, error_, to_replace_.string()}) korean.want(text);
}

void FileDialog::list_folder() {
    constexpr double a_moment_s = 0.02;
    entries_.clear();
    listing_.start([folder = folder_](WorkProgress& progress) {
        Listing listing;
        std::error_code failed;
        for (std::filesystem::directory_iterator at(folder, failed), end; !failed && at != end; at.increment(failed)) {
            if (is_canceled(&progress)) break;
            const std::string name = at->path().filename().string();
            std::error_code ignored;
            const bool is_folder = at->is_directory(ignored);
            if (name.starts_with('.') || (!is_folder && !is_known_file(at->path()))) continue;
            listing.entries.push_back({name, is_folder});
        }
        if (failed) listing.error = folder.string() + ": " + failed.message();
        std::sort(listing.entries.begin(), listing.entries.end(), [](const Entry& a, const Entry& b) {
            return a.is_folder != b.is_folder ? a.is_folder : a.name < b.name;
        });
        return listing;
    });
    listing_.wait(a_moment_s);
    take_listing();
}

void FileDialog::take_listing() {
    std::optional<Result<Listing>> listing = listing_.take();
    if (!listing) return;
    if (!*listing) {
        error_ = listing->error();
        return;
    }
    entries_ = std::move((*listing)->entries);
    if (!(*listing)->error.empty()) error_ = (*listing)->error;
}

void FileDialog::take_chosen(Session& session) {
    const std::optional<std::filesystem::path> chosen = chosen_file();
    if (!chosen) return;
    if (purpose_ == Purpose::open_answers)
        use_(*chosen);
    else
        session.open(chosen->string());
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
    const bool replaces = purpose_ == Purpose::save || purpose_ == Purpose::save_answers;
    if (replaces && can_replace_files() && std::filesystem::exists(file, ignored) && to_replace_ != file) {
        to_replace_ = file;
        error_ = say("{file} already exists: save again to replace it", "file"_a = file.filename().string());
        return false;
    }
    error_.clear();
    if (purpose_ == Purpose::open_answers || purpose_ == Purpose::save_answers) {
        use_(file);
        waits_ = purpose_ == Purpose::save_answers;
        return !waits_;
    }
    if (purpose_ == Purpose::open)
        session.open(file.string());
    else if (purpose_ == Purpose::save)
        session.save(file);
    else
        append_step(session, step_file_ = file, highlight_);
    waits_ = purpose_ != Purpose::open || !is_obj_file(file);
    return !waits_;
}

bool FileDialog::ends_with_outcome(Session& session) {
    const std::optional<Status> outcome = waits_ ? session.take_outcome() : std::nullopt;
    if (!outcome) return false;
    waits_ = false;
    if (*outcome) return true;
    error_ = outcome->error();
    session.message = {};  // the dialog shows the error instead
    takes_keyboard_ = true;
    return false;
}

void FileDialog::draw(Session& session) {
    const widgets::Group group("file");
    take_chosen(session);
    if (requested_) ImGui::OpenPopup("file");
    is_open_ = begin_dialog("file", {px(580.0F), px(440.0F)});
    if (!is_open_) return;
    takes_keyboard_ |= std::exchange(requested_, false);
    take_listing();
    bool is_done = ends_with_outcome(session);

    static constexpr auto titles =
        per_enum<Purpose>(marked("Open a state (.json, .png, .svg, .pdf), a flight (.json) or a mesh (.obj)"),
                          marked("Save the state"), marked("Save the state as the last step of a lesson"),
                          marked("Open answers to exercises (.json)"), marked("Save the answers to hand in"));
    dialog_title(titles[purpose_]);
    widgets::Note(folder_.string().c_str());
    const float below = ImGui::GetFrameHeightWithSpacing() * 2.0F + px(error_.empty() ? 8.0F : 44.0F);
    ImGui::BeginChild("entries", {0.0F, -below}, true);
    if (folder_.has_parent_path() && ImGui::Selectable("..", false, ImGuiSelectableFlags_DontClosePopups)) {
        folder_ = folder_.parent_path();
        list_folder();
    }
    bool chosen = false;
    for (const Entry& entry : entries_) {
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
    chosen |= widgets::TextField("##name", name_, "",
                                 ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    if (std::exchange(takes_keyboard_, false)) ImGui::SetKeyboardFocusHere(-1);
    widgets::Record("name");
    if (!error_.empty()) widgets::Trouble(printable(error_).c_str());
    chosen |= widgets::Button(opens() ? marked("Open") : marked("Save"), !name_.empty(), "choose or type a name first");
    ImGui::SameLine();
    const bool canceled = widgets::Button("Cancel") || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
    if (chosen && !waits_ && !is_done) {
        is_done = confirm(session);
        takes_keyboard_ = !is_done;  // Enter took the focus from the field: return it, so that the next Enter confirms
    }
    if (canceled && waits_ && purpose_ == Purpose::open) session.cancel_loading();
    if (is_done || canceled) {
        waits_ = false;
        is_open_ = false;
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

void draw_permission(Session& session) {
    const widgets::Group group("outside");
    const OutsideFile* const asked = session.asks_to_read();
    if (asked) ImGui::OpenPopup("outside");
    if (!begin_dialog("outside", {px(580.0F), px(200.0F)})) return;
    if (!asked) {
        ImGui::CloseCurrentPopup();
        return ImGui::EndPopup();
    }
    dialog_title(marked("Read a file outside the state's folder?"));
    ImGui::BeginChild("question", {0.0F, -ImGui::GetFrameHeightWithSpacing() - px(4.0F)});
    widgets::Note(
        say("{state} refers to a file that is neither in the folder of that state nor in the sandbox's folder:",
            "state"_a = printable(asked->named_by))
            .c_str());
    ImGui::PushTextWrapPos(0.0F);
    ImGui::TextUnformatted(printable(asked->file.string()).c_str());
    ImGui::PopTextWrapPos();
    widgets::Record("file");
    widgets::Note(
        tr("'Yes' allows every file in that folder until the window is closed. Choose 'No' if you do not know where "
           "this state came from."));
    ImGui::EndChild();
    const bool yes = widgets::Button("Yes, read it");
    ImGui::SameLine();
    const bool no = widgets::Button("No") || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
    if (yes || no) {
        session.answer(yes);
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

}  // namespace viewing
