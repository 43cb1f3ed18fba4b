#include "session/replay.h"

#include <algorithm>

#include "state/json.h"

namespace viewing {
namespace {

constexpr double shortest_pause_s = 0.2, longest_pause_s = 1.5;

double pause(const std::vector<ReplayStep>& steps, std::size_t next) {
    const double before = next == 0 ? 0.0 : steps[next - 1].after_s;
    return std::clamp(steps[next].after_s - before, shortest_pause_s, longest_pause_s);
}

}  // namespace

void Replay::begin(const LessonStep& step, std::vector<ReplayStep> steps) {
    start_ = step.start.params;
    steps_ = std::move(steps);
    next_ = 0;
    wait_s_ = longest_pause_s;
    if (steps_.empty()) stop();
}

void Replay::update(Session& session, double dt_s) {
    if (!start_) return;
    wait_s_ -= dt_s;
    if (wait_s_ > 0.0) return;
    if (const Result<Params> changed = apply_settings(*start_, steps_[next_].settings))
        session.params = session.in_own_looks(*changed);
    if (++next_ == steps_.size()) return stop();
    wait_s_ = pause(steps_, next_);
}

}  // namespace viewing
