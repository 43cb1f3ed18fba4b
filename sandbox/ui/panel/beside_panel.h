// The panel's section on the second picture of the camera's view, and the states that it can show with one click.
#pragma once

#include <vector>

#include "frame/problems.h"
#include "session/session.h"

namespace viewing {

/// The states that can be shown beside the current one.
enum class OtherState { before_edit, preset, fixed };

/// Returns the state before the latest edit, the state of the open preset, or the state with the first problem fixed;
/// nullopt if there is none, or if it differs in nothing that the second picture can show.
std::optional<Params> other_state(OtherState which, const Session& session, const std::vector<Problem>& problems);

/// Says, in the current language, why other_state() returns nullopt.
const char* why_no_other(OtherState which);

void beside_section(Session& session, const std::vector<Problem>& problems);

}  // namespace viewing
