#include "state/params.h"

#include <cmath>

namespace viewing {

Lens Params::lens() const {
    double fovy_deg = projection.fovy;
    if (slips.degrees_as_radians) fovy_deg = std::remainder(glm::degrees(fovy_deg), 360.0);
    return {projection.type == ProjectionType::orthographic, fovy_deg, projection.height, projection.near,
            projection.far};
}

}  // namespace viewing
