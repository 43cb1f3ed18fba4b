// Small OBJ files that could be expensive to read. Reading one must take a number of steps proportional to its length,
// or the reader must refuse the file before it takes more.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <sstream>

#include "platform/sanitized.h"
#include "state/mesh/obj.h"
#include "state/mesh/obj_vertices.h"
#include "state/mesh/polygon.h"

namespace viewing {
namespace {

TEST(ObjCost, ManyNormalsAtOnePositionTakeAFewStepsEach) {
    constexpr int count = 60'000;
    ObjContent content;
    content.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    for (int i = 0; i < count; ++i) {
        content.normals.push_back(glm::normalize(glm::vec3(1.0F, static_cast<float>(i), 0.0F)));
        for (int corner = 0; corner < 3; ++corner) content.corners.push_back({corner, i});
    }
    Mesh mesh;
    ObjVertices vertices(content, mesh);
    std::vector<std::uint32_t> first;
    for (const ObjCorner& corner : content.corners) first.push_back(vertices.vertex(corner));
    EXPECT_EQ(mesh.positions.size(), content.corners.size()) << "each pair is its own vertex";
    for (std::size_t i = 0; i < content.corners.size(); ++i) {
        ASSERT_EQ(vertices.vertex(content.corners[i]), first[i]) << "lookup finds the same vertex";
        ASSERT_EQ(glm::dvec3(mesh.positions[first[i]]),
                  content.positions[static_cast<std::size_t>(content.corners[i].position)]);
        ASSERT_EQ(mesh.normals[first[i]], content.normals[static_cast<std::size_t>(content.corners[i].normal)]);
    }
    EXPECT_LE(vertices.steps(), 2U * 16 * content.corners.size());
}

TEST(ObjCost, ConvexFaceIsCutWithoutATest) {
    std::vector<glm::dvec3> round;
    for (int i = 0; i < 255; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / 255;
        round.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    }
    PolygonCutter cutter;
    std::vector<std::uint32_t> triangles;
    for (int face = 0; face < 1000; ++face) {
        triangles.clear();
        ASSERT_EQ(cutter.cut(round, triangles), PolygonCutter::Outcome::filled);
        ASSERT_EQ(triangles.size(), 3U * 253);
    }
    EXPECT_EQ(cutter.tests(), 0U);
}

/// Returns a polygon around the origin with corners at random distances, so that no two edges cross.
std::vector<glm::dvec3> star(std::mt19937& random, int corners) {
    std::vector<glm::dvec3> polygon;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / corners;
        const double distance = std::uniform_real_distribution(0.2, 1.0)(random);
        polygon.emplace_back(distance * std::cos(angle), distance * std::sin(angle), 0.0);
    }
    return polygon;
}

double twice_area_seen(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    return glm::cross(b - a, c - a).z;
}

TEST(ObjCost, ConcaveFacesAreCoveredOnceWithinThePromisedTests) {
    std::mt19937 random(11);
    for (int round = 0; round < 200; ++round) {
        const int count = 4 + round;
        const std::vector<glm::dvec3> polygon = star(random, count);
        std::uint64_t hollows = 0;
        double wanted = 0.0;
        for (int i = 0; i < count; ++i) {
            const glm::dvec3 &a = polygon[(i + count - 1) % count], &b = polygon[i], &c = polygon[(i + 1) % count];
            hollows += twice_area_seen(a, b, c) <= 0.0;
            wanted += twice_area_seen(glm::dvec3(0.0), b, c);
        }
        PolygonCutter cutter;
        std::vector<std::uint32_t> triangles;
        ASSERT_EQ(cutter.cut(polygon, triangles), PolygonCutter::Outcome::filled);
        ASSERT_EQ(triangles.size(), 3U * (count - 2));
        double area = 0.0;
        for (std::size_t i = 0; i < triangles.size(); i += 3) {
            const double seen =
                twice_area_seen(polygon[triangles[i]], polygon[triangles[i + 1]], polygon[triangles[i + 2]]);
            EXPECT_GT(seen, -1e-9) << "no triangle is flipped";
            area += seen;
        }
        EXPECT_NEAR(area, wanted, 1e-6) << count;
        EXPECT_LE(cutter.tests(), 4 * count * (hollows + 2));
    }
}

/// Returns a comb with closely spaced valleys and one distant reflex corner, so that a grid over all reflex corners has
/// all valleys in one cell.
std::vector<glm::dvec3> stubborn(int teeth) {
    const double far_away = 1e9;
    std::vector<glm::dvec3> polygon = {{0.0, -1.0, 0.0},
                                       {far_away, -1.0, 0.0},
                                       {far_away, 5.0, 0.0},
                                       {far_away - 1.0, 5.0, 0.0},
                                       {far_away - 1.0, 0.0, 0.0}};
    for (int i = teeth - 1; i >= 0; --i) {
        polygon.emplace_back(i + 0.5, 3.0, 0.0);
        polygon.emplace_back(i, 0.0, 0.0);
    }
    return polygon;
}

/// Writes the polygon's vertices and then `count` OBJ faces that refer to these vertices by negative indices.
std::string faces(const std::vector<glm::dvec3>& polygon, int count) {
    std::ostringstream text;
    text.precision(17);
    std::string face = "f";
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        text << "v " << polygon[i].x << ' ' << polygon[i].y << " 0\n";
        face += " -" + std::to_string(polygon.size() - i);
    }
    for (int i = 0; i < count; ++i) text << face << '\n';
    return text.str();
}

TEST(ObjCost, ConcaveFaceBeyondTheTestLimitIsRefusedWithItsLine) {
    const std::vector<glm::dvec3> polygon = stubborn(40'000);
    if (!is_sanitized) {  // 100 million tests, which the reader below does, too
        PolygonCutter cutter;
        std::vector<std::uint32_t> triangles;
        EXPECT_EQ(cutter.cut(polygon, triangles), PolygonCutter::Outcome::takes_too_long);
        EXPECT_LE(cutter.tests(), PolygonCutter::most_tests + 101 * polygon.size());
        EXPECT_TRUE(triangles.empty());
    }

    std::istringstream stream("v 0 0 0\n# an L\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nf 1 2 3 4 5 6\n" +
                              faces(polygon, 1));
    const Result<ObjMesh> mesh = read_obj(stream, 1, "comb.obj", {}, nullptr);
    ASSERT_FALSE(mesh);
    EXPECT_EQ(mesh.error(), "comb.obj: line " + std::to_string(polygon.size() + 9) +
                                ": face 2 has 80005 corners: triangulating it takes more than 100 million tests; "
                                "triangulate it in the file");
}

TEST(ObjCost, SmallConcaveFacesAreCutInAnyNumber) {
    std::mt19937 random(13);
    const std::vector<glm::dvec3> polygon = star(random, 12);
    PolygonCutter cutter;
    std::vector<std::uint32_t> triangles;
    while (cutter.tests() < PolygonCutter::most_tests / (is_sanitized ? 50 : 5)) {
        triangles.clear();
        ASSERT_EQ(cutter.cut(polygon, triangles), PolygonCutter::Outcome::filled);
    }
}

}  // namespace
}  // namespace viewing
