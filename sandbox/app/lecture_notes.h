// The lecturer's notes beside the window: in the terminal that started it, or in a file that another program shows.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "lesson/notes.h"
#include "session/guide.h"

namespace viewing {

class LectureNotes {
public:
    /// "terminal", a file, or "" for none.
    explicit LectureNotes(std::string target) : target_(std::move(target)) {}

    /// Writes the page when it has changed. A file is replaced whole. The error says why it cannot be.
    Status follow(const Guide& guide, const Session& session, double presented_s);

private:
    /// What the page depends on; its minutes, since it tells no seconds.
    struct Shown {
        std::shared_ptr<const Lesson> lesson;
        std::size_t step = 0;
        StepPhase phase = StepPhase::asks;
        int minutes = 0;
        int scene_version = -1;  ///< answers are computed in it
        bool operator==(const Shown&) const = default;
    };
    std::string target_;
    std::optional<Shown> shown_;
};

}  // namespace viewing
