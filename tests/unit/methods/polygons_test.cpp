// Polygons: creation, rejection, measures, and cuts.
#include "topics/hidden/methods/polygons.h"

#include <gtest/gtest.h>

#include <limits>

#include "unit/methods/scenes.h"

namespace viewing {
namespace {

TEST(MakePolygon, ComputesPlaneAreaAndCentroid) {
    const Polygon square = make_polygon({{0, 2, 0}, {0, 2, 3}, {3, 2, 3}, {3, 2, 0}}, 4, 7).value();
    EXPECT_EQ(square.plane, glm::dvec4(0, 1, 0, -2));
    EXPECT_EQ(square.object, 4);
    EXPECT_EQ(square.source, 7);
    EXPECT_DOUBLE_EQ(area(square), 9.0);
    EXPECT_EQ(centroid(square), glm::dvec3(1.5, 2, 1.5));
    const Polygon kite = make_polygon({{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {0, 2, 0}}, 0, 0).value();
    EXPECT_NEAR(area(kite), 4.5, 1e-14);
    EXPECT_NEAR(centroid(kite).x, 4.0 / 3.0, 1e-14) << "the centroid of the area, not of the corners";
}

TEST(MakePolygon, RefusesZeroArea) {
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(make_polygon({{0, 0, 0}, {1, 0, 0}}, 0, 0));
    EXPECT_FALSE(make_polygon({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}, 0, 0));
    EXPECT_FALSE(make_polygon({{0, 0, 0}, {1, 1, 1}, {3, 3, 3}}, 0, 0));
    EXPECT_FALSE(make_polygon({{0, 0, 0}, {1, 0, 0}, {0, infinity, 0}}, 0, 0));
    EXPECT_TRUE(make_polygon({{0, 0, 0}, {1, 0, 0}, {0, 1e-9, 0}}, 0, 0)) << "a sliver has an area";
    EXPECT_TRUE(make_polygon({{0, 0, 0}, {1e-20, 0, 0}, {0, 1e-20, 0}}, 0, 0)) << "small is not flat";
}

TEST(PolygonsOf, NumbersTrianglesAcrossMeshesAndCountsDroppedOnes) {
    const Mesh box = box_mesh();
    Mesh flat = triangle_mesh({glm::dvec3(0), {1, 0, 0}, {2, 0, 0}});
    flat.indices = {0, 1, 2, 0, 1, 2};
    const std::vector<MeshInstance> instances{{&box, world_from_model({5, 0, 0}, {}, {2, 1, 1})}, {&flat}, {&box}};
    const PolygonSet set = polygons_of(instances);
    EXPECT_EQ(set.polygons.size(), 24U);
    EXPECT_EQ(set.dropped, 2);
    EXPECT_EQ(set.polygons[11].source, 11);
    EXPECT_EQ(set.polygons[12].source, 14);
    EXPECT_EQ(set.polygons[12].object, 2);
    EXPECT_NEAR(total_area(std::span(set.polygons).first(12)), 2 * (8 + 8 + 4), 1e-12);
    for (const Polygon& polygon : set.polygons) {
        const glm::dvec3 center = polygon.object == 0 ? glm::dvec3(5, 0, 0) : glm::dvec3(0);
        EXPECT_LT(glm::dot(polygon.plane, glm::dvec4(center, 1)), 0) << "normals point out of a box";
    }
    EXPECT_DOUBLE_EQ(default_epsilon(set.polygons), 1e-9 * glm::length(glm::dvec3(8, 2, 2)));
    EXPECT_DOUBLE_EQ(default_epsilon({}), 1e-9);
}

TEST(SideOfPlane, CornersWithinEpsilonCountOnEitherSide) {
    const glm::dvec4 plane(0, 0, 1, 0);
    const auto side = [&](double a, double b, double c) {
        return side_of_plane(make_polygon({{0, 0, a}, {1, 0, b}, {0, 1, c}}, 0, 0).value(), plane, 0.1);
    };
    EXPECT_EQ(side(0.05, -0.05, 0), PlaneSide::coplanar);
    EXPECT_EQ(side(0.05, -0.05, 2), PlaneSide::front);
    EXPECT_EQ(side(0.05, -0.05, -2), PlaneSide::back);
    EXPECT_EQ(side(1, 2, 3), PlaneSide::front);
    EXPECT_EQ(side(1, 0, -0.2), PlaneSide::spanning);
}

TEST(Split, PreservesAreaPlaneAndNumber) {
    SCOPED_TRACE(seed);
    Random random(seed);
    int cut = 0;
    for (int i = 0; i < 500; ++i) {
        const Polygon whole = make_polygon({random.vec3(3), random.vec3(3), random.vec3(3)}, 2, i).value();
        const glm::dvec4 plane(random.direction(), random.number(-1, 1));
        if (side_of_plane(whole, plane, 1e-9) != PlaneSide::spanning) continue;
        ++cut;
        const auto [front, back] = split(whole, plane, 1e-9);
        EXPECT_NEAR(area(front) + area(back), area(whole), 1e-12 * area(whole));
        EXPECT_EQ(side_of_plane(front, plane, 1e-9), PlaneSide::front);
        EXPECT_EQ(side_of_plane(back, plane, 1e-9), PlaneSide::back);
        EXPECT_EQ(front.plane, whole.plane);
        EXPECT_EQ(back.source, i);
        EXPECT_EQ(front.object, 2);
        EXPECT_EQ(front.vertices.size() + back.vertices.size(), 7U);
        // The winding is unchanged.
        EXPECT_GT(glm::dot(glm::dvec3(make_polygon(front.vertices, 0, 0)->plane), glm::dvec3(whole.plane)), 0.999);
    }
    EXPECT_GT(cut, 100);
}

TEST(Split, ThroughACornerDoesNotMoveIt) {
    const Polygon whole = make_polygon({{0, 0, 0.05}, {1, 1, -1}, {1, 0, 1}}, 0, 0).value();
    const auto [front, back] = split(whole, {0, 0, 1, 0}, 0.1);
    EXPECT_EQ(front.vertices.size(), 3U);
    EXPECT_EQ(back.vertices.size(), 3U);
    EXPECT_EQ(front.vertices[0], whole.vertices[0]);
    EXPECT_EQ(back.vertices[0], whole.vertices[0]);
}

TEST(Split, NeighborsAreCutAtTheSamePoint) {
    SCOPED_TRACE(seed);
    Random random(seed);
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 a = random.vec3(1) + glm::dvec3(0, 0, 2), b = random.vec3(1) - glm::dvec3(0, 0, 2);
        const glm::dvec3 left = random.vec3(3), right = random.vec3(3);
        const glm::dvec4 plane(0, 0, 1, random.number(-0.5, 0.5));
        const auto cut_of_edge = [&](const Polygon& piece) {
            // The piece's only vertex on the edge a b other than a and b themselves.
            for (const glm::dvec3& v : piece.vertices) {
                if (v != a && v != b && glm::length(glm::cross(v - a, b - a)) < 1e-12) return v;
            }
            return glm::dvec3(99);
        };
        const Polygon one = make_polygon({a, b, left}, 0, 0).value(), other = make_polygon({b, a, right}, 0, 1).value();
        EXPECT_EQ(cut_of_edge(split(one, plane, 1e-9).first), cut_of_edge(split(other, plane, 1e-9).second));
    }
}

}  // namespace
}  // namespace viewing
