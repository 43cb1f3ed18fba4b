// The panel section on P.
#pragma once

#include "frame/problems.h"
#include "session/session.h"

namespace viewing {

void draw_projection_section(Session& session, const Derived& derived, const std::vector<Problem>& problems);

}  // namespace viewing
