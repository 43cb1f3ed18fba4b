// Casts one ray per pixel. Read difference.cpp next.
#include "topics/hidden/methods/ray_cast.h"

#include <algorithm>
#include <array>
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

void RayScene::nearest(std::span<const BoundedRay> rays, std::span<RayCastHit> hits, RayCounters& counters) const {
    std::array<RayHit, 8> on_polygons;
    for (std::size_t first = 0; first < rays.size(); first += on_polygons.size()) {
        const auto some = rays.subspan(first, std::min(on_polygons.size(), rays.size() - first));
        bvh_.nearest(some, on_polygons, counters);
        for (std::size_t i = 0; i < some.size(); ++i) {
            RayCastHit& best = hits[first + i];
            best = {on_polygons[i].t, on_polygons[i].polygon, -1, on_polygons[i].source};
            for (std::size_t k = 0; k < curved_.size(); ++k) {
                const CurvedHits curved = hits_of(curved_[k], some[i].ray, counters);
                if (curved.empty() || curved[0] > some[i].max_t || curved[0] >= best.t) continue;
                best = {curved[0], -1, static_cast<int>(k), curved_[k].shape.source};
            }
        }
    }
}

RayCastHit RayScene::nearest(const Ray& ray, double max_t, RayCounters& counters) const {
    const BoundedRay only{ray, max_t};
    RayCastHit hit;
    nearest(std::span(&only, 1), std::span(&hit, 1), counters);
    return hit;
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

BoundedRay PixelRays::through(int x, int y) const {
    const glm::dvec4 across = static_cast<double>(x) * per_x_ + static_cast<double>(y) * per_y_;
    const glm::dvec4 on_near = near_origin_ + across, on_far = far_origin_ + across;
    const glm::dvec3 origin = glm::dvec3(on_near) / on_near.w;
    // Subtracting the points after the division by w would be inexact: if far is very large, w on the far plane is
    // almost 0.
    const glm::dvec3 along = glm::dvec3(on_far) * on_near.w - glm::dvec3(on_near) * on_far.w;
    const double length = glm::length(along);
    // With an oblique near plane, a ray may never reach that plane, or never leave through the far plane.
    if (!(on_near.w > 0.0)) return {{origin, along / length}, -1.0};
    if (!(on_far.w > 0.0)) return {{origin, along / length}, std::numeric_limits<double>::max()};
    return {{origin, along / length}, length / (on_near.w * on_far.w)};
}

RayCastResult cast_rays(const RayScene& scene, const glm::dmat4& clip_from_world, const RayCastOptions& options,
                        WorkProgress* progress) {
    // Neighboring rays mostly meet the same boxes, so the rays of four by two pixels are traced together.
    constexpr int across = 4, down = 2;
    RayCastResult result;
    result.image = IdImage(options.width, options.height);
    const std::size_t pixels = result.image.ids.size();
    const std::size_t end =
        options.stop_after < 0 ? pixels : std::min(pixels, static_cast<std::size_t>(options.stop_after));
    const PixelRays rays(clip_from_world, options.width, options.height);
    std::array<BoundedRay, across * down> some;
    std::array<std::size_t, across * down> pixel_of;
    std::array<RayCastHit, across * down> hits;
    for (int top = 0; top < options.height && result.image.index(0, top) < end; top += down) {
        if (is_canceled(progress)) break;
        report(progress, static_cast<double>(top) / options.height);
        for (int left = 0; left < options.width; left += across) {
            std::size_t count = 0;
            for (int y = top; y < std::min(top + down, options.height); ++y) {
                for (int x = left; x < std::min(left + across, options.width); ++x) {
                    pixel_of[count] = result.image.index(x, y);
                    if (pixel_of[count] < end) some[count++] = rays.through(x, y);
                }
            }
            scene.nearest(std::span(some).first(count), hits, result.counters);
            for (std::size_t i = 0; i < count; ++i) {
                if (hits[i].source < 0) continue;
                result.image.ids[pixel_of[i]] = hits[i].source;
                result.image.depths[pixel_of[i]] = window_depth_of(clip_from_world, some[i].ray.at(hits[i].t));
            }
        }
    }
    return result;
}

}  // namespace viewing
