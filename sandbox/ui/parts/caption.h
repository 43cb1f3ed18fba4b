// A line of text drawn into a picture in memory, in the program's own type: for sheets of pictures.
#pragma once

#include <cstdint>
#include <string>

#include "image/image.h"

namespace viewing {

/// How wide a line is at this height of its capitals and descenders together, pixels.
int caption_width_px(const std::string& text, int height_px);

/// Draws the line with its upper left corner there, in grey `level`; what the picture does not have is cut off.
void draw_caption(Image& image, const std::string& text, int left_px, int top_px, int height_px, std::uint8_t level);

}  // namespace viewing
