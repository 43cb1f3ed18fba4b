// The panel's section on the depth buffer: how depth is stored, what fights over it, and what is shown of it.
#pragma once

#include "frame/derive.h"
#include "session/session.h"

namespace viewing {

void draw_depth_section(Session& session, const Derived& derived);

}  // namespace viewing
