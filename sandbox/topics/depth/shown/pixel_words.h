// One-line descriptions of a pixel, for the status bar and the header of the pixel view.
#pragma once

#include <string>
#include <vector>

#include "frame/pixel_report.h"

namespace viewing {

/// Names the surface that the pixel shows: "box, front face".
std::string surface_words(const PixelReport& pixel);

/// Returns the parts for the status bar, the most important first. A narrow bar drops those that do not fit.
std::vector<std::string> pixel_words(const PixelReport& pixel);

}  // namespace viewing
