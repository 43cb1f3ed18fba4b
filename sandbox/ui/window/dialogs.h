// Dialogs over the window: one to choose a file, and one that asks for permission to read a file.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "platform/background.h"
#include "session/session.h"
#include "ui/window/syllables.h"

namespace viewing {

/// Begins a popup in the middle of the window, with the given size if that fits.
bool begin_dialog(const char* name, ImVec2 size);

/// Draws the dialog's heading.
void dialog_title(const char* text);

/// Chooses a file to open or a name to save under. Does not read or write any file until the user confirms the choice.
class FileDialog {
public:
    enum class Purpose { open, save, save_step, open_answers, save_answers };
    void show(Purpose purpose);
    /// Receives the chosen file when the purpose is open_answers or save_answers.
    using Use = std::function<void(const std::filesystem::path& file)>;
    void show(Purpose purpose, const std::string& name, Use use);
    /// Asks where to save the state as a step. Suggests `own`, the file of the open lesson, or, if `own` is empty, the
    /// file of the previous save. `highlight`: the parts that the step frames.
    void show_save_step(const std::filesystem::path& own, std::vector<std::string> highlight);
    /// Draws the dialog while it is open. Opens or saves through the session, whose message reports the outcome.
    void draw(Session& session);
    bool is_open() const { return requested_ || is_open_; }
    /// Collects the characters of file names and typed text for the fonts.
    void want(Syllables& korean) const;

private:
    void list_folder();
    void take_listing();
    /// Uses a file chosen in the platform's own dialog.
    void take_chosen(Session& session);
    /// Opens or saves. Returns true if the dialog is done.
    bool confirm(Session& session);
    bool ends_with_outcome(Session& session);

    struct Entry {
        std::string name;
        bool is_folder = false;
    };
    struct Listing {
        std::vector<Entry> entries;
        std::string error;
    };
    Purpose purpose_ = Purpose::open;
    bool requested_ = false, is_open_ = false;
    bool takes_keyboard_ = false;  ///< focuses the name field in the next frame
    std::filesystem::path folder_;
    std::vector<Entry> entries_;
    BackgroundTask<Listing> listing_;
    std::string name_;
    Use use_;
    std::filesystem::path step_file_;  ///< the file to which the last step was saved
    std::vector<std::string> highlight_;
    bool opens() const { return purpose_ == Purpose::open || purpose_ == Purpose::open_answers; }
    std::string error_;
    bool waits_ = false;                ///< waits for the outcome of opening or saving
    std::filesystem::path to_replace_;  ///< an existing file; the user was warned, so the next Save replaces it
};

/// Asks for permission while a state waits to read a file outside its folder.
void draw_permission(Session& session);

}  // namespace viewing
