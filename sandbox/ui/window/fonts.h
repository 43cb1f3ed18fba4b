// The program's fonts, from memory: the same pixels on every machine.
#pragma once

#include "widgets/widgets.h"

namespace viewing {

/// Fills ImGui's font atlas for a scale (pixels per design pixel × the theme's type scale). Call between frames; the
/// atlas must be uploaded again afterwards.
widgets::Fonts load_fonts(float pixels_per_design_pixel);

}  // namespace viewing
