#include "state/params.h"

#include <algorithm>
#include <cmath>

namespace viewing {

constexpr double least_fovy_deg = 1e-3;

Lens Params::lens() const {
    double fovy_deg = projection.fovy;
    if (slips.degrees_as_radians) {
        const double turned_deg = std::remainder(glm::degrees(fovy_deg), 360.0);
        fovy_deg = std::copysign(std::clamp(std::abs(turned_deg), least_fovy_deg, 180.0 - least_fovy_deg), turned_deg);
    }
    return {projection.type == ProjectionType::orthographic, fovy_deg, projection.height, projection.near,
            projection.far};
}

}  // namespace viewing
