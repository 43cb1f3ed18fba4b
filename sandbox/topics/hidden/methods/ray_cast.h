// Ray casting: finds for every pixel the first surface on the ray through its center. It is the reference for the other
// methods. Read difference.h next. Source: Appel 1968; lecture, Hidden Surface Removal: ray-casting.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "geometry/ray.h"
#include "image/id_image.h"
#include "platform/progress.h"
#include "topics/hidden/methods/bvh.h"
#include "topics/hidden/methods/curved.h"

namespace viewing {

/// A placed curved shape, for exact intersections.
struct CurvedShape {
    CurvedKind kind = CurvedKind::sphere;
    glm::dmat4 world_from_model{1.0};  ///< affine, invertible
    int object = 0;
    int source = 0;  ///< its number in ID images, different from every polygon's
};

/// A ray's hit on a polygon or on a curved shape.
struct RayCastHit {
    double t = 0.0;    ///< world units from the ray's origin
    int polygon = -1;  ///< index into the polygons, or −1
    int curved = -1;   ///< index into the curved shapes, or −1
    int source = -1;
};

/// Triangles and curved shapes, prepared for ray casting.
class RayScene {
public:
    RayScene() = default;
    explicit RayScene(std::span<const Polygon> polygons, std::span<const CurvedShape> curved = {},
                      WorkProgress* progress = nullptr);

    /// Returns the first hit with 0 ≤ t ≤ max_t; source −1 if there is none. The ray's direction must have length 1.
    RayCastHit nearest(const Ray& ray, double max_t, RayCounters& counters) const;

    /// Does the same for several rays; `hits` must be at least as long as `rays`. Neighboring rays are traced faster.
    void nearest(std::span<const BoundedRay> rays, std::span<RayCastHit> hits, RayCounters& counters) const;

    /// Returns all hits with 0 ≤ t ≤ max_t, nearest first.
    std::vector<RayCastHit> all(const Ray& ray, double max_t, RayCounters& counters) const;

    const Bvh& bvh() const { return bvh_; }

private:
    struct Placed {
        CurvedShape shape;
        glm::dmat4 model_from_world;
    };
    CurvedHits hits_of(const Placed& placed, const Ray& ray, RayCounters& counters) const;

    Bvh bvh_;
    std::vector<Placed> curved_;
};

/// The rays of a picture, through pixel centers, from the near plane to the far plane. The matrix must be invertible
/// and have a clip range of −1 … 1.
class PixelRays {
public:
    PixelRays(const glm::dmat4& clip_from_world, int width, int height);

    /// Returns a ray with a unit direction that ends at the far plane. With an oblique near plane, max_t is −1 for a
    /// ray that never reaches the near plane, and very large for one that never reaches the far plane.
    BoundedRay through(int x, int y) const;

private:
    glm::dvec4 near_origin_, far_origin_, per_x_, per_y_;  ///< world space, homogeneous
};

struct RayCastOptions {
    int width = 0, height = 0;
    std::int64_t stop_after = -1;  ///< replay: stop after this many rays; −1: all
};

struct RayCastResult {
    IdImage image;
    RayCounters counters;
};

/// Casts the rays row by row from the top. If canceled, returns the rows so far; the rest is background.
RayCastResult cast_rays(const RayScene& scene, const glm::dmat4& clip_from_world, const RayCastOptions& options,
                        WorkProgress* progress = nullptr);

}  // namespace viewing
