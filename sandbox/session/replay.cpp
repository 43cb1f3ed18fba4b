#include "session/replay.h"

#include <algorithm>
#include <utility>

#include "state/file/state_json.h"

namespace viewing {
namespace {

constexpr double first_pause_s = 1.5, shortest_pause_s = 0.2, longest_pause_s = 1.5;

Flight flight_of(const Params& start, const std::vector<ReplayStep>& steps) {
    Flight flight{start, {}, 0.0};
    Params before = start;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        flight.seconds += i == 0
                              ? first_pause_s
                              : std::clamp(steps[i].after_s - steps[i - 1].after_s, shortest_pause_s, longest_pause_s);
        const Result<Params> changed = apply_settings(start, steps[i].settings);
        if (!changed) continue;
        flight.frames.push_back({flight.seconds, settings_to(before, *changed)});
        before = *changed;
    }
    return flight;
}

/// Returns parameters with the user's own appearance settings and layout.
Params in_own_looks_and_layout(const Session& session, const Params& other) {
    Params own = session.in_own_looks(other);
    own.view.layout = session.params.view.layout;
    return own;
}

}  // namespace

void Replay::begin(std::shared_ptr<const Flight> flight) {
    walk_.emplace(std::move(flight));
    time_s_.reset();
    shown_ = 0;
    put_.reset();
}

void Replay::begin(const LessonStep& step, const std::vector<ReplayStep>& steps) {
    stop();
    if (!steps.empty()) begin(std::make_shared<const Flight>(flight_of(step.start.params, steps)));
}

void Replay::update(Session& session, double dt_s) {
    if (std::shared_ptr<const Flight> opened = session.take_flight()) begin(std::move(opened));
    if (!walk_) return;
    if (put_ && session.params != in_own_looks_and_layout(session, *put_)) return stop();
    time_s_ = time_s_ ? *time_s_ + dt_s : 0.0;
    const Flight& flight = walk_->flight();
    const std::size_t wanted = flight.picture_at(*time_s_);
    if (wanted != std::exchange(shown_, wanted)) {
        const Result<Params> params = walk_->at(wanted);
        if (!params) {
            session.report(Error{params.error()});
            return stop();
        }
        session.params = in_own_looks_and_layout(session, *params);
    }
    put_ = session.params;
    if (*time_s_ >= flight.seconds) stop();
}

}  // namespace viewing
