// Finds the fields that differ between two states, and checks whether a goal's step allows them to change.
#pragma once

#include <string>
#include <vector>

#include "lesson/lesson.h"
#include "state/params.h"

namespace viewing {

/// Returns the paths of fields that differ.
std::vector<std::string> changed_fields(const Params& before, const Params& after);

/// Returns the changed fields that `allow` lists neither individually nor by group. Viewing fields (view, observer, ui,
/// animation) may always change, and all fields may if `allow` is empty.
std::vector<std::string> changed_without_leave(const Params& before, const Params& after,
                                               const std::vector<std::string>& allow);

/// Applies changes to the start of a goal's step. Fails with one sentence if they are impossible or not allowed.
Result<Params> changed_start(const LessonStep& step, const std::vector<std::string>& settings);

/// Returns the changes from `before` to `after`: PATH=VALUE for every field that differs, except viewing fields.
std::vector<std::string> settings_between(const Params& before, const Params& after);

}  // namespace viewing
