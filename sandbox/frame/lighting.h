// The strengths of the light that surfaces reflect: the shaders and the explanation of a pixel's color use the same
// numbers. See shaders/surface_light.glsl for the formula.
#pragma once

namespace viewing {

/// Factors of linear light. Ambient light is stronger on sides that face the sky.
inline constexpr double ambient_light = 0.23, sky_light = 0.07, diffuse_light = 0.78, highlight_light = 0.16;
/// The exponent of the highlight.
inline constexpr int shininess = 48;

}  // namespace viewing
