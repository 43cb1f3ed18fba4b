#include "frame/finite.h"

#include <cmath>

namespace viewing {
namespace {

bool is_finite(const glm::dmat4& matrix) {
    for (glm::length_t column = 0; column < 4; ++column)
        for (glm::length_t row = 0; row < 4; ++row)
            if (!std::isfinite(static_cast<float>(matrix[column][row]))) return false;
    return true;
}

Error not_finite(const char* name) {
    return {std::string(name) + " has an entry that is not a finite number"};
}

}  // namespace

Status check_finite(const Derived& derived) {
    if (!is_finite(derived.clip_from_view)) return not_finite("the projection");
    if (!is_finite(derived.view_from_world)) return not_finite("the view matrix");
    for (const DerivedPlane& plane : derived.planes) {
        for (const CastShadow& cast : plane.shadows)
            if (!is_finite(cast.shadowed_world_from_world)) return not_finite("the shadow matrix");
        if (!is_finite(plane.mirrored_world_from_world)) return not_finite("the mirror matrix");
    }
    return std::monostate{};
}

}  // namespace viewing
