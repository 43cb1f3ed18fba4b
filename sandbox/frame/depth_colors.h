// The bands of color that distinguish neighboring depths. See ground.h for the other colors that belong to no object.
#pragma once

#include <array>

#include "state/scene_description.h"
#include "state/view_params.h"

namespace viewing {

/// Bands of equal width over the range of a depth picture, the nearest first. Each is as bright as the gray that it
/// replaces. Lightness rises in equal steps, so the order of the bands is visible even without color; every second band
/// is colored, so neighbors differ in both color and lightness. None is bluish, because that color marks pixels that
/// were never written.
inline constexpr std::array<Color, 16> depth_bands = {{{0x18, 0x18, 0x18},
                                                       {0x3d, 0x19, 0x06},
                                                       {0x30, 0x30, 0x30},
                                                       {0x5e, 0x31, 0x16},
                                                       {0x4a, 0x4a, 0x4a},
                                                       {0x7e, 0x4c, 0x24},
                                                       {0x66, 0x66, 0x66},
                                                       {0x9e, 0x69, 0x32},
                                                       {0x83, 0x83, 0x83},
                                                       {0xbc, 0x89, 0x42},
                                                       {0xa2, 0xa2, 0xa2},
                                                       {0xd9, 0xab, 0x53},
                                                       {0xc2, 0xc2, 0xc2},
                                                       {0xf5, 0xce, 0x67},
                                                       {0xe3, 0xe3, 0xe3},
                                                       {0xff, 0xf3, 0xcf}}};

/// Returns the colors at the ends of the shown range: black and white, or the first and the last band.
inline Color near_color(DepthColors colors) {
    return colors == DepthColors::bands ? depth_bands.front() : Color{0, 0, 0};
}
inline Color far_color(DepthColors colors) {
    return colors == DepthColors::bands ? depth_bands.back() : Color{255, 255, 255};
}

}  // namespace viewing
