// The right column: S, R, V or C, and P as on the slides, the followed point, and the slide's display() with numbers.
#pragma once

#include "frame/derive.h"
#include "session/session.h"

namespace viewing {

/// The choice of matrices in the column; kept between frames.
struct MatrixChoice {
    bool shows_camera = false;  ///< C instead of V
};

/// Draws the column. `before` holds the numbers before the latest edit; entries that differ are tinted.
void draw_matrices(Session& session, const Derived& derived, const Derived& before, MatrixChoice& choice);

/// Draws only these matrices, in this order; the names are those of view.layout.matrices.
void draw_listed_matrices(Session& session, const Derived& derived, const Derived& before, MatrixChoice& choice,
                          const std::vector<std::string>& listed);

}  // namespace viewing
