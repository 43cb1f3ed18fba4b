// The followed point p with its shadow and mirror image in numbers: part of the matrices' column.
#pragma once

#include "frame/derive.h"
#include "session/session.h"

namespace viewing {

/// As high with a point as without one.
void draw_followed_point(Session& session, const Derived& derived);

}  // namespace viewing
