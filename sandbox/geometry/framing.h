// Places a camera so that its picture contains a box. See navigation.h for how the user moves the camera.
#pragma once

#include <glm/glm.hpp>

#include "geometry/camera.h"
#include "geometry/mesh.h"
#include "geometry/projection.h"

namespace viewing {

struct Framing {
    glm::dvec3 eye{0.0};
    double height = 6.0;  ///< full height of the picture, for an orthographic lens
};

/// Returns the nearest position from which a camera with these angles has the whole box in the middle of its picture,
/// with a small margin; a perspective camera is one unit away from a box that is a single point. For an orthographic
/// lens, returns the picture's height, and a position from which the whole box is beyond the near plane. An empty box
/// counts as the origin. `aspect` must be positive.
Framing framing(const Bounds& box, const Angles& angles, const Lens& lens, double aspect);

}  // namespace viewing
