// The program's fonts, from memory: the same pixels on every machine.
#pragma once

#include "ui/window/syllables.h"
#include "widgets/widgets.h"

namespace viewing {

/// Fills ImGui's font atlas for a scale (pixels per design pixel × the theme's type scale). Call between frames; the
/// atlas must be uploaded again afterwards, before `korean` changes. A character that no font has is shown as a box.
widgets::Fonts load_fonts(float pixels_per_design_pixel, Syllables& korean);
/// Without Korean.
widgets::Fonts load_fonts(float pixels_per_design_pixel);

}  // namespace viewing
