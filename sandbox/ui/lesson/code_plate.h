// A QR code over the stage, with its link below, so that phones in the audience can open what the screen shows.
#pragma once

#include <string>

#include "text/result.h"
#include "ui/parts/layout.h"

namespace viewing {

/// Draws the code of `link` in the middle of `room`: a third of the window's height, black on white, with whole pixels
/// for each module. If the whole link is too long to read, shows only `address`, which is part of it. If `link` is an
/// error or has no code, shows one sentence that says so.
void draw_code_plate(const Result<std::string>& link, const std::string& address, const Rect& room);

}  // namespace viewing
