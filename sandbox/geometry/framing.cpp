#include "geometry/framing.h"

#include <algorithm>
#include <cmath>

namespace viewing {

Framing framing(const Bounds& box, const Angles& angles, const Lens& lens, double aspect) {
    constexpr double room = 1.08, least = 1e-3;
    const glm::dmat3 world_from_axes(rotation_from_angles(angles));
    const glm::dvec3 low = box.empty() ? glm::dvec3(0.0) : box.min, high = box.empty() ? glm::dvec3(0.0) : box.max;
    const double y_slope = lens.orthographic ? 0.0 : std::tan(glm::radians(0.5 * std::abs(lens.fovy_deg))) / room;
    const glm::dvec2 slope(y_slope * aspect, y_slope);

    // Measure the corners along right, up and back. Each edge of the picture touches the corner that reaches farthest
    // toward it.
    glm::dvec2 right_top(-1e300), left_bottom(-1e300);
    double front = -1e300, back = 1e300;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 world(corner & 1 ? high.x : low.x, corner & 2 ? high.y : low.y, corner & 4 ? high.z : low.z);
        const glm::dvec3 point = glm::transpose(world_from_axes) * world;
        right_top = glm::max(right_top, glm::dvec2(point) + slope * point.z);
        left_bottom = glm::max(left_bottom, -glm::dvec2(point) + slope * point.z);
        front = std::max(front, point.z);
        back = std::min(back, point.z);
    }
    const glm::dvec2 middle = 0.5 * (right_top - left_bottom), spread = 0.5 * (right_top + left_bottom);
    Framing found;
    double distance = front + 1.0;
    if (lens.orthographic) {
        found.height = std::max(2.0 * room * std::max(spread.y, spread.x / aspect), least);
        distance = front + std::max(lens.near, front - back);
    } else if (low != high) {
        distance = std::max({spread.x / slope.x, spread.y / slope.y, front + least});
    }
    found.eye = world_from_axes * glm::dvec3(middle, distance);
    return found;
}

}  // namespace viewing
