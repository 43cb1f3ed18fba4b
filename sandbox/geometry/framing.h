// Where a camera has to stand so that its picture holds a box. Pure. Read navigation.h for how it moves there by hand.
#pragma once

#include <glm/glm.hpp>

#include "geometry/camera.h"
#include "geometry/mesh.h"
#include "geometry/projection.h"

namespace viewing {

struct Framing {
    glm::dvec3 eye{0.0};
    double height = 6.0;  ///< of an orthographic lens
};

/// The nearest place from which a camera with these angles has the whole box in the middle of its picture, with a
/// little room around it. A box that is a point is seen from one unit away; an empty one from where its centre would be
/// the origin. `aspect` above 0.
Framing framing(const Bounds& box, const Angles& angles, const Lens& lens, double aspect);

}  // namespace viewing
