// The colours of what is not an object: each theme's background and floor, and the codes of the views.
#pragma once

#include <array>

#include "state/params.h"

namespace viewing {

/// Background, the two tones of the patch and its lines, and what the depth view shows where nothing was drawn.
struct Ground {
    Color background, light, dark, line, unwritten;
};

Ground ground_of(Theme theme);

/// Blue and ochre differ for every kind of colour vision, and back faces are striped besides.
inline constexpr Color front_color{0x70, 0x9e, 0xd9}, back_color{0xcc, 0x7d, 0x21};

/// Pixels where two hidden-surface methods differ.
inline constexpr Color difference_color{235, 30, 40};

/// Stencil values: nothing marked, a patch, a patch where a light is missing, and a light missing beside a patch.
inline constexpr std::array<Color, 4> stencil_colors = {
    {{0x12, 0x15, 0x1b}, {0x2b, 0xb9, 0x8b}, {0xe6, 0x9f, 0x00}, {0xcc, 0x79, 0xa7}}};

/// What S makes of w: casts a shadow, lies behind the plane, lies beyond the light.
inline constexpr std::array<Color, 3> caster_colors = {{{0x2b, 0xb9, 0x8b}, {0xd8, 0xc8, 0x4a}, {0xe4, 0x57, 0x2e}}};

/// How often a pixel was drawn: 0, 1 … 7, 8 or more. From dark to bright, so that it reads without colour.
inline constexpr std::array<Color, 9> overdraw_colors = {{{0x12, 0x15, 0x1b},
                                                          {0x2d, 0x2a, 0x63},
                                                          {0x2f, 0x4a, 0x8f},
                                                          {0x2a, 0x71, 0x9a},
                                                          {0x2b, 0x96, 0x8b},
                                                          {0x55, 0xb8, 0x67},
                                                          {0xa0, 0xd0, 0x3f},
                                                          {0xf2, 0xe2, 0x2e},
                                                          {0xff, 0xff, 0xff}}};

}  // namespace viewing
