// The lecturer's notes while the room sees the step: in the terminal that started the program, in a file that another
// program shows, or in a window of their own.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/desktop/notes_window.h"
#include "lesson/notes.h"
#include "session/guide.h"

namespace viewing {

class LectureNotes {
public:
    /// "terminal", "window", a file's path, or "" for none.
    explicit LectureNotes(std::string target) : target_(std::move(target)) {}

    bool wants_window() const { return target_ == "window"; }
    /// Null where there is none: then they are nowhere.
    void take(std::unique_ptr<NotesWindow> window) { window_ = std::move(window); }

    /// Null where there is none or the person has closed it.
    GLFWwindow* shown_window() const { return window_ && window_->is_shown() ? window_->glfw() : nullptr; }

    /// Brings the page up to date where it is not; a file's trouble is one sentence.
    Status follow(const Guide& guide, const Session& session, double presented_s);
    /// Called once a frame.
    void draw(Theme theme, double device_scale);

private:
    /// What the page depends on; its minutes, since it tells no seconds.
    struct Shown {
        std::shared_ptr<const Lesson> lesson;
        std::size_t step = 0;
        StepPhase phase = StepPhase::asks;
        int minutes = 0;
        int scene_version = -1;  ///< answers are computed in it
        Language language = Language::en;
        bool operator==(const Shown&) const = default;
    };
    Status show(Notes notes);

    std::string target_;
    std::optional<Shown> shown_;
    std::unique_ptr<NotesWindow> window_;
};

}  // namespace viewing
