// Pictures that are changed on purpose: what a comparison has to find, or to let pass.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "image/image.h"

namespace cli_tests {

/// Pixels of a picture; never empty, all inside.
struct Area {
    int x = 0, y = 0, width = 0, height = 0;
    bool operator==(const Area&) const = default;
};

Area all_of(const viewing::Image& image);

/// Each channel but alpha of the area's pixels through `change`, which takes channel and level; cut to 0 … 255.
viewing::Image changed(viewing::Image image, const Area& area, const std::function<double(int, double)>& change);
/// The area's content one pixel to the right; its first column stays.
viewing::Image shifted(viewing::Image image, const Area& area);
/// Up to `levels` more or less in each channel.
viewing::Image noisy(const viewing::Image& image, int levels, unsigned seed);
viewing::Image with_gamma(const viewing::Image& image, double gamma);
/// k x k pixels become one, averaged as light, which is what a resolve does. Sides are multiples of k.
viewing::Image resolved(const viewing::Image& image, int k);
/// The middle of the pixels that differ by more than `worst`, as an area of this size with a margin all around in
/// which all do; an empty one where there is none.
Area inside_of_difference(const viewing::Image& a, const viewing::Image& b, int worst, int width, int height,
                          int margin);

}  // namespace cli_tests
