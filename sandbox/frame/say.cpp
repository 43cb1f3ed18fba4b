#include "frame/say.h"

#include <cmath>

#include "text/numbers.h"

namespace viewing {

double eye_side_of(const DerivedPlane& plane, const Derived& derived) {
    return glm::dot(plane.unit_plane, derived.eye_world);
}

std::string name_of(const char* thing, const std::vector<std::size_t>& which, std::size_t count) {
    if (count == 1) return std::string("the ") + thing;
    std::string name = std::string(thing) + (which.size() > 1 ? "s" : "");
    for (std::size_t i = 0; i < which.size(); ++i) name += (i > 0 ? ", " : " ") + std::to_string(which[i] + 1);
    return name;
}

std::string signed_figures(double value) {
    if (value == 0.0) return "0";
    return (value < 0.0 ? "−" : "") + figures(std::abs(value), 3);
}

}  // namespace viewing
