// The lecture's functions ShadowMatrix and ReflectionMatrix, as array assignments with the current numbers. Each line
// is highlighted together with the entry of S or R that it fills. Read topics/planes/numbers/lecture_code.h first.
#pragma once

#include "frame/derive.h"
#include "session/session.h"
#include "ui/parts/layout.h"

namespace viewing {

/// Draws both functions, side by side if they fit, otherwise one below the other.
void draw_lecture_code(Session& session, const Derived& derived, const Rect& rect);

}  // namespace viewing
