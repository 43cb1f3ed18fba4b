// A triangle as the centre of one pixel sees it: whether it covers the pixel, how far away it is there and how fast
// that changes. In homogeneous coordinates, so that nothing need be clipped. Read fragments.h next.
// Source: Olano and Greer 1997, Triangle Scan Conversion using 2D Homogeneous Coordinates.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>

#include "geometry/mesh.h"

namespace viewing {

struct PixelCorner {
    glm::dvec2 offset_px{0.0};  ///< from the pixel's centre, y up, times w
    double w = 1.0;             ///< of clip space; not positive behind the eye
    double distance = 0.0;      ///< in front of the eye, −eye_z
};

/// Where the line of sight meets a triangle.
struct PixelHit {
    double distance = 0.0;             ///< negative behind the eye, where a perspective turns the winding around
    bool is_counter_clockwise = true;  ///< on the screen
    glm::dvec3 weights{0.0};           ///< of the corners: makes the point of them; sum 1
};

using PixelTriangle = std::array<PixelCorner, 3>;

/// Met where it covers the pixel's centre. Of triangles that share an edge through the centre one is met: the one to
/// its right, of a level edge the one below. None for a triangle seen edge-on.
std::optional<PixelHit> hit(const PixelTriangle& triangle);

/// The weights of the corners, sum 1, where the ray that many pixels beside the centre meets the triangle's plane. The
/// distance that they make is not positive where it never meets it. The triangle must not be seen edge-on.
glm::dvec3 weights_beside(const PixelTriangle& triangle, const glm::dvec2& beside_px);

/// Sends points of one space to corners as one pixel sees them.
class PixelView {
public:
    /// Pixel (0, 0) is the top left one.
    PixelView(const glm::dmat4& clip_from_space, const glm::dmat4& view_from_space, glm::ivec2 pixel,
              glm::ivec2 size_px);

    PixelCorner corner(const glm::dvec3& point) const;

    /// False only when nothing inside the bounds can cover the pixel's centre.
    bool may_meet(const Bounds& bounds) const;

private:
    glm::dvec4 across_, up_, w_, distance_;  ///< what a point is multiplied by
};

}  // namespace viewing
