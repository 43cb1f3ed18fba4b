// Rays against triangles: the hierarchy, compared with brute force. Also tests pictures, replay and counters.
#include "topics/hidden/methods/ray_cast.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "unit/methods/scenes.h"

namespace viewing {
namespace {

/// Returns all hits that intersect_triangle() finds, nearest first.
std::vector<RayHit> brute_force(std::span<const Polygon> polygons, const Ray& ray) {
    std::vector<RayHit> hits;
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        const std::vector<glm::dvec3>& v = polygons[i].vertices;
        for (std::size_t k = 1; k + 1 < v.size(); ++k) {
            if (const auto hit = intersect_triangle(ray, {v[0], v[k], v[k + 1]})) {
                hits.push_back({hit->t, static_cast<int>(i), polygons[i].source});
            }
        }
    }
    std::sort(hits.begin(), hits.end(), [](const RayHit& a, const RayHit& b) { return a.t < b.t; });
    return hits;
}

TEST(Bvh, MatchesBruteForce) {
    SCOPED_TRACE(seed);
    Random random(seed);
    std::int64_t hit_count = 0;
    for (int scene = 0; scene < 10; ++scene) {
        std::vector<Polygon> polygons = random_polygons(random);
        const Mesh mesh = torus_mesh(20, 10);
        const MeshInstance instance{&mesh, world_from_model(random.vec3(1), random.angles(), {1, 2, 0.5})};
        for (Polygon& polygon : polygons_of(std::span(&instance, 1)).polygons)
            add(polygons, std::move(polygon.vertices));
        const Bvh bvh(polygons);
        RayCounters counters;
        for (int i = 0; i < 300; ++i) {
            Ray ray{random.vec3(3), random.direction()};
            if (i % 2 == 0) ray.direction = random.vec3(1) - ray.origin;
            if (i % 10 == 0) ray.direction = {0, 0, i % 20 == 0 ? 1 : -2};  // along an axis, not unit length
            const std::vector<RayHit> expected = brute_force(polygons, ray);
            const RayHit nearest = bvh.nearest(ray, 1e300, counters);
            const std::vector<RayHit> all = bvh.all(ray, 1e300, counters);
            ASSERT_EQ(nearest.is_hit(), !expected.empty());
            ASSERT_EQ(all.size(), expected.size());
            if (expected.empty()) continue;
            EXPECT_EQ(nearest.polygon, expected.front().polygon);
            for (std::size_t k = 0; k < all.size(); ++k) {
                EXPECT_EQ(all[k].polygon, expected[k].polygon);
                EXPECT_NEAR(all[k].t, expected[k].t, 1e-9);
            }
            EXPECT_FALSE(bvh.nearest(ray, 0.999 * expected.front().t, counters).is_hit());
            hit_count += static_cast<std::int64_t>(all.size());
        }
        EXPECT_GE(counters.rays, 600);
        EXPECT_LT(counters.triangle_tests, counters.rays * static_cast<std::int64_t>(polygons.size()) / 4);
    }
    EXPECT_GT(hit_count, 2000);
}

/// Bundles must match single rays whatever the scene's size and position, because only the boxes use single precision.
TEST(Bvh, RayBundlesMatchSingleRays) {
    SCOPED_TRACE(seed);
    Random random(seed);
    std::int64_t hit_count = 0;
    for (const double size : {1e-12, 1e-3, 1.0, 1e9}) {
        for (const double distance : {0.0, 3.0, 3e4}) {
            const glm::dvec3 middle = distance * size * random.direction();
            std::vector<Polygon> polygons;
            for (const Polygon& polygon : random_polygons(random)) {
                std::vector<glm::dvec3> vertices = polygon.vertices;
                for (glm::dvec3& vertex : vertices) vertex = middle + size * vertex;
                add(polygons, std::move(vertices));
            }
            const Bvh bvh(polygons);
            for (const std::size_t count : {1U, 3U, 4U, 5U, 8U, 13U}) {
                for (int bundle = 0; bundle < 30; ++bundle) {
                    const glm::dvec3 target = random.vec3(1), origin = random.vec3(bundle % 3 == 0 ? 300 : 3);
                    std::vector<BoundedRay> rays;
                    for (std::size_t i = 0; i < count; ++i) {
                        const glm::dvec3 from = middle + size * (origin + random.vec3(0.1));
                        glm::dvec3 direction = middle + size * (target + random.vec3(0.3)) - from;
                        if (bundle % 5 == 0) direction[static_cast<int>(i % 3)] = 0.0;
                        if (bundle % 7 == 0) direction = {0.0, i % 2 == 0 ? 1.0 : -size, 0.0};
                        rays.push_back({{from, direction}, bundle % 4 == 0 ? 0.9 : 1e300});
                    }
                    std::vector<RayHit> hits(count);
                    RayCounters together, alone;
                    bvh.nearest(rays, hits, together);
                    for (std::size_t i = 0; i < count; ++i) {
                        const RayHit hit = bvh.nearest(rays[i].ray, rays[i].max_t, alone);
                        EXPECT_EQ(hits[i].polygon, hit.polygon);
                        EXPECT_EQ(hits[i].t, hit.t);
                        std::vector<RayHit> expected = brute_force(polygons, rays[i].ray);
                        std::erase_if(expected, [&](const RayHit& other) { return other.t > rays[i].max_t; });
                        ASSERT_EQ(hit.is_hit(), !expected.empty()) << size << " " << distance;
                        EXPECT_EQ(bvh.all(rays[i].ray, rays[i].max_t, alone).size(), expected.size());
                        if (expected.empty()) continue;
                        ++hit_count;
                        EXPECT_NEAR(hit.t, expected.front().t, 1e-6 * expected.front().t);
                    }
                    EXPECT_EQ(together.rays, static_cast<std::int64_t>(count));
                    EXPECT_EQ(2 * together.rays, alone.rays);
                }
            }
        }
    }
    EXPECT_GT(hit_count, 3000);
}

TEST(Bvh, CountsDoNotDependOnTheBundleSize) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Bvh bvh(random_polygons(random));
    RayCounters together, alone;
    for (int bundle = 0; bundle < 100; ++bundle) {
        std::vector<BoundedRay> rays;
        for (int i = 0; i < 8; ++i) rays.push_back({{random.vec3(3), random.direction()}, 1e300});
        std::vector<RayHit> hits(8);
        bvh.nearest(rays, hits, together);
        for (const BoundedRay& ray : rays) bvh.nearest(ray.ray, ray.max_t, alone);
    }
    EXPECT_EQ(together.box_tests, alone.box_tests);
    EXPECT_EQ(together.triangle_tests, alone.triangle_tests);
}

