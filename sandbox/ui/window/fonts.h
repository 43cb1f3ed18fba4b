// The program's fonts, from embedded files: the same pixels on every machine.
#pragma once

#include <imgui.h>

#include "ui/parts/layout.h"
#include "ui/window/syllables.h"
#include "widgets/widgets.h"

namespace viewing {

/// Gives ImGui's context a font atlas for a scale (pixels per design pixel × the theme's type scale): a kept one with
/// the same fonts, or a new one. Keeps the previous atlas. Call between frames; afterward, upload the atlas again. A
/// character missing from every font appears as a box.
widgets::Fonts load_fonts(float pixels_per_design_pixel, Syllables& korean, const TypeSizes& type = {});
/// Loads the same fonts without Korean.
widgets::Fonts load_fonts(float pixels_per_design_pixel);
/// Call just before ImGui's context is destroyed: keeps its atlas for a later load_fonts() that needs the same fonts,
/// which saves drawing each of their glyphs again. Only the latest two are kept.
void keep_fonts();

/// The font file that draws a character, and that file's em size when ImGui draws the font at its default size.
struct GlyphFace {
    const char* file = "";  ///< as embedded_font() names it
    float em_px = 0.0F;
};
/// `font`: one of the fonts from load_fonts(). If none of its merged fonts has the character, returns the first of
/// them.
GlyphFace face_of(const ImFont& font, ImWchar character);

}  // namespace viewing
