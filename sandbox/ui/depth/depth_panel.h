// The panel's section on the depth buffer: the buffer's format, depth fighting, and how depths are displayed.
#pragma once

#include "frame/derive.h"
#include "session/session.h"

namespace viewing {

void draw_depth_section(Session& session, const Derived& derived);

}  // namespace viewing
