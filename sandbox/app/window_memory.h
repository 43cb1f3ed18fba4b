// Theme, scale, language and the window's place as they come back the next time. Read state/person/remembered.h for the
// file.
#pragma once

#include <filesystem>
#include <string>

#include "platform/background.h"
#include "state/person/remembered.h"
#include "ui/window/workbench.h"

namespace viewing {

class WindowMemory {
public:
    /// Reads what the last time left; `is_fresh`: forgets it instead. What cannot be read is a sentence, and nothing
    /// is remembered then.
    WindowMemory(std::filesystem::path file, bool is_fresh);

    /// Of the last time, "" where all went well.
    const std::string& trouble() const { return trouble_; }
    const Remembered& remembered() const { return remembered_; }
    /// Nothing was there to be remembered: the first time.
    bool is_first_time() const { return is_first_time_; }

    /// A state that says nothing of its looks has the remembered ones; the first time it speaks the system's language.
    void dress(Params& params) const;

    /// Has what has changed written, beside the window: called once a frame it tells what came of it, an error as one
    /// sentence. While one is being written, the next waits and only the latest is kept.
    Status remember(const Remembered& now);
    /// Remembers what was chosen in this frame and how far the person is. `keeps_answers`: the exercises are their own,
    /// not a hand-in that is looked at.
    Status follow(const Requests& requests, const Workbench& workbench, bool keeps_answers);
    /// Gives a window that opens what it had the last time.
    void restore(Workbench& workbench, bool keeps_answers) const;
    /// Waits until all is written.
    Status finish();

private:
    std::filesystem::path file_;
    Remembered remembered_;
    bool is_written_ = true;  ///< or being written
    BackgroundTask<std::monostate> writing_;
    std::string trouble_;
    bool is_first_time_ = false;
};

}  // namespace viewing
