// A line of text drawn into a picture in memory, in the program's own typeface: for contact sheets.
#pragma once

#include <cstdint>
#include <string>

#include "image/image.h"

namespace viewing {

/// The width of a line in pixels. `height_px`: from the top of its capitals to the bottom of its descenders.
int caption_width_px(const std::string& text, int height_px);

/// Draws the line in gray `level` with its upper left corner at (`left_px`, `top_px`), clipped to the picture.
void draw_caption(Image& image, const std::string& text, int left_px, int top_px, int height_px, std::uint8_t level);

}  // namespace viewing
