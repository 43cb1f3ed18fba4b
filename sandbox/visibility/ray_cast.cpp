// One ray a pixel. Read difference.cpp next.
#include "visibility/ray_cast.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace viewing {
namespace {

double window_depth_of(const glm::dmat4& clip_from_world, const glm::dvec3& point) {
    const glm::dvec4 clip = clip_from_world * glm::dvec4(point, 1.0);
    return 0.5 * clip.z / clip.w + 0.5;
}

}  // namespace

RayScene::RayScene(std::span<const Polygon> polygons, std::span<const CurvedShape> curved, WorkProgress* progress)
    : bvh_(polygons, progress) {
    for (const CurvedShape& shape : curved) curved_.push_back({shape, glm::inverse(shape.world_from_model)});
}

CurvedHits RayScene::hits_of(const Placed& placed, const Ray& ray, RayCounters& counters) const {
    ++counters.curved_tests;
    return intersect_curved(placed.shape.kind, {glm::dvec3(placed.model_from_world * glm::dvec4(ray.origin, 1.0)),
                                                glm::dvec3(placed.model_from_world * glm::dvec4(ray.direction, 0.0))});
}

RayCastHit RayScene::nearest(const Ray& ray, double max_t, RayCounters& counters) const {
    const RayHit on_polygon = bvh_.nearest(ray, max_t, counters);
    RayCastHit best{on_polygon.t, on_polygon.polygon, -1, on_polygon.source};
    for (std::size_t i = 0; i < curved_.size(); ++i) {
        const CurvedHits hits = hits_of(curved_[i], ray, counters);
        if (hits.empty() || hits[0] > max_t || hits[0] >= best.t) continue;
        best = {hits[0], -1, static_cast<int>(i), curved_[i].shape.source};
    }
    return best;
}

std::vector<RayCastHit> RayScene::all(const Ray& ray, double max_t, RayCounters& counters) const {
    std::vector<RayCastHit> result;
    for (const RayHit& hit : bvh_.all(ray, max_t, counters)) result.push_back({hit.t, hit.polygon, -1, hit.source});
    for (std::size_t i = 0; i < curved_.size(); ++i) {
        for (const double t : hits_of(curved_[i], ray, counters)) {
            if (t <= max_t) result.push_back({t, -1, static_cast<int>(i), curved_[i].shape.source});
        }
    }
    std::sort(result.begin(), result.end(), [](const RayCastHit& a, const RayCastHit& b) {
        return std::tie(a.t, a.source) < std::tie(b.t, b.source);
    });
    return result;
}

PixelRays::PixelRays(const glm::dmat4& clip_from_world, int width, int height) {
    const glm::dmat4 world_from_clip = glm::inverse(clip_from_world);
    per_x_ = world_from_clip[0] * (2.0 / width);
    per_y_ = world_from_clip[1] * (-2.0 / height);
    const glm::dvec4 top_left = world_from_clip[3] - world_from_clip[0] + world_from_clip[1] + 0.5 * (per_x_ + per_y_);
    near_origin_ = top_left - world_from_clip[2];
    far_origin_ = top_left + world_from_clip[2];
}

PixelRays::PixelRay PixelRays::through(int x, int y) const {
    const glm::dvec4 across = static_cast<double>(x) * per_x_ + static_cast<double>(y) * per_y_;
    const glm::dvec4 on_near = near_origin_ + across, on_far = far_origin_ + across;
    const glm::dvec3 origin = glm::dvec3(on_near) / on_near.w;
    // Not the difference of the divided points: w on the far plane is next to 0 when far is far away.
    const glm::dvec3 along = glm::dvec3(on_far) * on_near.w - glm::dvec3(on_near) * on_far.w;
    const double length = glm::length(along);
    // Behind an oblique near plane a ray may never reach that plane, or never leave through the far plane.
    if (!(on_near.w > 0.0)) return {{origin, along / length}, -1.0};
    if (!(on_far.w > 0.0)) return {{origin, along / length}, std::numeric_limits<double>::max()};
    return {{origin, along / length}, length / (on_near.w * on_far.w)};
}

RayCastResult cast_rays(const RayScene& scene, const glm::dmat4& clip_from_world, const RayCastOptions& options,
                        WorkProgress* progress) {
    RayCastResult result;
    result.image = IdImage(options.width, options.height);
    const PixelRays rays(clip_from_world, options.width, options.height);
    for (int y = 0; y < options.height; ++y) {
        if (is_cancelled(progress)) break;
        report(progress, static_cast<double>(y) / options.height);
        for (int x = 0; x < options.width; ++x) {
            if (result.counters.rays == options.stop_after) return result;
            const auto [ray, max_t] = rays.through(x, y);
            const RayCastHit hit = scene.nearest(ray, max_t, result.counters);
            if (hit.source < 0) continue;
            const std::size_t pixel = result.image.index(x, y);
            result.image.ids[pixel] = hit.source;
            result.image.depths[pixel] = window_depth_of(clip_from_world, ray.at(hit.t));
        }
    }
    return result;
}

}  // namespace viewing
