#include "frame/say.h"

#include <cmath>

#include "frame/depth_precision.h"
#include "frame/hidden_drawing.h"

namespace viewing {

bool shows_effects(const Params& params) {
    return params.visibility.step < 0 && params.view.shows != Shows::fighting && params.view.shows != Shows::overdraw;
}

std::span<const DerivedPlane> drawn_planes(const Params& params, const Derived& derived) {
    return std::span(derived.planes).first(is_drawn_by_gl_alone(params.visibility.method) ? derived.planes.size() : 1);
}

double eye_side_of(const DerivedPlane& plane, const Derived& derived) {
    return glm::dot(plane.unit_plane, derived.eye_world);
}

std::string signed_figures(double value) {
    if (value == 0.0) return "0";
    return (value < 0.0 ? "−" : "") + figures(std::abs(value), 3);
}

}  // namespace viewing
