// Small OBJ files that cost much: what reading them takes, in steps, stays in proportion to their length, or is refused
// before it is spent.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <sstream>

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
        content.normals.emplace_back(1.0F, static_cast<float>(i), 0.0F);
        for (int corner = 0; corner < 3; ++corner) content.corners.push_back({corner, i});
    }
    Mesh mesh;
    ObjVertices vertices(content, true, mesh);
    std::vector<std::uint32_t> first;
    for (const ObjCorner& corner : content.corners) first.push_back(vertices.vertex(corner));
    EXPECT_EQ(mesh.positions.size(), content.corners.size()) << "each pair is a vertex of its own";
    for (std::size_t i = 0; i < content.corners.size(); ++i) {
        ASSERT_EQ(vertices.vertex(content.corners[i]), first[i]) << "and found again";
        ASSERT_EQ(mesh.positions[first[i]], content.positions[static_cast<std::size_t>(content.corners[i].position)]);
        ASSERT_EQ(mesh.normals[first[i]],
                  glm::normalize(content.normals[static_cast<std::size_t>(content.corners[i].normal)]));
    }
    EXPECT_LE(vertices.steps(), 2U * 16 * content.corners.size());
}

TEST(ObjCost, AFaceThatTurnsLeftThroughoutIsCutWithoutATest) {
    std::vector<glm::vec3> round;
    for (int i = 0; i < 255; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / 255;
        round.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    }
    PolygonCutter cutter;
    std::vector<std::uint32_t> triangles;
    for (int face = 0; face < 1000; ++face) {
        triangles.clear();
        ASSERT_TRUE(cutter.cut(round, triangles));
        ASSERT_EQ(triangles.size(), 3U * 253);
    }
    EXPECT_EQ(cutter.tests(), 0U);
}

/// A polygon about the origin whose corners have random distances: no two edges cross.
std::vector<glm::vec3> star(std::mt19937& random, int corners) {
    std::vector<glm::vec3> polygon;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / corners;
        const double distance = std::uniform_real_distribution(0.2, 1.0)(random);
        polygon.emplace_back(distance * std::cos(angle), distance * std::sin(angle), 0.0);
    }
    return polygon;
}

double twice_area_seen(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    return glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a)).z;
}

TEST(ObjCost, ConcaveFacesAreCoveredOnceInTheTestsThatArePromised) {
    std::mt19937 random(11);
    for (int round = 0; round < 200; ++round) {
        const int count = 4 + round;
        const std::vector<glm::vec3> polygon = star(random, count);
        std::uint64_t hollows = 0;
        double wanted = 0.0;
        for (int i = 0; i < count; ++i) {
            const glm::vec3 &a = polygon[(i + count - 1) % count], &b = polygon[i], &c = polygon[(i + 1) % count];
            hollows += twice_area_seen(a, b, c) <= 0.0;
            wanted += twice_area_seen(glm::vec3(0.0F), b, c);
        }
        PolygonCutter cutter;
        std::vector<std::uint32_t> triangles;
        ASSERT_TRUE(cutter.cut(polygon, triangles));
        ASSERT_EQ(triangles.size(), 3U * (count - 2));
        double area = 0.0;
        for (std::size_t i = 0; i < triangles.size(); i += 3) {
            const double seen =
                twice_area_seen(polygon[triangles[i]], polygon[triangles[i + 1]], polygon[triangles[i + 2]]);
            EXPECT_GT(seen, -1e-9) << "no triangle is turned over";
            area += seen;
        }
        EXPECT_NEAR(area, wanted, 1e-6) << count;
        EXPECT_LE(cutter.tests(), 3 * count * hollows);
    }
}

/// The OBJ text of so many faces with the same corners.
std::string faces(const std::vector<glm::vec3>& polygon, int count) {
    std::ostringstream text;
    std::string face = "f";
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        text << "v " << polygon[i].x << ' ' << polygon[i].y << " 0\n";
        face += ' ' + std::to_string(i + 1);
    }
    for (int i = 0; i < count; ++i) text << face << '\n';
    return text.str();
}

TEST(ObjCost, ConcaveFacesBeyondTheTestsAreRefusedBeforeTheyAreCut) {
    std::mt19937 random(12);
    const std::vector<glm::vec3> polygon = star(random, 256);
    PolygonCutter cutter;
    std::vector<std::uint32_t> triangles;
    int cut = 0;
    for (; cutter.cut(polygon, triangles); ++cut) triangles.clear();
    EXPECT_LE(cutter.tests(), PolygonCutter::most_tests);
    EXPECT_TRUE(triangles.empty());

    std::istringstream stream(faces(polygon, cut + 1));
    const Result<Mesh> mesh = read_obj(stream, 1, "star.obj", nullptr);
    ASSERT_FALSE(mesh);
    EXPECT_NE(mesh.error().find("100 million"), std::string::npos) << mesh.error();
    EXPECT_NE(mesh.error().find("cut them into triangles"), std::string::npos) << mesh.error();
}

}  // namespace
}  // namespace viewing
