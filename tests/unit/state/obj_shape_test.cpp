// Checks the shapes read from Wavefront OBJ files against the test's own reader, which uses strtold and centers in long
// double.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <random>
#include <sstream>

#include "state/mesh/obj.h"
#include "state/mesh/polygon.h"

namespace viewing::obj_shape {
namespace {

constexpr unsigned seed = 20240607;

struct Text {
    std::vector<std::array<std::string, 3>> vertices;
    std::string faces;

    std::string whole() const {
        std::string all;
        for (const auto& [x, y, z] : vertices) all.append("v ").append(x + " " + y + " " + z + "\n");
        return all + faces;
    }
};

Result<ObjMesh> read(const std::string& text, const MeshReading& reading = {}) {
    std::istringstream stream(text);
    return read_obj(stream, text.size(), "m.obj", reading, nullptr);
}

std::string exact(double number) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%.17g", number);
    return text.data();
}

/// Returns the vertices with their bounds centered and scaled to 2.
std::vector<glm::dvec3> centered(const Text& text) {
    std::vector<glm::dvec3> places(text.vertices.size());
    std::array<long double, 3> min{}, max{};
    const auto number = [&](std::size_t vertex, std::size_t axis) {
        return std::strtold(text.vertices[vertex][axis].c_str(), nullptr);
    };
    long double longest = 0.0L;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        min[axis] = max[axis] = number(0, axis);
        for (std::size_t i = 0; i < places.size(); ++i) {
            min[axis] = std::min(min[axis], number(i, axis));
            max[axis] = std::max(max[axis], number(i, axis));
        }
        longest = std::max(longest, max[axis] - min[axis]);
    }
    for (std::size_t i = 0; i < places.size(); ++i)
        for (std::size_t axis = 0; axis < 3; ++axis)
            places[i][static_cast<int>(axis)] =
                static_cast<double>((number(i, axis) - (min[axis] + max[axis]) / 2) * 2 / longest);
    return places;
}

/// Makes a solid of seeded random corners around the origin, moved and scaled, as a fan of triangles.
Text random_solid(std::mt19937& random, const glm::dvec3& offset, double scale) {
    std::uniform_int_distribution<int> eighths(-80, 80);  // sums with 2^k are exact
    Text text;
    for (int i = 0; i < 12; ++i) {
        std::array<std::string, 3> vertex;
        for (int axis = 0; axis < 3; ++axis)
            vertex[static_cast<std::size_t>(axis)] = exact((offset[axis] + eighths(random) / 8.0) * scale);
        text.vertices.push_back(vertex);
    }
    for (int i = 2; i < 12; ++i)
        text.faces += "f 1 " + std::to_string(i) + " " + std::to_string(i + 1 > 12 ? 2 : i + 1) + "\n";
    return text;
}

/// Expects each vertex of the mesh to be where the text puts it, in the order of the fan.
void expect_places(const Mesh& mesh, const Text& text, double within) {
    const std::vector<glm::dvec3> places = centered(text);
    ASSERT_EQ(mesh.indices.size(), 30U);
    for (std::size_t face = 0; face < 10; ++face) {
        const std::size_t named[] = {0, face + 1, face + 2 > 11 ? 1 : face + 2};
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const glm::dvec3 place = mesh.positions[mesh.indices[3 * face + corner]];
            ASSERT_LT(glm::length(place - places[named[corner]]), within) << "face " << face << ", corner " << corner;
        }
    }
}

TEST(ObjShape, IsKeptFarFromTheOriginAndAtEverySize) {
    std::mt19937 random(seed);
    const glm::dvec3 far_away[] = {{0, 0, 0},
                                   {0x1p17, 0, 0},
                                   {413207, 6204811, 88},
                                   {0x1p30, -0x1p34, 0x1p20},
                                   {-0x1p36, 0, 0x1p36},
                                   {90000.123, 71234.4, 0},
                                   {0x1p20, 0x1p20, 0x1p20}};
    for (const glm::dvec3& offset : far_away)
        for (const double scale : {1.0, 1e-9, 0x1p-30, 1e-30, 1e-150, 4.0}) {
            SCOPED_TRACE("seed " + std::to_string(seed) + ", x " + exact(offset.x) + ", scale " + exact(scale));
            const Text text = random_solid(random, offset, scale);
            const Result<ObjMesh> mesh = read(text.whole());
            ASSERT_TRUE(mesh) << mesh.error();
            // The 17 digits of the text limit the precision of any reader of doubles.
            const double told =
                4.0 * std::ldexp(std::max({std::abs(offset.x), std::abs(offset.y), std::abs(offset.z)}), -53);
            expect_places(mesh->mesh, text, 1e-6 + told);
        }
}

