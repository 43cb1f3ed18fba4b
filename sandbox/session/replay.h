// Plays changes at their recorded times: a flight, or a student's changes toward a goal.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "lesson/hand_in.h"
#include "lesson/lesson.h"
#include "session/session.h"
#include "state/file/flight.h"

namespace viewing {

class Replay {
public:
    /// Begins at the flight's start, which is already the session's state.
    void begin(std::shared_ptr<const Flight> flight);
    /// Begins at the step's start. Shortens long pauses, and skips changes that cannot be applied.
    void begin(const LessonStep& step, const std::vector<ReplayStep>& steps);
    bool is_playing() const { return walk_.has_value(); }
    void stop() { walk_.reset(); }
    /// Called once a frame. Begins a flight that the session has opened. Stops if anything else changes the state.
    void update(Session& session, double dt_s);

private:
    std::optional<FlightWalk> walk_;
    std::optional<double> time_s_;  ///< none before the first frame
    std::size_t shown_ = 0;         ///< the current picture
    std::optional<Params> put_;     ///< the session's parameters after the last update
};

}  // namespace viewing
