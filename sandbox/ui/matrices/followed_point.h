// The numbers of the followed point p, its shadow, and its mirror image, which are part of the matrix column.
#pragma once

#include "frame/derive.h"
#include "session/session.h"

namespace viewing {

/// Returns the height of what draw_followed_point() draws.
float followed_point_height(const Session& session);

/// Draws the numbers; without a point, one line that says how to choose one.
void draw_followed_point(Session& session, const Derived& derived);

}  // namespace viewing
