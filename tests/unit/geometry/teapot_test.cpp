// Checks the teapot against numbers printed with the data set (patch corners, height, radii), against some patches
// written out here and evaluated by de Casteljau's algorithm, and against the properties of a solid mesh.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "geometry/shapes.h"

namespace viewing {
namespace {

using Points = std::array<glm::dvec3, 16>;

/// Returns the positions in Newell's units, with z up and the table at 0, by undoing the centering, scale and rotation.
std::vector<glm::dvec3> newell_points(const Mesh& mesh) {
    const Bounds bounds = bounds_of(mesh);
    const double scale = 3.15 / bounds.size().y;
    std::vector<glm::dvec3> points;
    for (const glm::dvec3 p : mesh.positions) {
        points.emplace_back(p.x * scale, -p.z * scale, (p.y - bounds.min.y) * scale);
    }
    // Centering moved x; the widest ring (y = ±2) gives the body's axis.
    double axis_x = 0;
    for (const glm::dvec3& p : points) {
        axis_x = p.y > 1.9999 ? p.x : axis_x;
    }
    for (glm::dvec3& p : points) {
        p.x -= axis_x;
    }
    return points;
}

double distance_to_nearest(const std::vector<glm::dvec3>& points, const glm::dvec3& q) {
    double nearest = 1e300;
    for (const glm::dvec3& p : points) {
        nearest = std::min(nearest, glm::length(p - q));
    }
    return nearest;
}

glm::dvec3 de_casteljau(std::array<glm::dvec3, 4> p, double t) {
    for (std::size_t level = 3; level > 0; --level) {
        for (std::size_t i = 0; i < level; ++i) {
            p[i] = glm::mix(p[i], p[i + 1], t);
        }
    }
    return p[0];
}

TEST(Teapot, HasThirtyTwoPatchesWithoutDegenerateTriangles) {
    for (const int n : {1, 2, 5, 10}) {
        const Mesh mesh = teapot_mesh(n);
        EXPECT_EQ(mesh.positions.size(), static_cast<std::size_t>(32 * (n + 1) * (n + 1)));
        EXPECT_EQ(mesh.triangle_count(), static_cast<std::size_t>(32 * 2 * n * n - 8 * n));
    }
    EXPECT_EQ(teapot_mesh(0).triangle_count(), teapot_mesh(1).triangle_count());
    EXPECT_EQ(teapot_mesh(65).triangle_count(), teapot_mesh(64).triangle_count());
}

TEST(Teapot, IsCenteredWithLongestSideTwo) {
    const Bounds bounds = bounds_of(teapot_mesh());
    EXPECT_LT(glm::length(bounds.center()), 1e-6);
    EXPECT_NEAR(bounds.size().x, 2, 1e-6) << "from handle to spout";
}

TEST(Teapot, MatchesKnownMeasures) {
    const std::vector<glm::dvec3> points = newell_points(teapot_mesh(16));
    // The inner and outer rim, the widest ring, the foot, the edge of the lid and the neck of the knob, all around;
    // then the top of the knob and the center of the bottom.
    const double rings[][2] = {{1.4, 2.4}, {1.5, 2.4}, {2.0, 0.9}, {1.5, 0.15}, {1.3, 2.4}, {0.2, 2.7}};
    for (const auto& ring : rings) {
        for (int quarter = 0; quarter < 4; ++quarter) {
            const double c = quarter % 2 == 0 ? 1 - quarter : 0, s = quarter % 2 == 1 ? 2 - quarter : 0;
            EXPECT_LT(distance_to_nearest(points, {ring[0] * c, ring[0] * s, ring[1]}), 1e-5)
                << ring[0] << " " << ring[1];
        }
    }
    EXPECT_LT(distance_to_nearest(points, {0, 0, 3.15}), 1e-5);
    EXPECT_LT(distance_to_nearest(points, {0, 0, 0}), 1e-5);
    // Points where the handle and the spout begin and end.
    const double ends[][2] = {{-1.6, 2.025}, {-1.5, 2.25}, {-2.7, 1.8}, {-3.0, 1.8}, {-2.0, 0.9}, {-1.9, 0.6},
                              {1.7, 1.425},  {1.7, 0.6},   {2.7, 2.4},  {3.3, 2.4},  {2.8, 2.4},  {3.2, 2.4}};
    for (const auto& end : ends) {
        EXPECT_LT(distance_to_nearest(points, {end[0], 0, end[1]}), 1e-5) << end[0] << " " << end[1];
    }
}

TEST(Teapot, MatchesPatchesWrittenOut) {
    const Points patches[] = {
        // a quarter of the rim
        {{{1.4, 0, 2.4},
          {1.4, -0.784, 2.4},
          {0.784, -1.4, 2.4},
          {0, -1.4, 2.4},
          {1.3375, 0, 2.53125},
          {1.3375, -0.749, 2.53125},
          {0.749, -1.3375, 2.53125},
          {0, -1.3375, 2.53125},
          {1.4375, 0, 2.53125},
          {1.4375, -0.805, 2.53125},
          {0.805, -1.4375, 2.53125},
          {0, -1.4375, 2.53125},
          {1.5, 0, 2.4},
          {1.5, -0.84, 2.4},
          {0.84, -1.5, 2.4},
          {0, -1.5, 2.4}}},
        // a quarter of the knob
        {{{0, 0, 3.15},
          {0, 0, 3.15},
          {0, 0, 3.15},
          {0, 0, 3.15},
          {-0.8, 0, 3.15},
          {-0.8, 0.45, 3.15},
          {-0.45, 0.8, 3.15},
          {0, 0.8, 3.15},
          {0, 0, 2.85},
          {0, 0, 2.85},
          {0, 0, 2.85},
          {0, 0, 2.85},
          {-0.2, 0, 2.7},
          {-0.2, 0.112, 2.7},
          {-0.112, 0.2, 2.7},
          {0, 0.2, 2.7}}},
        // one side of the lower half of the handle
        {{{-2.7, 0, 1.8},
          {-2.7, -0.3, 1.8},
          {-3, -0.3, 1.8},
          {-3, 0, 1.8},
          {-2.7, 0, 1.575},
          {-2.7, -0.3, 1.575},
          {-3, -0.3, 1.35},
          {-3, 0, 1.35},
          {-2.5, 0, 1.125},
          {-2.5, -0.3, 1.125},
          {-2.65, -0.3, 0.9375},
          {-2.65, 0, 0.9375},
          {-2, 0, 0.9},
          {-2, -0.3, 0.9},
          {-1.9, -0.3, 0.6},
          {-1.9, 0, 0.6}}},
        // the other side of the spout
        {{{1.7, 0, 0.6},
          {1.7, 0.66, 0.6},
          {1.7, 0.66, 1.425},
          {1.7, 0, 1.425},
          {3.1, 0, 0.825},
          {3.1, 0.66, 0.825},
          {2.6, 0.66, 1.425},
          {2.6, 0, 1.425},
          {2.4, 0, 2.025},
          {2.4, 0.25, 2.025},
          {2.3, 0.25, 2.1},
          {2.3, 0, 2.1},
          {3.3, 0, 2.4},
          {3.3, 0.25, 2.4},
          {2.7, 0.25, 2.4},
          {2.7, 0, 2.4}}},
        // a quarter of the upper body
        {{{0, -1.5, 2.4},
          {-0.84, -1.5, 2.4},
          {-1.5, -0.84, 2.4},
          {-1.5, 0, 2.4},
          {0, -1.75, 1.875},
          {-0.98, -1.75, 1.875},
          {-1.75, -0.98, 1.875},
          {-1.75, 0, 1.875},
          {0, -2, 1.35},
          {-1.12, -2, 1.35},
          {-2, -1.12, 1.35},
          {-2, 0, 1.35},
          {0, -2, 0.9},
          {-1.12, -2, 0.9},
          {-2, -1.12, 0.9},
          {-2, 0, 0.9}}},
        // a quarter of the lower body
        {{{0, -2, 0.9},
          {-1.12, -2, 0.9},
          {-2, -1.12, 0.9},
          {-2, 0, 0.9},
          {0, -2, 0.45},
          {-1.12, -2, 0.45},
          {-2, -1.12, 0.45},
          {-2, 0, 0.45},
          {0, -1.5, 0.225},
          {-0.84, -1.5, 0.225},
          {-1.5, -0.84, 0.225},
          {-1.5, 0, 0.225},
          {0, -1.5, 0.15},
          {-0.84, -1.5, 0.15},
          {-1.5, -0.84, 0.15},
          {-1.5, 0, 0.15}}},
        // a quarter of the lid
        {{{0, 0.2, 2.7},
          {0.112, 0.2, 2.7},
          {0.2, 0.112, 2.7},
          {0.2, 0, 2.7},
          {0, 0.4, 2.55},
          {0.224, 0.4, 2.55},
          {0.4, 0.224, 2.55},
          {0.4, 0, 2.55},
          {0, 1.3, 2.55},
          {0.728, 1.3, 2.55},
          {1.3, 0.728, 2.55},
          {1.3, 0, 2.55},
          {0, 1.3, 2.4},
          {0.728, 1.3, 2.4},
          {1.3, 0.728, 2.4},
          {1.3, 0, 2.4}}},
        // a quarter of the bottom
        {{{0, 0, 0},
          {0, 0, 0},
          {0, 0, 0},
          {0, 0, 0},
          {0, 1.425, 0},
          {-0.798, 1.425, 0},
          {-1.425, 0.798, 0},
          {-1.425, 0, 0},
          {0, 1.5, 0.075},
          {-0.84, 1.5, 0.075},
          {-1.5, 0.84, 0.075},
          {-1.5, 0, 0.075},
          {0, 1.5, 0.15},
          {-0.84, 1.5, 0.15},
          {-1.5, 0.84, 0.15},
          {-1.5, 0, 0.15}}},
        // the upper half of the handle
        {{{-1.5, 0, 2.25},
          {-1.5, 0.3, 2.25},
          {-1.6, 0.3, 2.025},
          {-1.6, 0, 2.025},
          {-2.5, 0, 2.25},
          {-2.5, 0.3, 2.25},
          {-2.3, 0.3, 2.025},
          {-2.3, 0, 2.025},
          {-3, 0, 2.25},
          {-3, 0.3, 2.25},
          {-2.7, 0.3, 2.025},
          {-2.7, 0, 2.025},
          {-3, 0, 1.8},
          {-3, 0.3, 1.8},
          {-2.7, 0.3, 1.8},
          {-2.7, 0, 1.8}}},
        // the tip of the spout
        {{{2.7, 0, 2.4},
          {2.7, -0.25, 2.4},
          {3.3, -0.25, 2.4},
          {3.3, 0, 2.4},
          {2.8, 0, 2.475},
          {2.8, -0.25, 2.475},
          {3.525, -0.25, 2.49375},
          {3.525, 0, 2.49375},
          {2.9, 0, 2.475},
          {2.9, -0.15, 2.475},
          {3.45, -0.15, 2.5125},
          {3.45, 0, 2.5125},
          {2.8, 0, 2.4},
          {2.8, -0.15, 2.4},
          {3.2, -0.15, 2.4},
          {3.2, 0, 2.4}}},
    };
    const std::vector<glm::dvec3> points = newell_points(teapot_mesh(8));
    for (const Points& patch : patches) {
        for (int i = 0; i <= 8; ++i) {
            for (int j = 0; j <= 8; ++j) {
                std::array<glm::dvec3, 4> column;
                for (std::size_t row = 0; row < 4; ++row) {
                    column[row] = de_casteljau(
                        {patch[4 * row], patch[4 * row + 1], patch[4 * row + 2], patch[4 * row + 3]}, j / 8.0);
                }
                EXPECT_LT(distance_to_nearest(points, de_casteljau(column, i / 8.0)), 2e-6);
            }
        }
    }
}

TEST(Teapot, IsSymmetricLeftAndRight) {
    const std::vector<glm::dvec3> points = newell_points(teapot_mesh(6));
    for (const glm::dvec3& p : points) {
        EXPECT_LT(distance_to_nearest(points, {p.x, -p.y, p.z}), 2e-6);
    }
}

TEST(Teapot, NormalsAreUnitAndAgreeWithTheWinding) {
    for (const int n : {10, 33, 64}) {  // coarser meshes cut off the lip of the spout
        const Mesh mesh = teapot_mesh(n);
        for (const glm::vec3& normal : mesh.normals) {
            ASSERT_NEAR(glm::length(normal), 1, 1e-5);
        }
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            const std::uint32_t* v = &mesh.indices[i];
            const glm::dvec3 a = mesh.positions[v[0]], b = mesh.positions[v[1]], c = mesh.positions[v[2]];
            const glm::dvec3 face = glm::cross(b - a, c - a);
            ASSERT_GT(glm::length(face), 0.0);
            for (int k = 0; k < 3; ++k) {
                ASSERT_GT(glm::dot(face, glm::dvec3(mesh.normals[v[k]])), 0.0) << "triangle " << i / 3;
            }
        }
    }
}

TEST(Teapot, FacesOutward) {
    // Normals by part: the handle and the spout come last, with four patches each.
    const int n = 12;
    const Mesh mesh = teapot_mesh(n);
    const std::vector<glm::dvec3> points = newell_points(mesh);
    const std::uint32_t patch_points = (n + 1) * (n + 1);
    const auto newell_normal = [&](std::size_t i) {
        const glm::dvec3 normal = mesh.normals[i];
        return glm::dvec3(normal.x, -normal.z, normal.y);
    };
    for (std::uint32_t i = 0; i < 24 * patch_points; ++i) {
        const glm::dvec3 p = points[i], normal = newell_normal(i);
        if (p.z > 0.2 && p.z < 2.3) {
            EXPECT_GT(normal.x * p.x + normal.y * p.y, 0.0) << "the body's wall faces away from the axis";
        }
        if (p.z < 0.149) {
            EXPECT_LT(normal.z, 0.0) << "the bottom faces down";
        }
        if (p.z > 3.1) {
            EXPECT_GT(normal.z, 0.0) << "the knob's top faces up";
        }
    }
    for (std::uint32_t i = 24 * patch_points; i < 32 * patch_points; ++i) {
        const glm::dvec3 p = points[i], normal = newell_normal(i);
        if (std::abs(p.y) > 0.1 && p.z < 2.39) {  // above this, the spout's lip curls in
            EXPECT_GT(normal.y * p.y, 0.0) << "sides of handle and spout face away from the plane of symmetry";
        }
    }
}

TEST(Teapot, NormalsAtThePolesAreVertical) {
    const Mesh mesh = teapot_mesh();
    const std::vector<glm::dvec3> points = newell_points(mesh);
    int poles = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double radius = std::hypot(points[i].x, points[i].y);
        if (radius < 1e-6) {
            EXPECT_NEAR(mesh.normals[i].y, points[i].z > 1 ? 1 : -1, 1e-6);
            ++poles;
        }
    }
    EXPECT_EQ(poles, 8 * 11);
}

TEST(Teapot, HasNoCracks) {
    // Every directed edge has an opposite edge at the very same positions, except along the six known rims: one each
    // for the pot and the lid, and two each for the tubes of the handle and the spout.
    const int n = 10;
    const Mesh mesh = teapot_mesh(n);
    const auto key = [&](std::uint32_t v) {
        const glm::vec3 p = mesh.positions[v];
        return std::array{p.x + 0.0F, p.y + 0.0F, p.z + 0.0F};
    };
    std::map<std::pair<std::array<float, 3>, std::array<float, 3>>, int> balance;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto a = key(mesh.indices[i + k]), b = key(mesh.indices[i + (k + 1) % 3]);
            ++balance[{a, b}];
            --balance[{b, a}];
        }
    }
    int open = 0;
    for (const auto& [edge, count] : balance) {
        open += count > 0;
    }
    EXPECT_EQ(open, 2 * 4 * n + 4 * 2 * n);
}

}  // namespace
}  // namespace viewing
