// The right column: S, R, V with C, P as on the slides, the followed point, and the slide's display() with numbers.
#pragma once

#include "frame/derive.h"
#include "ui/session.h"

namespace viewing {

/// `before`: the same numbers before the latest edit; entries that differ are tinted. `shows_camera_matrix`: C in the
/// place of V.
void draw_matrices(Session& session, const Derived& derived, const Derived& before, bool& shows_camera_matrix);

}  // namespace viewing
