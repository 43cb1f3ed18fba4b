// Makes deliberate changes to pictures, which a comparison must detect or ignore.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "image/image.h"

namespace cli_tests {

/// A rectangle of pixels that is completely inside the picture. It is empty only if a search found no such rectangle.
struct Area {
    int x = 0, y = 0, width = 0, height = 0;
    bool operator==(const Area&) const = default;
};

Area all_of(const viewing::Image& image);

/// Applies `change`, which takes a channel and its level, to every channel but alpha of each pixel in the area; clamps
/// the results to 0 … 255.
viewing::Image changed(viewing::Image image, const Area& area, const std::function<double(int, double)>& change);
/// Moves the area's content one pixel to the right; its first column stays.
viewing::Image shifted(viewing::Image image, const Area& area);
/// Adds noise of at most ±`levels` to each channel.
viewing::Image noisy(const viewing::Image& image, int levels, unsigned seed);
viewing::Image with_gamma(const viewing::Image& image, double gamma);
/// Averages each block of k × k pixels in linear light, as a resolve does. The picture's sides must be multiples of k.
viewing::Image resolved(const viewing::Image& image, int k);
/// Returns an area of this size in the middle of the pixels that differ by more than `worst`, such that all pixels in a
/// margin around it differ, too. Returns an empty area if there is none.
Area inside_of_difference(const viewing::Image& a, const viewing::Image& b, int worst, int width, int height,
                          int margin);

}  // namespace cli_tests
