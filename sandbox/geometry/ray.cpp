// Intersections in double precision. Read navigation.cpp next.
#include "geometry/ray.h"

#include <cmath>

namespace viewing {
namespace {

/// Two directions count as parallel if the sine of the angle between them is at most this.
constexpr double parallel_sine = 1e-12;

}  // namespace

Ray ray_through_pixel(const glm::dmat4& clip_from_world, const glm::dvec2& ndc) {
    const glm::dmat4 world_from_clip = glm::inverse(clip_from_world);
    const glm::dvec4 on_near = world_from_clip * glm::dvec4(ndc, -1.0, 1.0);
    const glm::dvec4 on_far = world_from_clip * glm::dvec4(ndc, 1.0, 1.0);
    // Subtracting the points after the division by w would be inexact: if far is very large, w on the far plane is
    // almost 0.
    const glm::dvec3 direction = glm::dvec3(on_far) * on_near.w - glm::dvec3(on_near) * on_far.w;
    return {glm::dvec3(on_near) / on_near.w, glm::normalize(direction)};
}

std::optional<double> intersect_plane(const Ray& ray, const glm::dvec4& plane) {
    const glm::dvec3 normal(plane);
    const double approach = glm::dot(normal, ray.direction);
    if (std::abs(approach) <= parallel_sine * glm::length(normal) * glm::length(ray.direction)) {
        return std::nullopt;
    }
    const double t = -(glm::dot(normal, ray.origin) + plane.w) / approach;
    return t >= 0.0 ? std::optional(t) : std::nullopt;
}

std::optional<double> closest_point_parameter_on_line(const Ray& ray, const glm::dvec3& origin,
                                                      const glm::dvec3& direction) {
    // The segment between the nearest points is perpendicular to both directions.
    const glm::dvec3 offset = ray.origin - origin;
    const double rr = glm::dot(ray.direction, ray.direction), ll = glm::dot(direction, direction);
    const double rl = glm::dot(ray.direction, direction);
    const double ro = glm::dot(ray.direction, offset), lo = glm::dot(direction, offset);
    const double twice_area = glm::length(glm::cross(ray.direction, direction));
    if (twice_area <= parallel_sine * std::sqrt(rr * ll)) {
        return std::nullopt;
    }
    const double determinant = twice_area * twice_area;
    if (rl * lo - ll * ro < 0.0) {  // this is t · determinant
        return std::nullopt;
    }
    return (rr * lo - rl * ro) / determinant;
}

std::optional<TriangleHit> intersect_triangle(const Ray& ray, const std::array<glm::dvec3, 3>& triangle) {
    const glm::dvec3 ab = triangle[1] - triangle[0], ac = triangle[2] - triangle[0];
    const glm::dvec3 across = glm::cross(ray.direction, ac);
    const double volume = glm::dot(ab, across);
    if (std::abs(volume) <= parallel_sine * glm::length(ab) * glm::length(ac) * glm::length(ray.direction)) {
        return std::nullopt;
    }
    const glm::dvec3 from_a = ray.origin - triangle[0];
    const glm::dvec3 around = glm::cross(from_a, ab);
    const double b = glm::dot(from_a, across) / volume;
    const double c = glm::dot(ray.direction, around) / volume;
    const double t = glm::dot(ac, around) / volume;
    if (b < 0.0 || c < 0.0 || b + c > 1.0 || t < 0.0) {
        return std::nullopt;
    }
    return TriangleHit{t, {1.0 - b - c, b, c}};
}

bool meets_box(const Ray& ray, const Bounds& box, double limit) {
    double enter = 0.0, leave = limit;
    for (int axis = 0; axis < 3; ++axis) {
        if (ray.direction[axis] == 0.0) {
            if (ray.origin[axis] < box.min[axis] || ray.origin[axis] > box.max[axis]) return false;
            continue;
        }
        const double a = (box.min[axis] - ray.origin[axis]) / ray.direction[axis],
                     b = (box.max[axis] - ray.origin[axis]) / ray.direction[axis];
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    return enter <= leave;
}

std::optional<MeshHit> intersect_mesh(const Ray& ray_in_model, const Mesh& mesh) {
    std::optional<MeshHit> nearest;
    for (std::size_t triangle = 0; triangle < mesh.triangle_count(); ++triangle) {
        const std::uint32_t* corner = &mesh.indices[3 * triangle];
        const auto hit = intersect_triangle(
            ray_in_model, {mesh.positions[corner[0]], mesh.positions[corner[1]], mesh.positions[corner[2]]});
        if (hit && (!nearest || hit->t < nearest->t)) {
            nearest = MeshHit{triangle, hit->t, hit->barycentric};
        }
    }
    return nearest;
}

}  // namespace viewing
