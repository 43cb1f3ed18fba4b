// Curved shapes, checked by hand, by sampling along random rays, and against fine tessellations.
#include "topics/hidden/methods/curved.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "unit/methods/scenes.h"

namespace viewing {
namespace {

constexpr std::array kinds{CurvedKind::sphere, CurvedKind::cylinder, CurvedKind::cone, CurvedKind::torus};

/// Returns a value that is negative inside the shape and positive outside it.
double outside_by(CurvedKind kind, const glm::dvec3& p) {
    const double radius = std::hypot(p.x, p.z);
    switch (kind) {
        case CurvedKind::sphere:
            return glm::length(p) - 1;
        case CurvedKind::cylinder:
            return std::max(radius - 1, std::abs(p.y) - 1);
        case CurvedKind::cone:
            return std::max((2 * radius + p.y - 1) / std::sqrt(5.0), -1 - p.y);
        case CurvedKind::torus:
            return std::hypot(radius - 0.9, p.y) - 0.34;
    }
    return 0;
}

void expect_hits(CurvedKind kind, const Ray& ray, std::vector<double> expected) {
    const CurvedHits hits = intersect_curved(kind, ray);
    ASSERT_EQ(hits.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(hits[i], expected[i], 1e-12);
}

/// Returns whether all neighbors of this pixel have the same value.
bool is_inside(const IdImage& image, std::size_t pixel) {
    const int x = static_cast<int>(pixel) % image.width, y = static_cast<int>(pixel) / image.width;
    for (int ny = std::max(y - 1, 0); ny <= std::min(y + 1, image.height - 1); ++ny)
        for (int nx = std::max(x - 1, 0); nx <= std::min(x + 1, image.width - 1); ++nx)
            if (image.id(nx, ny) != image.ids[pixel]) return false;
    return true;
}

TEST(IntersectCurved, ByHand) {
    expect_hits(CurvedKind::sphere, {{0, 0, 5}, {0, 0, -1}}, {4, 6});
    expect_hits(CurvedKind::sphere, {{0, 0, 5}, {0, 0, -2}}, {2, 3});
    expect_hits(CurvedKind::sphere, {{0, 0, 0}, {1, 0, 0}}, {1});
    expect_hits(CurvedKind::sphere, {{0, 2, 5}, {0, 0, -1}}, {});
    expect_hits(CurvedKind::sphere, {{0, 0, 5}, {0, 0, 1}}, {});
    expect_hits(CurvedKind::cylinder, {{0.5, 5, 0}, {0, -1, 0}}, {4, 6});
    expect_hits(CurvedKind::cylinder, {{1.5, 5, 0}, {0, -1, 0}}, {});
    expect_hits(CurvedKind::cylinder, {{5, 0.5, 0}, {-1, 0, 0}}, {4, 6});
    expect_hits(CurvedKind::cylinder, {{5, 1.5, 0}, {-1, 0, 0}}, {});
    expect_hits(CurvedKind::cylinder, {{-2, 1.5, 0}, {1, -1, 0}}, {1, 2.5});  // in at the side, out at the base
    expect_hits(CurvedKind::cone, {{0, 5, 0}, {0, -1, 0}}, {4, 6});           // through the tip
    expect_hits(CurvedKind::cone, {{0.5, 5, 0}, {0, -1, 0}}, {5, 6});
    expect_hits(CurvedKind::cone, {{5, 0, 0}, {-1, 0, 0}}, {4.5, 5.5});
    expect_hits(CurvedKind::cone, {{5, 2, 0}, {-1, 0, 0}}, {});       // would hit the upper half of the double cone
    expect_hits(CurvedKind::cone, {{0.25, 3, 0}, {0.5, -1, 0}}, {});  // parallel to the side, just outside
    expect_hits(CurvedKind::cone, {{-1.25, 3, 0}, {0.5, -1, 0}}, {2.25, 4});  // parallel to the side, inside
    expect_hits(CurvedKind::torus, {{5, 0, 0}, {-1, 0, 0}}, {3.76, 4.44, 5.56, 6.24});
    expect_hits(CurvedKind::torus, {{0.9, 5, 0}, {0, -1, 0}}, {4.66, 5.34});
    expect_hits(CurvedKind::torus, {{0, 5, 0}, {0, -1, 0}}, {});  // through the hole
    expect_hits(CurvedKind::torus, {{0, 0, 0}, {0, 0, 3}}, {0.56 / 3, 1.24 / 3});
    expect_hits(CurvedKind::torus, {{0.9, 0, 0}, {0, 0, 1}},
                {std::sqrt(1.24 * 1.24 - 0.9 * 0.9)});  // from inside the tube
}

TEST(IntersectCurved, RandomRaysCrossTheSurfaceAtTheHits) {
    SCOPED_TRACE(seed);
    Random random(seed);
    for (const CurvedKind kind : kinds) {
        int hit_count = 0;
        for (int i = 0; i < 3000; ++i) {
            const Ray ray{random.vec3(2), random.number(0.1, 3) * random.direction()};
            const auto hits = intersect_curved(kind, ray);
            double low = 0;
            for (const double t : hits) {
                ASSERT_NEAR(outside_by(kind, ray.at(t)), 0, 1e-9);
                EXPECT_GE(t, low);
                low = t;
                ++hit_count;
            }
            // Between two hits the sign is constant, and it changes at each hit.
            bool is_outside = outside_by(kind, ray.origin) > 0;
            double begin = 0;
            for (std::size_t k = 0; k <= hits.size(); ++k) {
                const double end = k < hits.size() ? hits[k] : begin + 60;
                for (int sample = 1; sample < 40; ++sample) {
                    const double distance = outside_by(kind, ray.at(begin + (end - begin) * sample / 40));
                    ASSERT_TRUE(std::abs(distance) < 1e-9 || (distance > 0) == is_outside);
                }
                is_outside = !is_outside;
                begin = end;
            }
            EXPECT_FALSE(is_outside) << "the last stretch is outside";
        }
        EXPECT_GT(hit_count, 500);
    }
}

TEST(IntersectCurved, IsExactFromFarAwayAndNearTangents) {
    SCOPED_TRACE(seed);
    Random random(seed);
    for (int i = 0; i < 500; ++i) {
        // Aim at a known point of the tube from a million units away.
        const double u = random.number(0, 6.28), v = random.number(0, 6.28);
        const glm::dvec3 outward(std::cos(u), 0, std::sin(u));
        const glm::dvec3 normal = std::cos(v) * outward + glm::dvec3(0, std::sin(v), 0);
        const glm::dvec3 point = 0.9 * outward + 0.34 * normal;
        glm::dvec3 direction = random.direction();
        if (std::abs(glm::dot(direction, normal)) < 0.1) continue;
        const auto hits = intersect_curved(CurvedKind::torus, {point - 1e6 * direction, direction});
        const double error = [&] {
            double best = 1e300;
            for (const double t : hits) best = std::min(best, std::abs(t - 1e6));
            return best;
        }();
        EXPECT_LT(error, 1e-8);
        EXPECT_EQ(hits.size() % 2, 0U);
    }
    for (const double gap : {1e-3, 1e-6, 1e-9}) {
        // Near the top of the tube, whose height is 0.34, a ray either enters and leaves the tube or misses it.
        const double half = std::sqrt(0.34 * 0.34 - (0.34 - gap) * (0.34 - gap));
        const auto low = intersect_curved(CurvedKind::torus, {{5, 0.34 - gap, 0}, {-1, 0, 0}});
        ASSERT_EQ(low.size(), 4U) << gap;
        EXPECT_NEAR(low[1] - low[0], 2 * half, 1e-3 * half);
        EXPECT_TRUE(intersect_curved(CurvedKind::torus, {{5, 0.34 + gap, 0}, {-1, 0, 0}}).empty()) << gap;
        EXPECT_EQ(intersect_curved(CurvedKind::sphere, {{1 - gap, 0, 5}, {0, 0, -1}}).size(), 2U);
        EXPECT_TRUE(intersect_curved(CurvedKind::sphere, {{1 + gap, 0, 5}, {0, 0, -1}}).empty());
    }
    for (const CurvedKind kind : kinds) EXPECT_TRUE(intersect_curved(kind, {{0, 0, 0.9}, {0, 0, 0}}).empty());
}

TEST(NormalOfCurved, PointsAlongTheOutwardGradient) {
    SCOPED_TRACE(seed);
    Random random(seed);
    for (const CurvedKind kind : kinds) {
        for (int i = 0; i < 300; ++i) {
            const Ray ray{3.0 * random.direction(), random.vec3(1)};
            for (const double t : intersect_curved(kind, ray)) {
                const glm::dvec3 point = ray.at(t), normal = normal_of_curved(kind, point);
                EXPECT_NEAR(glm::length(normal), 1, 1e-12);
                EXPECT_NEAR(outside_by(kind, point + 1e-5 * normal), 1e-5, 1e-9);
            }
        }
    }
}

TEST(CastRays, CurvedShapesMatchTheirFineTessellations) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const std::array meshes{sphere_mesh(512, 256), cylinder_mesh(512), cone_mesh(512), torus_mesh(512, 256)};
    for (std::size_t k = 0; k < kinds.size(); ++k) {
        for (int view = 0; view < 3; ++view) {
            const glm::dmat4 pose = world_from_model(random.vec3(0.4), random.angles(), {1.3, 0.8, 1.0});
            const Viewpoint viewpoint = viewpoint_at(random.number(3, 5) * random.direction(), {0, 0, 0});
            std::vector<Polygon> card;
            add(card, {{-2, -2, 0.1}, {2, -2, -0.3}, {0, 2, 0}});
            std::vector<Polygon> tessellated = card;
            const MeshInstance instance{&meshes[k], pose};
            for (Polygon& polygon : polygons_of(std::span(&instance, 1)).polygons) {
                polygon.source = 1;
                tessellated.push_back(std::move(polygon));
            }
            const CurvedShape shape{kinds[k], pose, 1, 1};
            const RayCastOptions size{.width = test_width, .height = test_height};
            const RayCastResult exact =
                cast_rays(RayScene(card, std::span(&shape, 1)), viewpoint.clip_from_world(), size);
            const IdImage fine = ray_cast_image(tessellated, viewpoint);
            EXPECT_EQ(exact.counters.curved_tests, test_width * test_height);
            EXPECT_EQ(difference(fine, exact.image).different, 0);
            int shape_pixels = 0;
            for (std::size_t i = 0; i < fine.ids.size(); ++i) {
                if (!is_inside(fine, i) || fine.ids[i] != 1) continue;
                ++shape_pixels;
                EXPECT_NEAR(exact.image.depths[i], fine.depths[i], 2e-3);
            }
            EXPECT_GT(shape_pixels, 200);
        }
    }
}

TEST(RayScene, SortsHitsOfPolygonsAndShapes) {
    std::vector<Polygon> card;
    add(card, {{-3, -3, 0}, {3, -3, 0}, {0, 5, 0}});
    const std::vector<CurvedShape> shapes{{CurvedKind::sphere, glm::dmat4(1), 1, 1},
                                          {CurvedKind::torus, world_from_model({0, 0, -3}, {}, {1, 1, 1}), 2, 2}};
    RayCounters counters;
    const auto hits = RayScene(card, shapes).all({{0, 0, 5}, {0, 0, -1}}, 100, counters);
    std::vector<int> sources;
    for (const RayCastHit& hit : hits) sources.push_back(hit.source);
    EXPECT_EQ(sources, (std::vector{1, 0, 1, 2, 2, 2, 2}));
    EXPECT_EQ(hits[0].curved, 0);
    EXPECT_EQ(hits[1].polygon, 0);
    EXPECT_NEAR(hits[3].t, 8 - 1.24, 1e-12);
    EXPECT_EQ(RayScene(card, shapes).all({{0, 0, 5}, {0, 0, -1}}, 6.5, counters).size(), 3U);
}

}  // namespace
}  // namespace viewing
