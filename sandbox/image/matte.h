// Removes the background from a picture that was drawn twice, on black and on white.
#pragma once

#include <cstdint>

#include "image/image.h"

namespace viewing {

/// Computes a color, not premultiplied, from the two results: opaque if they are equal, transparent if they are black
/// and white.
void remove_ground(const std::uint8_t* on_black, const std::uint8_t* on_white, std::uint8_t* rgba);

/// Does the same for every pixel of two pictures with the same size.
Image without_ground(const Image& on_black, const Image& on_white);

}  // namespace viewing
