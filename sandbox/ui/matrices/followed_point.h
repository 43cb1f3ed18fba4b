// The numbers of the followed point p, which are part of the matrix column: its shadow and its mirror image, or its
// path through V and P into the depth buffer.
#pragma once

#include "frame/derive.h"
#include "session/session.h"

namespace viewing {

/// The transformations of the point to show: the chosen plane's S and R, the camera's V and P, or all of them.
enum class PointNumbers { plane, camera, both };

/// Returns the height of what draw_followed_point() draws.
float followed_point_height(const Session& session, PointNumbers numbers = PointNumbers::plane);

/// Draws the numbers; without a point, one line that says how to choose one.
void draw_followed_point(Session& session, const Derived& derived, PointNumbers numbers = PointNumbers::plane);

}  // namespace viewing
