// Converts a camera's angles to eye, center and up, and back. Read navigation.cpp next.
#include "geometry/look_at.h"

#include <algorithm>
#include <cmath>

namespace viewing {
namespace {

constexpr double least_share = 1e-12;  ///< relative to the coordinates; a shorter view direction is rounding error
constexpr double least_sine = 1e-9;    ///< of the angle between up and the view

double largest_component(const glm::dvec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

}  // namespace

Looking camera_looking_at(const LookAt& look_at) {
    const glm::dvec3 away = look_at.eye - look_at.center;
    const double reach = std::max(largest_component(look_at.eye), largest_component(look_at.center));
    if (largest_component(away) <= least_share * reach) return {{}, LookAtFault::center_is_eye};
    const glm::dvec3 back = glm::normalize(away / largest_component(away));
    const double up_size = largest_component(look_at.up);
    const glm::dvec3 unit_up = up_size > 0.0 ? glm::normalize(look_at.up / up_size) : back;
    const glm::dvec3 across = glm::cross(unit_up, back);
    if (glm::length(across) < least_sine)
        return {angles_looking_at(look_at.eye, look_at.eye - back), LookAtFault::up_along_view};
    const glm::dvec3 right = glm::normalize(across);
    return {angles_from_rotation({right, glm::cross(back, right), back}), LookAtFault::none};
}

LookAt look_at_of(const glm::dvec3& position, const Angles& angles, double distance) {
    constexpr double level_pitch_deg = 89.0;
    const glm::dmat4 rotation = rotation_from_angles(angles);
    const bool is_level = std::remainder(angles.roll_deg, 360.0) == 0.0 &&
                          std::abs(std::remainder(angles.pitch_deg, 360.0)) < level_pitch_deg;
    return {position, position - distance * glm::dvec3(rotation[2]),
            is_level ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(rotation[1])};
}

}  // namespace viewing