TEST(Bvh, LeavesPartitionTrianglesAndBoxesEnclose) {
    Random random(seed);
    const std::vector<Polygon> polygons = random_polygons(random);
    std::int64_t fans = 0, in_leaves = 0;
    for (const Polygon& polygon : polygons) fans += static_cast<std::int64_t>(polygon.vertices.size()) - 2;
    const Bvh bvh(polygons);
    for (const BvhNode& node : bvh.nodes()) {
        in_leaves += node.triangle_count();
        if (node.is_leaf()) continue;
        for (const int child : {node.first, node.first + 1}) {
            EXPECT_EQ(glm::min(node.corners[0], bvh.nodes()[child].corners[0]), node.corners[0]);
            EXPECT_EQ(glm::max(node.corners[1], bvh.nodes()[child].corners[1]), node.corners[1]);
        }
    }
    EXPECT_EQ(in_leaves, fans);
}

TEST(Bvh, DuplicatesYieldTheLowestSourceInAnyNumber) {
    std::vector<Polygon> polygons;
    for (int i = 0; i < 500; ++i) add(polygons, {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}});
    std::reverse(polygons.begin(), polygons.end());
    const Bvh bvh(polygons);
    RayCounters counters;
    const RayHit hit = bvh.nearest({{0, 0, 5}, {0, 0, -1}}, 100, counters);
    EXPECT_EQ(hit.source, 0);
    EXPECT_EQ(hit.polygon, 499);
    EXPECT_EQ(bvh.all({{0, 0, 5}, {0, 0, -1}}, 100, counters).size(), 500U);
    EXPECT_FALSE(Bvh(std::span<const Polygon>{}).nearest({{0, 0, 5}, {0, 0, -1}}, 100, counters).is_hit());
    WorkProgress progress;
    progress.canceled = true;
    EXPECT_EQ(Bvh(polygons, &progress).nodes().size(), 1U);
}

TEST(PixelRays, MatchThoseOfGeometry) {
    SCOPED_TRACE(seed);
    Random random(seed);
    for (int i = 0; i < 50; ++i) {
        const glm::dmat4 clip_from_world = random_viewpoint(random).clip_from_world();
        const PixelRays rays(clip_from_world, 40, 30);
        const int x = whole_number(random, 0, 39), y = whole_number(random, 0, 29);
        const auto [ray, max_t] = rays.through(x, y);
        const Ray expected = ray_through_pixel(clip_from_world, {(x + 0.5) / 20 - 1, 1 - (y + 0.5) / 15});
        EXPECT_LT(glm::length(ray.origin - expected.origin), 1e-9);
        EXPECT_LT(glm::length(ray.direction - expected.direction), 1e-9);
        const glm::dvec4 end = clip_from_world * glm::dvec4(ray.at(max_t), 1);
        EXPECT_NEAR(end.z / end.w, 1, 1e-9);
    }
}

TEST(CastRays, CountsReplaysAndCancels) {
    Random random(seed);
    const RayScene scene(random_polygons(random));
    const glm::dmat4 clip_from_world = viewpoint_on_z().clip_from_world();
    const RayCastResult all = cast_rays(scene, clip_from_world, {.width = 20, .height = 15});
    EXPECT_EQ(all.counters.rays, 300);
    EXPECT_GT(all.counters.box_tests, 300);
    EXPECT_GT(all.counters.triangle_tests, 100);
    const RayCastResult some = cast_rays(scene, clip_from_world, {.width = 20, .height = 15, .stop_after = 170});
    EXPECT_EQ(some.counters.rays, 170);
    for (std::size_t i = 0; i < 300; ++i)
        EXPECT_EQ(some.image.ids[i], i < 170 ? all.image.ids[i] : IdImage::background);
    WorkProgress progress;
    progress.canceled = true;
    EXPECT_EQ(cast_rays(scene, clip_from_world, {.width = 20, .height = 15}, &progress).counters.rays, 0);
}

TEST(CastRays, IgnoresEverythingBeyondFarOrBeforeNear) {
    std::vector<Polygon> polygons;
    for (const double z : {6.8, 0.0, -20.0}) add(polygons, {{-9, -9, z}, {9, -9, z}, {0, 15, z}});
    const auto ids = [&](double near, double far) {
        const Viewpoint viewpoint = viewpoint_at({0, 0, 7}, {0, 0, 0}, {.near = near, .far = far});
        const int seen = ray_cast_image(polygons, viewpoint).id(48, 36);
        EXPECT_EQ(zbuffer_image(polygons, viewpoint).id(48, 36), seen);
        return seen;
    };
    EXPECT_EQ(ids(0.1, 40), 0);
    EXPECT_EQ(ids(0.5, 40), 1);
    EXPECT_EQ(ids(8, 40), 2);
    EXPECT_EQ(ids(8, 20), IdImage::background);
}

}  // namespace
}  // namespace viewing
