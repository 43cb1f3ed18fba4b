// The lecturer's notes for the step that the audience sees: in the terminal that started the program, in a file that
// another program displays, or in their own window.
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
    /// `target` is "terminal", "window", a file's path, or "" for none.
    explicit LectureNotes(std::string target) : target_(std::move(target)) {}

    bool wants_window() const { return target_ == "window"; }
    /// Takes the notes window; null if none can be made, in which case the notes do not appear anywhere.
    void take(std::unique_ptr<NotesWindow> window) { window_ = std::move(window); }

    /// Returns the notes window; null if there is none, or if the user has closed it.
    GLFWwindow* shown_window() const { return window_ && window_->is_shown() ? window_->glfw() : nullptr; }

    /// Updates the notes if their content has changed. An error is one sentence about the notes' file.
    Status follow(const Guide& guide, const Session& session, double presented_s);
    /// Call once a frame.
    void draw(Theme theme, double device_scale);

private:
    /// The data that the notes depend on. Time is in minutes, since the notes show no seconds.
    struct Shown {
        std::shared_ptr<const Lesson> lesson;
        std::size_t step = 0;
        StepPhase phase = StepPhase::asks;
        int minutes = 0;
        int scene_version = -1;  ///< of the scene for which answers are computed
        Language language = Language::en;
        bool operator==(const Shown&) const = default;
    };
    Status show(Notes notes);

    std::string target_;
    std::optional<Shown> shown_;
    std::unique_ptr<NotesWindow> window_;
};

}  // namespace viewing
