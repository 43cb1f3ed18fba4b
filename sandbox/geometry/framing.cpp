#include "geometry/framing.h"

#include <algorithm>
#include <cmath>

namespace viewing {

Framing framing(const Bounds& box, const Angles& angles, const Lens& lens, double aspect) {
    constexpr double room = 1.08, least = 1e-3;
    const glm::dmat3 world_from_axes(rotation_from_angles(angles));
    const glm::dvec3 low = box.empty() ? glm::dvec3(0.0) : box.min, high = box.empty() ? glm::dvec3(0.0) : box.max;
    Lens upright = lens;
    upright.fovy_deg = std::abs(lens.fovy_deg);
    const Edges edges = upright.edges_at(1.0, aspect);
    const glm::dvec2 center = edges.center(), size(edges.width(), edges.height());
    const glm::dvec2 half_slope = lens.orthographic ? glm::dvec2(0.0) : 0.5 * size / room;
    const glm::dvec2 to_right_top = lens.orthographic ? glm::dvec2(0.0) : center + half_slope;
    const glm::dvec2 to_left_bottom = lens.orthographic ? glm::dvec2(0.0) : half_slope - center;

    // Measure the corners along right, up and back. Each edge of the picture touches the corner that reaches farthest
    // toward it.
    glm::dvec2 right_top(-1e300), left_bottom(-1e300);
    double front = -1e300, back = 1e300;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 world(corner & 1 ? high.x : low.x, corner & 2 ? high.y : low.y, corner & 4 ? high.z : low.z);
        const glm::dvec3 point = glm::transpose(world_from_axes) * world;
        right_top = glm::max(right_top, glm::dvec2(point) + to_right_top * point.z);
        left_bottom = glm::max(left_bottom, -glm::dvec2(point) + to_left_bottom * point.z);
        front = std::max(front, point.z);
        back = std::min(back, point.z);
    }
    glm::dvec2 middle = 0.5 * (right_top - left_bottom);
    const glm::dvec2 spread = 0.5 * (right_top + left_bottom);
    Framing found;
    double distance = front + 1.0;
    if (lens.orthographic) {
        found.height = std::max(2.0 * room * std::max(spread.y, spread.x * size.y / size.x), least);
        distance = front + std::max(lens.near, front - back);
        middle -= found.height / size.y * center;
    } else if (low != high) {
        distance = std::max({spread.x / half_slope.x, spread.y / half_slope.y, front + least});
    }
    if (!lens.orthographic) middle -= distance * center;
    found.eye = world_from_axes * glm::dvec3(middle, distance);
    return found;
}

}  // namespace viewing
