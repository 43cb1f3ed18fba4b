// The lecture's two functions, ShadowMatrix and ReflectionMatrix, as array fills with the current numbers. Each line
// lights up with the entry of S or R that it fills. Read frame/planes/lecture_code.h first.
#pragma once

#include "frame/derive.h"
#include "session/session.h"
#include "ui/parts/layout.h"

namespace viewing {

/// Side by side where both fit, else one below the other.
void draw_lecture_code(Session& session, const Derived& derived, const Rect& rect);

}  // namespace viewing
