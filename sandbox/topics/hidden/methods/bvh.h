// A bounding-volume hierarchy over triangles, so that a ray tests only a few of them. Read ray_cast.h next. Source:
// Wald 2007 for building with a binned surface-area heuristic; Wald, Slusallek, Benthin and Wagner 2001 for tracing
// neighboring rays together; Möller and Trumbore 1997 for the test of a triangle.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <span>
#include <vector>

#include "geometry/ray.h"
#include "platform/progress.h"
#include "topics/hidden/methods/polygons.h"

namespace viewing {

struct RayHit {
    double t = std::numeric_limits<double>::infinity();  ///< in units of the direction's length
    int polygon = -1;                                    ///< index into the given polygons; −1: no hit
    int source = -1;

    bool is_hit() const { return polygon >= 0; }
};

struct RayCounters {
    std::int64_t rays = 0, box_tests = 0, triangle_tests = 0, curved_tests = 0;
};

/// A ray from t = 0 to max_t; if max_t is negative, the ray hits nothing.
struct BoundedRay {
    Ray ray;
    double max_t;
};

/// The two children of a node are adjacent, at `first` and first + 1. A leaf's triangles begin at `first`.
struct BvhNode {
    /// The lowest and the highest coordinates of the box, relative to the root's middle, in units of its half diagonal.
    std::array<glm::vec3, 2> corners{};
    int first = 0;
    int content = 0;  ///< above 0: a leaf's number of triangles; else the axis of an inner node's cut, negated

    bool is_leaf() const { return content > 0; }
    int triangle_count() const { return is_leaf() ? content : 0; }
    int axis() const { return -content; }  ///< the axis along which the first child comes before the second
};

inline constexpr int deepest_bvh = 60;  ///< limits the stack of a traversal; a leaf this deep may have any size

class Bvh {
public:
    Bvh() = default;

    /// Cuts polygons into fans of triangles. If canceled, finishes the tree immediately with large leaves.
    explicit Bvh(std::span<const Polygon> polygons, WorkProgress* progress = nullptr);

    /// Returns the nearest hit with 0 ≤ t ≤ max_t, from either side, edges included. Of hits that agree to 1e−11 of the
    /// scene's size, returns the one with the lower source, so that coplanar polygons do not fight.
    RayHit nearest(const Ray& ray, double max_t, RayCounters& counters) const;

    /// Does the same for several rays; `hits` must be at least as long as `rays`. This is faster if neighboring rays
    /// take the same path. The counters count each ray's tests separately, however many rays are traced together.
    void nearest(std::span<const BoundedRay> rays, std::span<RayHit> hits, RayCounters& counters) const;

    /// Returns every polygon that the ray meets with 0 ≤ t ≤ max_t, each of them once, sorted by t and then by source.
    std::vector<RayHit> all(const Ray& ray, double max_t, RayCounters& counters) const;

    std::span<const BvhNode> nodes() const { return nodes_; }

private:
    struct Triangle {
        glm::dvec3 a, ab, ac;
        int polygon, source;
    };
    class Build;
    template <typename Lanes>
    struct Together;
    template <typename Lanes>
    void nearest_in(std::span<const BoundedRay> rays, std::span<RayHit> hits, RayCounters& counters) const;
    void nearest_with_avx2(std::span<const BoundedRay> rays, std::span<RayHit> hits, RayCounters& counters) const;

    std::vector<BvhNode> nodes_;  ///< the root first; empty if there are no polygons
    std::vector<Triangle> triangles_;
    glm::dvec3 middle_{0.0};      ///< the middle of the root's box
    double half_diagonal_ = 1.0;  ///< half the diagonal of the root's box, or 1 if the box is a point
    double same_t_ = 0.0;         ///< hits closer together than this are ties; world units
};

}  // namespace viewing
