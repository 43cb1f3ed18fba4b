// What depth a triangle has where a pixel's centre meets it, and what the buffer makes of it. Read fragments.h next.
#pragma once

#include <cstdint>

#include "frame/depth/pixel_triangle.h"
#include "frame/plan.h"

namespace viewing {

/// Whether GL keeps the place where the triangle is met: between near and far. With a logarithm that is taken per
/// vertex, where the interpolated depth says so.
bool is_in_depth_range(const FramePlan& plan, const PixelTriangle& triangle, const PixelHit& hit);

/// Window depth, 0 … 1, with the offset and not rounded to a code yet. `neighbours_px` leads to the pixels beside and
/// above or below in the same 2 × 2 pixels, to which a shader measures slopes.
double depth_of(const FramePlan& plan, const PixelTriangle& triangle, const PixelHit& hit, const DepthOffset& offset,
                const glm::dvec2& neighbours_px);

/// The nearest integer code, or the bits of the float.
std::uint32_t code_of(double depth, const DepthPrecision& precision);

}  // namespace viewing