TEST(ObjShape, PowerOfTwoOffsetChangesNoBit) {
    std::mt19937 random(seed);
    for (int i = 0; i < 50; ++i) {
        const std::mt19937 same = random;
        const Result<ObjMesh> here = read(random_solid(random, glm::dvec3(0.0), 1.0).whole());
        std::mt19937 again = same;
        const Result<ObjMesh> there =
            read(random_solid(again, {std::ldexp(1.0, i % 35), -0x1p33, 0x1p10}, 0x1p5).whole());
        ASSERT_TRUE(here && there);
        EXPECT_EQ(here->mesh.positions, there->mesh.positions) << "seed " << seed << ", solid " << i;
        EXPECT_EQ(here->mesh.normals, there->mesh.normals);
        EXPECT_EQ(here->mesh.indices, there->mesh.indices);
    }
}

TEST(ObjShape, UnfittedOriginRestoresFileCoordinates) {
    std::mt19937 random(seed);
    for (const glm::dvec3& offset : {glm::dvec3(0.0), glm::dvec3(413207.25, 6204811.5, 88.0)}) {
        const Text text = random_solid(random, offset, 1.0);
        const Result<ObjMesh> mesh = read(text.whole(), {.fit = false});
        ASSERT_TRUE(mesh) << mesh.error();
        const auto number = [&](std::size_t vertex, int axis) {
            return std::strtod(text.vertices[vertex][static_cast<std::size_t>(axis)].c_str(), nullptr);
        };
        for (int corner = 0; corner < 3; ++corner)
            for (int axis = 0; axis < 3; ++axis)
                EXPECT_EQ(mesh->origin[axis] +
                              mesh->mesh.positions[mesh->mesh.indices[static_cast<std::size_t>(corner)]][axis],
                          number(static_cast<std::size_t>(corner), axis));
    }
}

TEST(ObjShape, NonplanarQuadIsCutFromFirstToThirdCorner) {
    const Result<ObjMesh> mesh = read("v 0 0 0\nv 2 1 0\nv 2 0 2\nv 0 1 2\nf 1 4 3 2\n");
    ASSERT_TRUE(mesh);
    ASSERT_EQ(mesh->mesh.indices.size(), 6U);
    // The face's first and third corners are the lower ones.
    for (std::size_t triangle = 0; triangle < 2; ++triangle) {
        int low = 0;
        for (std::size_t i = 0; i < 3; ++i) low += mesh->mesh.positions[mesh->mesh.indices[3 * triangle + i]].y < 0.0F;
        EXPECT_EQ(low, 2) << triangle;
    }
}

using Polygon2 = std::vector<glm::dvec2>;

double shoelace(const Polygon2& polygon) {
    double twice = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        twice += a.x * b.y - a.y * b.x;
    }
    return twice / 2.0;
}

bool is_inside(const Polygon2& polygon, const glm::dvec2& point) {
    bool inside = false;
    for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
        const glm::dvec2 &a = polygon[i], &b = polygon[j];
        if ((a.y > point.y) != (b.y > point.y) && point.x < (b.x - a.x) * (point.y - a.y) / (b.y - a.y) + a.x)
            inside = !inside;
    }
    return inside;
}

