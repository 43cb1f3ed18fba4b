// Plays changes at their times: a flight, or what a student did on the way to a goal.
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
    /// From its start on, which the session has.
    void begin(std::shared_ptr<const Flight> flight);
    /// From the step's start on; pauses longer than a moment are cut short, and a change that cannot be made is passed
    /// over.
    void begin(const LessonStep& step, const std::vector<ReplayStep>& steps);
    bool is_playing() const { return walk_.has_value(); }
    void stop() { walk_.reset(); }
    /// Called once a frame. A change that somebody else makes meanwhile ends it: the state is theirs then.
    void update(Session& session, double dt_s);

private:
    std::optional<FlightWalk> walk_;
    std::optional<double> time_s_;  ///< none before the first frame
    std::size_t shown_ = 0;         ///< the picture
    std::optional<Params> put_;     ///< the session's parameters, as they were left
};

}  // namespace viewing
