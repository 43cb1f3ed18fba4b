// How large a picture may be: the one rule for every size that is given, on the command line and in files.
#pragma once

#include <cstdint>
#include <string>

#include "image/png.h"

namespace viewing {

/// Whether a picture of this size can be drawn, written and read again.
constexpr bool is_image_size(int width, int height) {
    return width >= 1 && height >= 1 && width <= largest_image_side && height <= largest_image_side &&
           std::int64_t{width} * height <= most_image_pixels;
}

/// "each side must be from 1 to 16384 and the picture at most 64 million pixels"
std::string image_size_rule();

}  // namespace viewing
