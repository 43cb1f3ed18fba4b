// Plays what a student did on the way to a goal: the changes of a hand-in, one after the other.
#pragma once

#include <optional>
#include <vector>

#include "lesson/hand_in.h"
#include "lesson/lesson.h"
#include "session/session.h"

namespace viewing {

class Replay {
public:
    /// From the step's start on; pauses longer than a moment are cut short.
    void begin(const LessonStep& step, std::vector<ReplayStep> steps);
    bool is_playing() const { return start_.has_value(); }
    void stop() { start_.reset(); }
    /// Called once a frame. A change that cannot be made is passed over.
    void update(Session& session, double dt_s);

private:
    std::optional<Params> start_;
    std::vector<ReplayStep> steps_;
    std::size_t next_ = 0;
    double wait_s_ = 0.0;
};

}  // namespace viewing