/// Makes a star around the origin with corners at random distances.
Polygon2 star(std::mt19937& random, int corners) {
    Polygon2 polygon;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / corners;
        polygon.push_back(std::uniform_real_distribution(0.2, 1.0)(random) *
                          glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    return polygon;
}

/// Makes a gear whose straight-sided teeth are as wide as the gaps.
Polygon2 gear(int teeth) {
    Polygon2 polygon;
    for (int i = 0; i < 4 * teeth; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / (4 * teeth);
        polygon.push_back((i % 4 < 2 ? 1.0 : 0.55) * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    return polygon;
}

/// Makes a comb with teeth of random length on a straight back.
Polygon2 comb(std::mt19937& random, int teeth) {
    Polygon2 polygon = {{0.0, -1.0}, {1.0 * teeth, -1.0}, {1.0 * teeth, 0.0}};
    for (int i = teeth - 1; i >= 0; --i) {
        polygon.emplace_back(i + 0.5, std::uniform_real_distribution(1.0, 50.0)(random));
        polygon.emplace_back(i, 0.0);
    }
    return polygon;
}

/// Makes a band that winds inward in `turns` turns.
Polygon2 spiral(int turns, int corners_a_turn) {
    Polygon2 outer, inner;
    for (int i = 0; i <= turns * corners_a_turn; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / corners_a_turn;
        const double radius = turns + 1.0 - static_cast<double>(i) / corners_a_turn;
        outer.push_back(radius * glm::dvec2(std::cos(angle), std::sin(angle)));
        inner.push_back((radius - 0.4) * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    outer.insert(outer.end(), inner.rbegin(), inner.rend());
    return outer;
}

/// Rotates the polygon in space, cuts it into triangles there, and checks the result in the polygon's own plane.
void expect_filled(const Polygon2& polygon, std::mt19937& random, const std::string& what) {
    SCOPED_TRACE(what + " of " + std::to_string(polygon.size()) + " corners, seed " + std::to_string(seed));
    std::normal_distribution<double> normal;
    const glm::dvec3 n = glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
    const glm::dvec3 u = glm::normalize(glm::cross(n, glm::dvec3(0.3, -0.5, 0.8))), v = glm::cross(n, u);
    std::vector<glm::dvec3> corners;
    for (const glm::dvec2& corner : polygon) corners.push_back(1e5 * n + corner.x * u + corner.y * v);
    PolygonCutter cutter;
    std::vector<std::uint32_t> triangles;
    ASSERT_EQ(cutter.cut(corners, triangles), PolygonCutter::Outcome::filled);
    ASSERT_EQ(triangles.size(), 3 * (polygon.size() - 2));
    const double area = shoelace(polygon);
    double covered = 0.0;
    for (std::size_t i = 0; i < triangles.size(); i += 3) {
        const glm::dvec2 &a = polygon[triangles[i]], &b = polygon[triangles[i + 1]], &c = polygon[triangles[i + 2]];
        const double part = shoelace({a, b, c});
        ASSERT_GT(part, -1e-9 * area) << "no triangle is flipped";
        covered += part;
        if (part > 1e-7 * area / static_cast<double>(polygon.size())) {
            ASSERT_TRUE(is_inside(polygon, (a + b + c) / 3.0)) << "triangle " << i / 3;
        }
    }
    EXPECT_NEAR(covered, area, 1e-9 * area);
}

TEST(ObjShape, PolygonsOfAnySizeAreCoveredOnce) {
    std::mt19937 random(seed);
    for (const int count : {4, 5, 6, 7, 9, 17, 40, 128, 254, 256, 257, 300, 1000, 2500, 5000}) {
        expect_filled(star(random, count), random, "star");
        expect_filled(comb(random, count / 2), random, "comb");
        expect_filled(gear(count / 4 + 2), random, "gear");
        expect_filled(spiral(1 + count / 100, 40), random, "spiral");
    }
}

TEST(ObjShape, AHundredThousandCornersTakeProportionalTime) {
    std::mt19937 random(seed);
    for (const Polygon2& polygon : {star(random, 100'000), comb(random, 50'000), gear(25'000), spiral(200, 250)}) {
        std::vector<glm::dvec3> corners;
        for (const glm::dvec2& corner : polygon) corners.emplace_back(corner, 0.0);
        PolygonCutter cutter;
        std::vector<std::uint32_t> triangles;
        EXPECT_EQ(cutter.cut(corners, triangles), PolygonCutter::Outcome::filled);
        EXPECT_LT(cutter.tests(), 250U * polygon.size());
        EXPECT_EQ(triangles.size(), 3 * (polygon.size() - 2));
    }
}

}  // namespace
}  // namespace viewing::obj_shape
