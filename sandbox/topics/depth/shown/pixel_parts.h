// The header of the views that examine one pixel: its color, its position, the surface there, and the button that
// releases the pin.
#pragma once

#include <string>

#include "state/params.h"

namespace viewing {

/// Draws the header line. Omits `surface` if it is empty, and moves it to its own line if it does not fit.
void draw_pixel_headline(ViewParams& view, glm::ivec2 pixel, const Color& color, const std::string& surface);

/// Releases the pinned pixel: the views follow the pointer again.
void release_pixel(ViewParams& view);

}  // namespace viewing
