// Remembers theme, scale, language, mouse habits and the window's position for the next run. See
// state/person/remembered.h for the file.
#pragma once

#include <filesystem>
#include <string>

#include "platform/background.h"
#include "state/person/remembered.h"
#include "ui/window/workbench.h"

namespace viewing {

class WindowMemory {
public:
    /// Reads the file of the last run. If the file cannot be read, nothing is remembered and, unless `is_fresh`,
    /// trouble() says why. If `is_fresh`, forgets the window's appearance and position, but not the progress, the
    /// recent files or the student.
    WindowMemory(std::filesystem::path file, bool is_fresh);

    /// Returns the problem with the last run's file; "" if there is none.
    const std::string& trouble() const { return trouble_; }
    const Remembered& remembered() const { return remembered_; }
    /// Whether nothing has been remembered yet, which means that this is the first run.
    bool is_first_time() const { return is_first_time_; }

    /// Applies the remembered appearance to a state that sets none of its own. If no language is remembered, sets the
    /// system's.
    void dress(Params& params) const;

    /// Writes changes in the background. Call once a frame. Returns the outcome of a write that has ended; an error is
    /// one sentence. While a write is in progress, the next one waits, and only the latest values are kept.
    Status remember(const Remembered& now);
    /// Remembers the choices made in this frame and the user's progress, and passes additions by other windows to the
    /// workbench. `keeps_answers` says that the exercises are the user's own, not those of an opened hand-in.
    Status follow(const Requests& requests, Workbench& workbench, bool keeps_answers);
    /// Call when another window may have written the file, that is, when this window gets the focus or the page is
    /// notified. follow() and the workbench's frame then adopt the file's content.
    void read_again(Workbench& workbench);
    /// Restores the remembered progress and answers in a newly opened window.
    void restore(Workbench& workbench, bool keeps_answers) const;
    /// Waits until everything is written.
    Status finish();

private:
    Status take_written();

    std::filesystem::path file_;
    Remembered remembered_;   ///< current values in this window
    Remembered known_;        ///< the content of the file as last read or written
    Remembered sent_;         ///< values being written
    bool is_written_ = true;  ///< `remembered_` has been written, or is being written
    bool has_news_ = false;   ///< other windows added something that the workbench does not have yet
    BackgroundTask<Remembered> writing_;
    std::string trouble_;
    bool is_first_time_ = false;
};

}  // namespace viewing
