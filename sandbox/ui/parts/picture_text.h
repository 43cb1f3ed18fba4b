// Draws a line of text into a picture in memory, in the program's own typeface. Contact sheets use this.
#pragma once

#include <cstdint>
#include <string>

#include "image/image.h"

namespace viewing {

/// Returns the width of a line in pixels. `height_px`: from the typeface's ascent to its descent.
int caption_width_px(const std::string& text, int height_px);

/// Draws the line in gray `level` with its upper left corner at (`left_px`, `top_px`), clipped to the picture.
void draw_caption(Image& image, const std::string& text, int left_px, int top_px, int height_px, std::uint8_t level);

}  // namespace viewing
