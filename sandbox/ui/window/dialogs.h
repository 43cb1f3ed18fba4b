// What opens over the window: choosing a file, the keys (F1).
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "platform/background.h"
#include "session/session.h"
#include "ui/window/syllables.h"

namespace viewing {

/// A file to open or a name to save under; nothing is read or written before Enter or the button.
class FileDialog {
public:
    enum class Purpose { open, save, save_step, open_answers, save_answers };
    void show(Purpose purpose);
    /// For a file that is no state: `use` is told which one was chosen.
    using Use = std::function<void(const std::filesystem::path& file)>;
    void show(Purpose purpose, const std::string& name, Use use);
    /// Draws it while it is open; opens or saves through the session, whose message says what came of it.
    void draw(Session& session);
    bool is_open() const { return requested_ || is_open_; }
    /// What it shows of others: names of files, what is typed.
    void want(Syllables& korean) const;

private:
    void list_folder();
    void take_listing();
    /// What was chosen in a dialog of the surroundings.
    void take_chosen(Session& session);
    /// Whether the dialog has nothing left to do.
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
    bool takes_keyboard_ = false;  ///< the name's field does, in the next frame
    std::filesystem::path folder_;
    std::vector<Entry> entries_;
    BackgroundTask<Listing> listing_;
    std::string name_;
    Use use_;
    bool opens() const { return purpose_ == Purpose::open || purpose_ == Purpose::open_answers; }
    std::string error_;
    bool waits_ = false;                ///< for what comes of opening or saving
    std::filesystem::path to_replace_;  ///< exists and was asked about: the next Save replaces it
};

/// Asks for a yes while a state waits to read a file that lies outside its folder.
void draw_permission(Session& session);

/// The table of keys; `open` becomes false when it is closed.
void draw_help(bool& open);

}  // namespace viewing
