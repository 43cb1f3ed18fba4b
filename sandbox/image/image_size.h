// Limits on the size of a picture: the same rule on the command line and in files.
#pragma once

#include <cstdint>
#include <string>

#include "image/png.h"

namespace viewing {

/// Drawing needs up to 60 bytes per pixel, with four samples and the views beside the picture; that is about 1 GB in
/// total.
constexpr int most_drawn_pixels = 4096 * 4096;

/// Measuring draws with every method and compares the results, which takes about 110 bytes and two microseconds per
/// pixel.
constexpr int most_measured_pixels = 2048 * 2048;

/// Whether a picture of this size can be drawn, written and read again. A picture composed of others, such as a contact
/// sheet, may have up to most_image_pixels pixels.
constexpr bool is_image_size(int width, int height, int most_pixels = most_drawn_pixels) {
    return width >= 1 && height >= 1 && width <= largest_image_side && height <= largest_image_side &&
           std::int64_t{width} * height <= most_pixels;
}

/// Returns, for example, "each side must be from 1 to 16384 and the picture at most 16 million pixels".
std::string image_size_rule(int most_pixels = most_drawn_pixels);

}  // namespace viewing
