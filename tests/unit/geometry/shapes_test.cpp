// Shapes are watertight and wound outward, with unit normals that agree with the winding; their sizes and volumes are
// as specified.
#include "geometry/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

namespace viewing {
namespace {

using Edge = std::pair<std::array<float, 3>, std::array<float, 3>>;

std::array<float, 3> key(const glm::vec3& p) {
    return {p.x + 0.0F, p.y + 0.0F, p.z + 0.0F};
}

/// Counts the edges, compared by exact position, that do not have exactly one opposite edge.
std::size_t open_edges(const Mesh& mesh) {
    std::map<Edge, int> balance;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto a = key(mesh.positions[mesh.indices[i + k]]),
                       b = key(mesh.positions[mesh.indices[i + (k + 1) % 3]]);
            ++balance[{a, b}];
            --balance[{b, a}];
        }
    }
    std::size_t open = 0;
    for (const auto& [edge, count] : balance) {
        open += count != 0;
    }
    return open;
}

double volume(const Mesh& mesh) {
    double six_volumes = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::dvec3 a = mesh.positions[mesh.indices[i]], b = mesh.positions[mesh.indices[i + 1]],
                         c = mesh.positions[mesh.indices[i + 2]];
        six_volumes += glm::dot(a, glm::cross(b, c));
    }
    return six_volumes / 6;
}

/// Expects matching counts, indices in range, and unit normals that agree with every triangle's winding.
void expect_sound(const Mesh& mesh) {
    ASSERT_FALSE(mesh.indices.empty());
    ASSERT_EQ(mesh.positions.size(), mesh.normals.size());
    ASSERT_EQ(mesh.indices.size() % 3, 0U);
    for (const glm::vec3& normal : mesh.normals) {
        ASSERT_NEAR(glm::length(normal), 1, 1e-5);
    }
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        glm::dvec3 p[3], n[3];
        for (std::size_t k = 0; k < 3; ++k) {
            ASSERT_LT(mesh.indices[i + k], mesh.positions.size());
            p[k] = mesh.positions[mesh.indices[i + k]];
            n[k] = mesh.normals[mesh.indices[i + k]];
        }
        const glm::dvec3 face = glm::cross(p[1] - p[0], p[2] - p[0]);
        ASSERT_GT(glm::length(face), 0.0) << "triangle " << i / 3 << " has no area";
        for (const glm::dvec3& normal : n) {
            ASSERT_GT(glm::dot(glm::normalize(face), normal), 0.0) << "triangle " << i / 3;
        }
    }
}

void expect_bounds(const Mesh& mesh, const glm::dvec3& half_size) {
    const Bounds bounds = bounds_of(mesh);
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(bounds.min[i], -half_size[i], 1e-6);
        EXPECT_NEAR(bounds.max[i], half_size[i], 1e-6);
    }
}

TEST(Shapes, ClosedOnesAreWatertightAndWoundOutward) {
    const double pi = std::numbers::pi;
    struct Case {
        const char* name;
        Mesh mesh;
        double volume;
        glm::dvec3 half_size;
    };
    const Case cases[] = {
        {"box", box_mesh(), 8.0, {1, 1, 1}},
        {"sphere", sphere_mesh(), 4.0 / 3.0 * pi, {1, 1, 1}},
        {"torus", torus_mesh(), 2 * pi * pi * 0.9 * 0.34 * 0.34, {1.24, 0.34, 1.24}},
        {"cylinder", cylinder_mesh(), 2 * pi, {1, 1, 1}},
        {"cone", cone_mesh(), 2 * pi / 3, {1, 1, 1}},
    };
    for (const Case& c : cases) {
        SCOPED_TRACE(c.name);
        expect_sound(c.mesh);
        EXPECT_EQ(open_edges(c.mesh), 0U);
        EXPECT_NEAR(volume(c.mesh), c.volume, 0.012 * c.volume);
        expect_bounds(c.mesh, c.half_size);
    }
}

TEST(Shapes, FewestSlicesAreStillClosed) {
    for (const int n : {-1, 0, 1, 3, 5}) {
        for (const Mesh& mesh : {sphere_mesh(n, n), torus_mesh(n, n), cylinder_mesh(n), cone_mesh(n)}) {
            ASSERT_FALSE(mesh.indices.empty());
            EXPECT_EQ(open_edges(mesh), 0U);
            EXPECT_GT(volume(mesh), 0.0);
        }
    }
}

TEST(Shapes, FlatNormalsAreFlat) {
    const Mesh box = box_mesh();
    EXPECT_EQ(box.positions.size(), 24U);
    EXPECT_EQ(box.triangle_count(), 12U);
    for (std::size_t i = 0; i < box.positions.size(); ++i) {
        EXPECT_EQ(glm::dot(box.normals[i], box.positions[i]), 1.0F) << "on the face's own side";
    }
    for (const Mesh& mesh : {cylinder_mesh(), cone_mesh()}) {
        int down = 0;
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            down += mesh.normals[i] == glm::vec3(0, -1, 0) && mesh.positions[i].y == -1.0F;
        }
        EXPECT_EQ(down, 49) << "the base and its center";
    }
}

TEST(Shapes, SmoothNormalsMatchTheSurface) {
    const Mesh sphere = sphere_mesh();
    for (std::size_t i = 0; i < sphere.positions.size(); ++i) {
        EXPECT_EQ(sphere.positions[i], sphere.normals[i]);
    }
    const Mesh torus = torus_mesh();
    for (std::size_t i = 0; i < torus.positions.size(); ++i) {
        const glm::vec3 on_ring = torus.positions[i] - 0.34F * torus.normals[i];
        EXPECT_NEAR(std::hypot(on_ring.x, on_ring.z), 0.9, 1e-6);
        EXPECT_NEAR(on_ring.y, 0, 1e-6);
    }
    const Mesh cone = cone_mesh();
    for (std::size_t i = 0; i < cone.positions.size(); ++i) {
        const glm::vec3 p = cone.positions[i], n = cone.normals[i];
        if (n.y > -0.5F) {  // the side: perpendicular to the line from the base to the tip
            EXPECT_NEAR(n.y, 1 / std::sqrt(5.0), 1e-6);
            if (p.y < 0.0F) {
                EXPECT_NEAR(glm::dot(n, glm::vec3(0, 1, 0) - p), 0, 1e-6);
            }
        }
    }
}

TEST(Shapes, QuadAndTriangleFaceTheDocumentedWay) {
    const Mesh quad = quad_mesh();
    expect_sound(quad);
    expect_bounds(quad, {1, 0, 1});
    for (const glm::vec3& normal : quad.normals) {
        EXPECT_EQ(normal, glm::vec3(0, 1, 0));
    }
    const Mesh triangle = triangle_mesh({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}});
    expect_sound(triangle);
    EXPECT_EQ(triangle.normals[2], glm::vec3(0, 0, 1));
}

TEST(CenterAndFit, ScalesTheLongestSideToTwo) {
    Mesh mesh = box_mesh();
    for (glm::vec3& p : mesh.positions) {
        p = p * glm::vec3(5, 2, 1) + glm::vec3(100, 0, -3);
    }
    center_and_fit(mesh);
    expect_bounds(mesh, {1, 0.4, 0.2});

    Mesh point;
    point.positions = {{3, 4, 5}, {3, 4, 5}};
    center_and_fit(point);
    EXPECT_EQ(point.positions[0], glm::vec3(0)) << "without extent: centered only";
    Mesh empty;
    center_and_fit(empty);
    EXPECT_TRUE(bounds_of(empty).empty());
}

}  // namespace
}  // namespace viewing
