// The numbers of the followed point p, its shadow, and its mirror image, which are part of the matrix column.
#pragma once

#include "frame/derive.h"
#include "session/session.h"

namespace viewing {

/// Draws the numbers; keeps the same height if there is no point.
void draw_followed_point(Session& session, const Derived& derived);

}  // namespace viewing
