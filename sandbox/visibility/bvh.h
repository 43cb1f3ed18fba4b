// A bounding-volume hierarchy over triangles: a ray meets few of them. Read ray_cast.h next.
// Source: Wald 2007, building with a binned surface-area heuristic; Möller and Trumbore 1997.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <span>
#include <vector>

#include "geometry/ray.h"
#include "platform/progress.h"
#include "visibility/polygons.h"

namespace viewing {

struct RayHit {
    double t = std::numeric_limits<double>::infinity();  ///< in units of the ray's direction
    int polygon = -1;                                    ///< index into the polygons that were passed; −1: no hit
    int source = -1;

    bool is_hit() const { return polygon >= 0; }
};

struct RayCounters {
    std::int64_t rays = 0, box_tests = 0, triangle_tests = 0, curved_tests = 0;
};

/// Two children lie one after the other: at `first` and first + 1. A leaf has its triangles from `first` on.
struct BvhNode {
    std::array<glm::dvec3, 2> corners{};  ///< of the box: the least and the greatest coordinates
    int first = 0;
    int triangle_count = 0;  ///< 0: an inner node
};

class Bvh {
public:
    Bvh() = default;

    /// Polygons are cut into fans of triangles. Cancelled: the tree is finished at once with large leaves.
    explicit Bvh(std::span<const Polygon> polygons, WorkProgress* progress = nullptr);

    /// The nearest hit with 0 ≤ t ≤ max_t, from either side, edges included. Of hits that agree to 1e−11 of the scene's
    /// size the one with the lower source: coplanar polygons do not fight.
    RayHit nearest(const Ray& ray, double max_t, RayCounters& counters) const;

    /// Every polygon that the ray meets with 0 ≤ t ≤ max_t, nearest first, then by source; each once.
    std::vector<RayHit> all(const Ray& ray, double max_t, RayCounters& counters) const;

    std::span<const BvhNode> nodes() const { return nodes_; }

private:
    struct Triangle {
        glm::dvec3 a, ab, ac;
        int polygon, source;
    };
    class Build;

    template <typename VisitLeaf>
    void traverse(const Ray& ray, const double& max_t, RayCounters& counters, VisitLeaf visit_leaf) const;
    static double intersect(const Ray& ray, const Triangle& triangle);

    std::vector<BvhNode> nodes_;  ///< the root first; empty without polygons
    std::vector<Triangle> triangles_;
    double same_t_ = 0.0;  ///< world units
};

}  // namespace viewing
