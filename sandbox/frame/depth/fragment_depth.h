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

/// How far GL's depth may be from depth_of(), before it is stored: float32 arithmetic, where each of its steps rounds
/// up to three times as much as IEEE asks, and corners that are rounded to 1/256 of a pixel, by which a steep surface
/// moves. An offset adds as much as its units: GL leaves open how many codes one is, up to two are expected.
double depth_error(const FramePlan& plan, const PixelTriangle& triangle, const PixelHit& hit, const DepthOffset& offset,
                   const glm::dvec2& neighbours_px, glm::ivec2 size_px);

/// By how many codes, of a float by how many units in the last place, two depths may differ once they are stored.
double stored_within(double depth, double error, const DepthPrecision& precision);

/// The nearest integer code, or the bits of the float.
std::uint32_t code_of(double depth, const DepthPrecision& precision);

}  // namespace viewing
