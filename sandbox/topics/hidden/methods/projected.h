// A polygon's extent on the screen and in depth.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "topics/hidden/methods/polygons.h"
#include "topics/hidden/methods/viewpoint.h"

namespace viewing {

struct Projected {
    double nearest, farthest;         ///< eye distance
    glm::dvec2 min, max;              ///< normalized device coordinates
    std::vector<glm::dvec2> corners;  ///< convex, either winding
};

/// Projects a polygon, which must be beyond the near plane.
Projected project(const Polygon& polygon, const Viewpoint& viewpoint, const glm::dmat4& clip_from_world);

/// Returns whether two polygons are apart on an axis (0: x, 1: y), to within a hundred-millionth of the picture's size.
bool apart_on(int axis, const Projected& a, const Projected& b);

/// Returns whether two polygons are apart on the screen, with the same tolerance. A polygon without area on the screen
/// is apart from everything.
bool are_disjoint(const Projected& a, const Projected& b);

}  // namespace viewing
