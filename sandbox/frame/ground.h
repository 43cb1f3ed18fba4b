// Colors of everything except objects: each theme's background and floor, and the color codes of the views.
#pragma once

#include <array>

#include "state/params.h"

namespace viewing {

/// The colors of the background, of the patch's two tones and its lines, and of the depth view where nothing was drawn.
struct Ground {
    Color background, light, dark, line, unwritten;
};

Ground ground_of(Theme theme);

/// Blue and ocher are distinct for every kind of color vision; back faces are also striped.
inline constexpr Color front_color{0x70, 0x9e, 0xd9}, back_color{0xcc, 0x7d, 0x21};

/// The color of pixels where two hidden-surface methods differ.
inline constexpr Color difference_color{235, 30, 40};

/// Colors of stencil values: nothing marked, a patch, a patch with a missing light, a missing light outside a patch.
inline constexpr std::array<Color, 4> stencil_colors = {
    {{0x12, 0x15, 0x1b}, {0x2b, 0xb9, 0x8b}, {0xe6, 0x9f, 0x00}, {0xcc, 0x79, 0xa7}}};

/// Colors of a caster's points by their w after S: points that cast a shadow, points behind the plane, points beyond
/// the light.
inline constexpr std::array<Color, 3> caster_colors = {{{0x2b, 0xb9, 0x8b}, {0xd8, 0xc8, 0x4a}, {0xe4, 0x57, 0x2e}}};

/// Colors for how often a pixel was drawn: 0, 1 … 7, 8 or more times. They go from dark to bright, so that the order is
/// visible without color.
inline constexpr std::array<Color, 9> overdraw_colors = {{{0x12, 0x15, 0x1b},
                                                          {0x2d, 0x2a, 0x63},
                                                          {0x2f, 0x4a, 0x8f},
                                                          {0x2a, 0x71, 0x9a},
                                                          {0x2b, 0x96, 0x8b},
                                                          {0x55, 0xb8, 0x67},
                                                          {0xa0, 0xd0, 0x3f},
                                                          {0xf2, 0xe2, 0x2e},
                                                          {0xff, 0xff, 0xff}}};

/// Returns the linear value of an sRGB color.
glm::vec3 linear_from_srgb(const Color& color);

}  // namespace viewing
