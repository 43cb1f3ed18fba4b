// Compares simplified meshes with the originals: how far vertices move, the enclosed volume, and which way triangles
// face.
#include "geometry/simplify.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/shapes.h"

namespace viewing {
namespace {

/// Returns the volume by the divergence theorem; it is positive if triangles are counterclockwise as seen from outside.
double volume_of(const Mesh& mesh) {
    double volume = 0.0;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const glm::dvec3 a = mesh.positions[mesh.indices[i]], b = mesh.positions[mesh.indices[i + 1]],
                         c = mesh.positions[mesh.indices[i + 2]];
        volume += glm::dot(a, glm::cross(b, c)) / 6.0;
    }
    return volume;
}

TEST(Simplified, StaysOnASphereAndKeepsMostOfItsVolume) {
    const Mesh sphere = sphere_mesh(200, 120);
    ASSERT_GT(sphere.triangle_count(), 40'000U);
    const Mesh coarse = simplified(sphere, 24);
    EXPECT_LT(coarse.triangle_count(), sphere.triangle_count() / 8);
    const double cell = 2.0 / 24.0;
    for (std::size_t i = 0; i < coarse.positions.size(); ++i) {
        EXPECT_NEAR(glm::length(coarse.positions[i]), 1.0, cell * std::sqrt(3.0));
        EXPECT_NEAR(glm::length(coarse.normals[i]), 1.0, 1e-5);
        EXPECT_GT(glm::dot(glm::normalize(coarse.positions[i]), coarse.normals[i]), 0.9F) << "normals point outward";
    }
    EXPECT_NEAR(volume_of(coarse) / volume_of(sphere), 1.0, 0.03);
}

TEST(Simplified, HasNoDegenerateAndNoDuplicateTriangle) {
    const Mesh coarse = simplified(torus_mesh(300, 150), 20);
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (std::size_t i = 0; i < coarse.indices.size(); i += 3) {
        std::array<std::uint32_t, 3> corners{coarse.indices[i], coarse.indices[i + 1], coarse.indices[i + 2]};
        EXPECT_TRUE(corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0]);
        std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
        triangles.push_back(corners);
    }
    std::sort(triangles.begin(), triangles.end());
    EXPECT_EQ(std::adjacent_find(triangles.begin(), triangles.end()), triangles.end());
    EXPECT_GT(triangles.size(), 500U);
}

TEST(Simplified, KeepsAMeshWithDistantVertices) {
    const Mesh box = box_mesh();
    const Mesh coarse = simplified(box, 64);
    EXPECT_EQ(coarse.triangle_count(), box.triangle_count());
    EXPECT_EQ(coarse.positions.size(), 8U) << "the vertices of three faces merge into one";
    EXPECT_NEAR(volume_of(coarse), volume_of(box), 1e-9);
}

TEST(Simplified, RespectsTheTriangleLimitDownToZero) {
    const Mesh sphere = sphere_mesh(300, 150);
    for (const std::size_t most : {20'000U, 3'000U, 100U})
        EXPECT_LE(simplified_to(sphere, most).triangle_count(), most) << most;
    EXPECT_EQ(simplified_to({}, 100).triangle_count(), 0U);
    EXPECT_EQ(simplified(sphere, 1).triangle_count(), 0U) << "one cell leaves one vertex";
}

}  // namespace
}  // namespace viewing
