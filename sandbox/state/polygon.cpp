#include "state/polygon.h"

#include <numeric>

namespace viewing {

namespace {

constexpr std::size_t most_clipped_corners = 256;

/// Twice the polygon's area times its normal (Newell), which also holds for concave polygons.
glm::dvec3 area_normal(std::span<const glm::vec3> corners) {
    glm::dvec3 normal(0.0);
    const glm::dvec3 origin(corners[0]);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec3 a = glm::dvec3(corners[i]) - origin;
        const glm::dvec3 b = glm::dvec3(corners[(i + 1) % corners.size()]) - origin;
        normal += glm::cross(a, b);
    }
    return normal;
}

/// How far to the left of a → b the point c lies, seen against the normal: twice the triangle's area.
double turn(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::dvec3& normal) {
    return glm::dot(glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a)), normal);
}

/// Whether the corner before, at and after `at` can be cut off: it turns left and no other corner lies in it.
bool is_ear(std::span<const glm::vec3> corners, const std::vector<std::uint32_t>& left, std::size_t at,
            const glm::dvec3& normal) {
    const std::size_t count = left.size();
    const std::size_t before = (at + count - 1) % count;
    const std::size_t after = (at + 1) % count;
    const glm::vec3& a = corners[left[before]];
    const glm::vec3& b = corners[left[at]];
    const glm::vec3& c = corners[left[after]];
    if (turn(a, b, c, normal) <= 0.0) {
        return false;
    }
    for (std::size_t i = 0; i < count; ++i) {
        const glm::vec3& p = corners[left[i]];
        if (i == before || i == at || i == after || p == a || p == b || p == c) {
            continue;
        }
        if (turn(a, b, p, normal) >= 0.0 && turn(b, c, p, normal) >= 0.0 && turn(c, a, p, normal) >= 0.0) {
            return false;
        }
    }
    return true;
}

}  // namespace

void triangulate(std::span<const glm::vec3> corners, std::vector<std::uint32_t>& triangles) {
    std::vector<std::uint32_t> left(corners.size());
    std::iota(left.begin(), left.end(), 0U);
    if (corners.size() > 3 && corners.size() <= most_clipped_corners) {
        const glm::dvec3 normal = area_normal(corners);
        for (std::size_t at = 0, tried = 0; left.size() > 3 && tried < left.size();) {
            at %= left.size();
            if (!is_ear(corners, left, at, normal)) {
                ++at;
                ++tried;
                continue;
            }
            const std::size_t count = left.size();
            triangles.insert(triangles.end(), {left[(at + count - 1) % count], left[at], left[(at + 1) % count]});
            left.erase(left.begin() + static_cast<std::ptrdiff_t>(at));
            tried = 0;
        }
    }
    // A triangle, a big polygon, or what is left of one that crosses itself: a fan.
    for (std::size_t i = 1; i + 1 < left.size(); ++i) {
        triangles.insert(triangles.end(), {left[0], left[i], left[i + 1]});
    }
}

}  // namespace viewing
