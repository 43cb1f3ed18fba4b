// How large a picture may be: the one rule for every size that is given, on the command line and in files.
#pragma once

#include <cstdint>
#include <string>

#include "image/png.h"

namespace viewing {

/// What is drawn takes up to 60 bytes a pixel, with four samples and the views beside it: about 1 GB.
constexpr int most_drawn_pixels = 4096 * 4096;

/// What is measured is drawn by every method and compared: about 110 bytes and two microseconds a pixel.
constexpr int most_measured_pixels = 2048 * 2048;

/// Whether a picture of this size can be drawn, written and read again. What is put
/// together from pictures, as a contact sheet is, may have most_image_pixels.
constexpr bool is_image_size(int width, int height, int most_pixels = most_drawn_pixels) {
    return width >= 1 && height >= 1 && width <= largest_image_side && height <= largest_image_side &&
           std::int64_t{width} * height <= most_pixels;
}

/// "each side must be from 1 to 16384 and the picture at most 16 million pixels"
std::string image_size_rule(int most_pixels = most_drawn_pixels);

}  // namespace viewing
