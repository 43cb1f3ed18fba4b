// Removes the background from a picture that was drawn twice, on black and on white.
#pragma once

#include <cstdint>

#include "image/image.h"

namespace viewing {

/// Computes a pixel's color, not premultiplied, from its two drawings: opaque if they are equal, transparent if they
/// are black and white.
void remove_ground(const std::uint8_t* on_black, const std::uint8_t* on_white, std::uint8_t* rgba);

/// Calls remove_ground() for every pixel of two pictures of the same size. Multiplies each alpha by that of `on_black`.
Image without_ground(const Image& on_black, const Image& on_white);

}  // namespace viewing
