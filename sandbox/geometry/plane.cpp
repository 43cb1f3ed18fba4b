// The lecture's two matrices of a plane, and the patch drawn for it. Read projection.cpp next.
#include "geometry/plane.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace viewing {
namespace {

double sign_of(double value) {
    return value < 0.0 ? -1.0 : 1.0;
}

int index_of_largest(const glm::dvec3& magnitudes) {
    int largest = 0;
    for (int i = 1; i < 3; ++i) {
        if (magnitudes[i] > magnitudes[largest]) {
            largest = i;
        }
    }
    return largest;
}

int last_index_of_smallest(const glm::dvec3& magnitudes) {
    int smallest = 0;
    for (int i = 1; i < 3; ++i) {
        if (magnitudes[i] <= magnitudes[smallest]) {
            smallest = i;
        }
    }
    return smallest;
}

}  // namespace

glm::dvec4 unit_plane(const glm::dvec4& plane) {
    const double length = glm::length(glm::dvec3(plane));
    assert(length > 0.0 && "a plane needs a normal");
    return plane / length;
}

bool is_parallel_light(const glm::dvec4& light) {
    constexpr double farthest = 1e6;
    const double length = glm::length(glm::dvec3(light));
    return length > 0.0 && light.w * farthest <= length;
}

glm::dmat4 shadow_matrix(const glm::dvec4& plane, const glm::dvec4& light) {
    return glm::dmat4(glm::dot(plane, light)) - glm::outerProduct(light, plane);
}

double shadow_sign(const glm::dvec4& plane, const glm::dvec4& light) {
    return sign_of(glm::dot(plane, light));
}

glm::dvec4 plane_facing(const glm::dvec4& plane, const glm::dvec4& point) {
    return plane * sign_of(glm::dot(plane, point));
}

glm::dvec3 line_of_sight(const glm::dvec4& eye, const glm::dvec3& point) {
    return glm::normalize(point * eye.w - glm::dvec3(eye));
}

bool lies_in_plane(const glm::dvec4& unit_plane, const glm::dvec4& light) {
    return std::abs(glm::dot(unit_plane, light)) <= 1e-9 * std::max(1.0, glm::length(light));
}

glm::dmat4 mirror_matrix(const glm::dvec4& unit_plane) {
    const glm::dvec3 n(unit_plane);
    glm::dmat4 mirror(glm::dmat3(1.0) - 2.0 * glm::outerProduct(n, n));
    mirror[3] = {-2.0 * unit_plane.w * n + 0.0, 1.0};
    return mirror;
}

glm::dmat4 with_oblique_near_plane(glm::dmat4 clip_from_view, const glm::dvec4& plane_view, ClipRange range) {
    // Find the corner of the frustum's far end that lies farthest beyond the new near plane.
    const glm::dmat4 view_from_clip = glm::inverse(clip_from_view);
    const glm::dvec4 plane_clip = plane_view * view_from_clip;
    const double far_end = range == ClipRange::standard ? 1.0 : range == ClipRange::reversed ? -1.0 : 0.0;
    const glm::dvec4 corner_view =
        view_from_clip * glm::dvec4(sign_of(plane_clip.x), sign_of(plane_clip.y), far_end, 1.0);

    // That corner must stay at the far end. On the new near plane, z must be at the near end of its range, so z + w =
    // scale · plane, or w − z = scale · plane with reversed depth. If the whole frustum is on the clipped side of the
    // new near plane, any positive scale clips all of it.
    constexpr double min_reach = 1e-9;
    const double reach = std::max(glm::dot(plane_view, corner_view), min_reach);
    const glm::dvec4 scaled_plane = plane_view * ((range == ClipRange::reversed_zero_to_one ? 1.0 : 2.0) / reach);
    for (int column = 0; column < 4; ++column) {
        const double w = clip_from_view[column][3];
        clip_from_view[column][2] = range == ClipRange::standard ? scaled_plane[column] - w : w - scaled_plane[column];
    }
    return clip_from_view;
}

std::array<glm::dvec3, 4> PlanePatch::corners() const {
    const glm::dvec3 a = u * extent, b = v * extent;
    return {center - a - b, center + a - b, center + a + b, center - a + b};
}

double PlanePatch::reach() const {
    return extent * (1.0 + 1e-9);
}

bool PlanePatch::holds(const glm::dvec3& point) const {
    const glm::dvec3 offset = point - center;
    return std::abs(glm::dot(offset, u)) <= reach() && std::abs(glm::dot(offset, v)) <= reach();
}

glm::dmat4 PlanePatch::world_from_patch() const {
    return {{u * extent, 0.0}, {normal, 0.0}, {v * extent, 0.0}, {center, 1.0}};
}

PlanePatch plane_patch(const glm::dvec4& plane, double extent) {
    glm::dvec4 unit = unit_plane(plane);
    unit *= sign_of(unit[index_of_largest(glm::abs(glm::dvec3(unit)))]);
    unit += 0.0;  // no negative zeros, so that P and −P give the same result

    const glm::dvec3 normal(unit);
    glm::dvec3 axis(0.0);
    axis[last_index_of_smallest(glm::abs(normal))] = 1.0;
    const glm::dvec3 u = glm::normalize(glm::cross(normal, axis)) + 0.0;
    const glm::dvec3 v = glm::cross(u, normal) + 0.0;
    return {-unit.w * normal + 0.0, u, v, normal, extent};
}

}  // namespace viewing
