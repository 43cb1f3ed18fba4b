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
    /// Remembers what was chosen in this frame and how far the person is; gives the workbench what other windows have
    /// added. `keeps_answers`: the exercises are their own, not a hand-in that is looked at.
    Status follow(const Requests& requests, Workbench& workbench, bool keeps_answers);
    /// Another window may have written: when this one is given the focus, when the page hears of it. follow() and the
    /// workbench's frame take over what is there.
    void read_again(Workbench& workbench);
    /// Gives a window that opens what it had the last time.
    void restore(Workbench& workbench, bool keeps_answers) const;
    /// Waits until all is written.
    Status finish();

private:
    Status take_written();

    std::filesystem::path file_;
    Remembered remembered_;   ///< as this window has it
    Remembered known_;        ///< the same when it was read or written last
    Remembered sent_;         ///< the same, as it is being written
    bool is_written_ = true;  ///< or being written
    bool has_news_ = false;   ///< of other windows, for the workbench
    BackgroundTask<Remembered> writing_;
    std::string trouble_;
    bool is_first_time_ = false;
};

}  // namespace viewing
