// Intersects rays exactly with the curved shapes of the scene format, without any triangles: an advantage of ray
// casting that the lecture mentions. Read ray_cast.h next.
#pragma once

#include <array>
#include <cstddef>
#include <glm/glm.hpp>

#include "geometry/ray.h"

namespace viewing {

/// The curved shapes in model space, as geometry/shapes.h makes them: a sphere of radius 1; a closed cylinder and a
/// closed cone of radius 1 from y = −1 to 1, the cone's tip up; a torus with radii 0.9 and 0.34 about y.
enum class CurvedKind { sphere, cylinder, cone, torus };

/// The points where a ray crosses a surface: at most four, nearest first, t ≥ 0 in units of the direction's length.
class CurvedHits {
public:
    const double* begin() const { return t_.data(); }
    const double* end() const { return t_.data() + count_; }
    double operator[](std::size_t i) const { return t_[i]; }
    std::size_t size() const { return count_; }
    bool empty() const { return count_ == 0; }

    /// Adds a hit, in any order; ignores hits behind the ray's origin.
    void add(double t);

private:
    std::array<double, 4> t_{};
    std::size_t count_ = 0;
};

/// Returns the hits of a ray in model space. The direction need not have length 1, so t is the same as in world space
/// if model_from_world was applied to both origin and direction. A ray that only touches the surface, or runs within a
/// straight side or a cap, misses. A direction of length 0 misses.
CurvedHits intersect_curved(CurvedKind kind, const Ray& ray_in_model);

/// Returns the outward unit normal in model space at a point of the surface; on a rim, the normal of one of the two
/// sides.
glm::dvec3 normal_of_curved(CurvedKind kind, const glm::dvec3& point_in_model);

}  // namespace viewing
