// Picking: rays, checked against values computed by hand and against each other.
#include "geometry/ray.h"

#include <gtest/gtest.h>

#include "geometry/plane.h"
#include "geometry/projection.h"
#include "geometry/shapes.h"
#include "unit/geometry/random.h"

namespace viewing {
namespace {

TEST(RayThroughPixel, ItsPointsProjectToThePixel) {
    SCOPED_TRACE(seed);
    Random random(seed);
    for (const bool orthographic : {false, true}) {
        for (const double far : {40.0, 1e9, 1e12}) {
            const glm::dmat4 clip_from_world =
                clip_from_view({.orthographic = orthographic, .near = 0.01, .far = far}, 1.6) *
                view_from_world(world_from_view({3, 4, 5}, {30, -20, 10}));
            for (int i = 0; i < 50; ++i) {
                const glm::dvec2 ndc(random.number(-1, 1), random.number(-1, 1));
                const Ray ray = ray_through_pixel(clip_from_world, ndc);
                EXPECT_NEAR(glm::length(ray.direction), 1, 1e-12);
                const glm::dvec4 start = clip_from_world * glm::dvec4(ray.origin, 1);
                EXPECT_NEAR(start.z / start.w, -1, 1e-6);
                // A point on an orthographic near plane is computed as a difference of numbers as large as far.
                const double tolerance = orthographic ? 1e-16 * far + 1e-8 : 1e-8;
                for (const double t : {0.0, 1.0, 30.0}) {
                    const glm::dvec4 clip = clip_from_world * glm::dvec4(ray.at(t), 1);
                    EXPECT_GT(clip.w, 0);
                    EXPECT_NEAR(clip.x / clip.w, ndc.x, tolerance);
                    EXPECT_NEAR(clip.y / clip.w, ndc.y, tolerance);
                }
            }
        }
    }
}

TEST(IntersectPlane, ByHand) {
    EXPECT_DOUBLE_EQ(*intersect_plane({{0, 3, 0}, {0, -1, 0}}, {0, 1, 0, -1}), 2.0);
    EXPECT_DOUBLE_EQ(*intersect_plane({{0, 3, 0}, {0, -2, 0}}, {0, -5, 0, 5}), 1.0) << "in units of the direction";
    EXPECT_FALSE(intersect_plane({{0, 3, 0}, {0, 1, 0}}, {0, 1, 0, 0})) << "behind";
    EXPECT_FALSE(intersect_plane({{0, 3, 0}, {1, 0, 0}}, {0, 1, 0, 0})) << "parallel";
}

TEST(ClosestPointOnLine, ByHand) {
    // A ray along −z, one unit above the x axis, passes over x = 4.
    EXPECT_DOUBLE_EQ(*closest_point_parameter_on_line({{4, 1, 9}, {0, 0, -1}}, {0, 0, 0}, {2, 0, 0}), 2.0);
    EXPECT_FALSE(closest_point_parameter_on_line({{0, 1, 0}, {3, 0, 0}}, {0, 0, 0}, {1, 0, 0})) << "parallel";
    EXPECT_FALSE(closest_point_parameter_on_line({{4, 1, 9}, {0, 0, 1}}, {0, 0, 0}, {1, 0, 0})) << "behind";
}

TEST(ClosestPointOnLine, NoOtherPointIsCloser) {
    SCOPED_TRACE(seed);
    Random random(seed);
    int checked = 0;
    for (int i = 0; i < 100; ++i) {
        const Ray ray{random.vec3(5), random.direction()};
        const glm::dvec3 origin = random.vec3(5), direction = random.direction() * 3.0;
        const std::optional<double> s = closest_point_parameter_on_line(ray, origin, direction);
        if (!s) {
            continue;
        }
        const auto distance = [&](double parameter) {
            const glm::dvec3 offset = origin + parameter * direction - ray.origin;
            return glm::length(offset - glm::dot(offset, ray.direction) * ray.direction);
        };
        EXPECT_LE(distance(*s), distance(*s + 1e-3));
        EXPECT_LE(distance(*s), distance(*s - 1e-3));
        ++checked;
    }
    EXPECT_GT(checked, 30);
}

TEST(IntersectTriangle, HitsTheChosenPoint) {
    SCOPED_TRACE(seed);
    Random random(seed);
    for (int i = 0; i < 300; ++i) {
        const std::array<glm::dvec3, 3> triangle = {random.vec3(5), random.vec3(5), random.vec3(5)};
        const double area = glm::length(glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]));
        const glm::dvec3 b(random.number(-1, 2), random.number(-1, 2), 0);
        const glm::dvec3 weights(1 - b.x - b.y, b.x, b.y);
        const glm::dvec3 point = weights.x * triangle[0] + weights.y * triangle[1] + weights.z * triangle[2];
        const glm::dvec3 direction = random.direction();
        const auto hit = intersect_triangle({point - 2.0 * direction, direction}, triangle);
        const double inside = std::min({weights.x, weights.y, weights.z});
        if (area < 1 || std::abs(inside) < 1e-6) {
            continue;
        }
        ASSERT_EQ(hit.has_value(), inside > 0);
        if (hit) {
            EXPECT_NEAR(hit->t, 2, 1e-6);
            EXPECT_LT(glm::length(hit->barycentric - weights), 1e-6);
        }
    }
}

TEST(IntersectTriangle, MissesBehindEdgeOnAndDegenerate) {
    const std::array<glm::dvec3, 3> triangle = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
    EXPECT_TRUE(intersect_triangle({{0.2, 0.2, 1}, {0, 0, -1}}, triangle));
    EXPECT_TRUE(intersect_triangle({{0.2, 0.2, -1}, {0, 0, 1}}, triangle)) << "from the back";
    EXPECT_FALSE(intersect_triangle({{0.2, 0.2, 1}, {0, 0, 1}}, triangle)) << "behind";
    EXPECT_FALSE(intersect_triangle({{-1, 0.2, 0}, {1, 0, 0}}, triangle)) << "edge-on";
    EXPECT_FALSE(intersect_triangle({{0, 0, 1}, {0, 0, -1}}, {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}})) << "no area";
}

TEST(IntersectMesh, ReturnsTheNearestHitOfASphere) {
    SCOPED_TRACE(seed);
    const Mesh sphere = sphere_mesh(96, 48);
    Random random(seed);
    for (int i = 0; i < 20; ++i) {
        const glm::dvec3 from = random.direction() * 5.0;
        const auto hit = intersect_mesh({from, -from / 5.0}, sphere);
        ASSERT_TRUE(hit);
        EXPECT_NEAR(hit->t, 4.0, 5e-3);
        glm::dvec3 point(0);
        for (int k = 0; k < 3; ++k) {
            point += hit->barycentric[k] * glm::dvec3(sphere.positions[sphere.indices[3 * hit->triangle + k]]);
        }
        EXPECT_LT(glm::length(point - (from - hit->t * from / 5.0)), 1e-6);
        EXPECT_FALSE(intersect_mesh({from, from}, sphere));
    }
    EXPECT_FALSE(intersect_mesh({{0, 0, 0}, {0, 0, 1}}, Mesh{}));
}

}  // namespace
}  // namespace viewing
