// What a picture shows without the ground it was drawn on, from two of it: on black and on white.
#pragma once

#include <cstdint>

#include "image/image.h"

namespace viewing {

/// A colour, not premultiplied, from how it looks on black and on white: opaque where they are alike, nothing where
/// they are black and white.
void remove_ground(const std::uint8_t* on_black, const std::uint8_t* on_white, std::uint8_t* rgba);

/// The same for every pixel of two pictures of one size.
Image without_ground(const Image& on_black, const Image& on_white);

}  // namespace viewing
