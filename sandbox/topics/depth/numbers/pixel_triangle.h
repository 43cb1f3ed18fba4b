// A triangle as seen through the center of one pixel: whether it covers the center, its distance there, and the weights
// of its corners there and beside it. Works in homogeneous coordinates, so nothing needs clipping. Read fragments.h
// next. Source: Olano and Greer 1997, Triangle Scan Conversion using 2D Homogeneous Coordinates.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>

#include "geometry/mesh.h"

namespace viewing {

struct PixelCorner {
    glm::dvec2 offset_px{0.0};  ///< from the pixel's center, y up, times w
    double w = 1.0;             ///< of clip space; not positive behind the eye
    double distance = 0.0;      ///< in front of the eye, −eye_z
};

/// The point where the view ray meets a triangle.
struct PixelHit {
    double distance = 0.0;             ///< negative behind the eye, where perspective flips the winding
    bool is_counter_clockwise = true;  ///< on the screen
    glm::dvec3 weights{0.0};           ///< barycentric; sum 1
};

using PixelTriangle = std::array<PixelCorner, 3>;

/// Returns the hit if the triangle covers the pixel's center. If triangles share an edge through the center, only one
/// of them is hit: the one to the right of the edge or, if the edge is horizontal, below it. None for a triangle seen
/// edge-on.
std::optional<PixelHit> hit(const PixelTriangle& triangle);

/// Returns the weights of the corners, sum 1, at the point where the view ray that is `beside_px` pixels from the
/// center meets the triangle's plane. If it never meets the plane, these weights give a distance that is not positive.
/// The triangle must not be seen edge-on.
glm::dvec3 weights_beside(const PixelTriangle& triangle, const glm::dvec2& beside_px);

/// Returns the steps, y up, to the horizontal and vertical neighbors in the same 2 × 2 block of pixels, from which a
/// shader measures slopes. Pixel (0, 0) is top left.
glm::dvec2 neighbors_px(glm::ivec2 pixel, glm::ivec2 size_px);

/// Converts points, given in the space that both matrices start from, to triangle corners as seen from one pixel.
class PixelView {
public:
    /// Pixel (0, 0) is top left.
    PixelView(const glm::dmat4& clip_from_space, const glm::dmat4& view_from_space, glm::ivec2 pixel,
              glm::ivec2 size_px);

    PixelCorner corner(const glm::dvec3& point) const;

    /// Returns false only if nothing inside the bounds can cover the pixel's center.
    bool may_meet(const Bounds& bounds) const;

private:
    glm::dvec4 across_, up_, w_, distance_;  ///< their dot products with a point are the members of its PixelCorner
};

}  // namespace viewing
