// Which fields differ between two states, and whether a goal's step lets them be changed.
#pragma once

#include <string>
#include <vector>

#include "lesson/lesson.h"
#include "state/params.h"

namespace viewing {

/// The paths of fields that differ.
std::vector<std::string> changed_fields(const Params& before, const Params& after);

/// Of the changed fields those that `allow` has not, by themselves or by their group. How things are looked at (view,
/// observer, ui, animation) may always be changed, and everything where `allow` is empty.
std::vector<std::string> changed_without_leave(const Params& before, const Params& after,
                                               const std::vector<std::string>& allow);

/// The beginning of a goal's step with changes. The error, one sentence: they cannot be made, or are not allowed.
Result<Params> changed_start(const LessonStep& step, const std::vector<std::string>& settings);

/// What leads from one to the other but for how things are looked at: PATH=VALUE of every such field that differs.
std::vector<std::string> settings_between(const Params& before, const Params& after);

}  // namespace viewing
