// A QR code over the stage, with its link below: the room's phones open what the screen shows.
#pragma once

#include <string>

#include "text/result.h"
#include "ui/parts/layout.h"

namespace viewing {

/// Draws the code of `link` into the middle of `room`: a third of the window's height, black on white, whole pixels for
/// each module. `address` is the part of the link that is told if the whole link is too long to read. An error in place
/// of the link, or a link without a code, is told in one sentence.
void draw_code_plate(const Result<std::string>& link, const std::string& address, const Rect& room);

}  // namespace viewing
