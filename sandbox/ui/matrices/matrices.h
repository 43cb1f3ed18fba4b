// The right column: S, R, V with C, P as on the slides, the followed point, and the slide's display() with numbers.
#pragma once

#include "frame/derive.h"
#include "session/session.h"

namespace viewing {

/// Which matrices the column shows; kept between frames.
struct MatrixChoice {
    bool shows_camera = false;  ///< C in the place of V
};

/// `before`: the same numbers before the latest edit; entries that differ are tinted.
void draw_matrices(Session& session, const Derived& derived, const Derived& before, MatrixChoice& choice);

/// Only those that the state lists (view.layout.matrices), in that order, below each other.
void draw_listed_matrices(Session& session, const Derived& derived, const Derived& before, MatrixChoice& choice);

}  // namespace viewing
