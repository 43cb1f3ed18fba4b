// Ray casting: for every pixel the first surface on the ray through its centre. The reference that the other methods
// are compared with. Read difference.h next. Source: Appel 1968; lecture, Hidden Surface Removal: ray-casting.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "geometry/ray.h"
#include "platform/progress.h"
#include "visibility/bvh.h"
#include "visibility/curved.h"
#include "visibility/id_image.h"

namespace viewing {

/// An exact shape in its place.
struct CurvedShape {
    CurvedKind kind = CurvedKind::sphere;
    glm::dmat4 world_from_model{1.0};  ///< affine, invertible
    int object = 0;
    int source = 0;  ///< its number in id images: one that no polygon has
};

/// What a ray met: a polygon or a curved shape.
struct RayCastHit {
    double t = 0.0;    ///< world units from the near plane
    int polygon = -1;  ///< index into the polygons, or −1
    int curved = -1;   ///< index into the curved shapes, or −1
    int source = -1;
};

/// Triangles and curved shapes, ready for rays.
class RayScene {
public:
    RayScene() = default;
    explicit RayScene(std::span<const Polygon> polygons, std::span<const CurvedShape> curved = {},
                      WorkProgress* progress = nullptr);

    /// The first hit with 0 ≤ t ≤ max_t; source −1 when there is none. The ray's direction is unit.
    RayCastHit nearest(const Ray& ray, double max_t, RayCounters& counters) const;

    /// The same for several rays, `hits` has room for as many; faster where they are neighbours.
    void nearest(std::span<const BoundedRay> rays, std::span<RayCastHit> hits, RayCounters& counters) const;

    /// All hits with 0 ≤ t ≤ max_t, nearest first.
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

/// The rays of a picture, through pixel centres, from the near plane to the far plane. The matrix is invertible with
/// clip range −1 … 1.
class PixelRays {
public:
    PixelRays(const glm::dmat4& clip_from_world, int width, int height);

    /// Unit direction, to the far plane; with an oblique near plane: max_t −1 for a ray that never reaches it, and very
    /// large where the far plane is never reached.
    BoundedRay through(int x, int y) const;

private:
    glm::dvec4 near_origin_, far_origin_, per_x_, per_y_;  ///< world space, homogeneous
};

struct RayCastOptions {
    int width = 0, height = 0;
    std::int64_t stop_after = -1;  ///< replay: stop after so many rays; −1: all
};

struct RayCastResult {
    IdImage image;
    RayCounters counters;
};

/// Row by row from the top. Cancelled: the rows so far, the rest background.
RayCastResult cast_rays(const RayScene& scene, const glm::dmat4& clip_from_world, const RayCastOptions& options,
                        WorkProgress* progress = nullptr);

}  // namespace viewing
