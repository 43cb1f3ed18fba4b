// The panel's section on the depth buffer: its format, depth fighting, and its display.
#pragma once

#include "frame/derive.h"
#include "session/session.h"

namespace viewing {

void draw_depth_section(Session& session, const Derived& derived);

}  // namespace viewing
