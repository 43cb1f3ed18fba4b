// What is said of a pixel where there is one line for it: the status bar, the pixel view's headline.
#pragma once

#include <string>
#include <vector>

#include "frame/pixel_report.h"

namespace viewing {

/// "box, front face".
std::string surface_words(const PixelReport& pixel);

/// For the status bar. The most wanted part first: each can be left out where the bar is narrow.
std::vector<std::string> pixel_words(const PixelReport& pixel);

}  // namespace viewing
