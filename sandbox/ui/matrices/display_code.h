// The lecture's display() with the numbers of a camera: part of the matrices' column.
#pragma once

#include "frame/derive.h"

namespace viewing {

/// As it would read for this camera, with the two slips of the slide put right.
void draw_display_code(const Params& params, const Derived& derived);

}  // namespace viewing
