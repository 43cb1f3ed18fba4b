// The lecture's display() with the numbers of a camera: a part of the matrices' column, and a view of its own.
#pragma once

#include "frame/derive.h"
#include "ui/parts/layout.h"

namespace viewing {

/// Below one another, where the window stands.
void draw_display_code(const Params& params, const Derived& derived);

/// As large as there is room for.
void draw_display_code_view(const Params& params, const Derived& derived, const Rect& rect);

}  // namespace viewing
