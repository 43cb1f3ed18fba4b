// The program's fonts, from memory: the same pixels on every machine.
#pragma once

#include <imgui.h>

#include "ui/parts/layout.h"
#include "ui/window/syllables.h"
#include "widgets/widgets.h"

namespace viewing {

/// Fills ImGui's font atlas for a scale (pixels per design pixel × the theme's type scale). Call between frames; the
/// atlas must be uploaded again afterwards, before `korean` changes. A character that no font has is shown as a box.
/// `small_type`: of notes and of numbers in tables, in design pixels.
widgets::Fonts load_fonts(float pixels_per_design_pixel, Syllables& korean, float small_type = usual_small_type);
/// Without Korean.
widgets::Fonts load_fonts(float pixels_per_design_pixel);

/// Which file's font draws a character, and the size of its em where the font is drawn in its own size.
struct GlyphFace {
    const char* file = "";  ///< as embedded_font() names it
    float em_px = 0.0F;
};
/// `font`: one of load_fonts(). The first of the fonts that it is made of stands for what none of them has.
GlyphFace face_of(const ImFont& font, ImWchar character);

}  // namespace viewing
