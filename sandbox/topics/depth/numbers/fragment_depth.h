// Computes a triangle's depth at a pixel's center, and the code that the buffer stores. Read fragments.h next.
#pragma once

#include <cstdint>

#include "frame/plan/plan.h"
#include "topics/depth/numbers/pixel_triangle.h"

namespace viewing {

/// A triangle's corner after a pass's matrices. Mirror images and shadows may have their own near plane, and S is
/// projective; in these cases, the eye distance alone does not determine the depth.
struct ProjectedCorner {
    double z = 0.0, w = 1.0;            ///< of clip space
    double view_z = 0.0, view_w = 1.0;  ///< of view space, before the division by view_w
};
using ProjectedTriangle = std::array<ProjectedCorner, 3>;

/// Returns the eye distance of the point with these weights; it is negative behind the eye.
double projected_distance(const ProjectedTriangle& triangle, const glm::dvec3& weights);

/// Returns whether GL keeps the point with these weights: it is in front of the eye, and between near and far.
bool is_in_clip_range(const FramePlan& plan, const ProjectedTriangle& triangle, const glm::dvec3& weights);

/// Returns the window depth of a projected triangle with the offset, as depth_of() does for the camera's own matrices.
double projected_depth_of(const FramePlan& plan, const PixelTriangle& seen, const ProjectedTriangle& triangle,
                          const PixelHit& hit, const DepthOffset& offset, const glm::dvec2& neighbors_px);

/// Returns whether GL keeps the hit, that is, whether it lies between near and far. With a logarithm per vertex, the
/// interpolated depth decides this.
bool is_in_depth_range(const FramePlan& plan, const PixelTriangle& triangle, const PixelHit& hit);

/// Returns the window depth, 0 … 1, with the offset, before it is rounded to a code. `neighbors_px` points to the
/// horizontal and vertical neighbors in the same 2 × 2 block of pixels, from which a shader measures slopes.
double depth_of(const FramePlan& plan, const PixelTriangle& triangle, const PixelHit& hit, const DepthOffset& offset,
                const glm::dvec2& neighbors_px);

/// Returns how far GL's depth may be from depth_of() before it is stored. There are two causes: float32 arithmetic, in
/// which each step may be three times as coarse as IEEE allows, and corners rounded to 1/256 of a pixel, which moves a
/// steep surface. If the offset's unit was not measured, each unit adds an error of one code: GL does not define how
/// many codes a unit spans, and up to two are expected.
double depth_error(const FramePlan& plan, const PixelTriangle& triangle, const PixelHit& hit, const DepthOffset& offset,
                   const glm::dvec2& neighbors_px, glm::ivec2 size_px);

/// Returns by how many codes the stored depth may differ if the depth itself may differ by `error`; for a float, by how
/// many units in the last place.
double stored_within(double depth, double error, const DepthPrecision& precision);

/// Returns the nearest integer code, or the bits of the float.
std::uint32_t code_of(double depth, const DepthPrecision& precision);

}  // namespace viewing
