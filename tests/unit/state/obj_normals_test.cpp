// Generated normals for Wavefront OBJ files without normals: flat surfaces stay flat, round ones look round.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <set>
#include <sstream>

#include "state/mesh/obj.h"

namespace viewing::obj_normals {
namespace {

constexpr unsigned seed = 20240608;

Mesh read(const std::string& text, double crease_deg = MeshReading{}.crease_deg) {
    std::istringstream stream(text);
    const Result<ObjMesh> mesh = read_obj(stream, text.size(), "m.obj", {.crease_deg = crease_deg}, nullptr);
    EXPECT_TRUE(mesh) << mesh.error();
    return mesh ? mesh->mesh : Mesh{};
}

glm::dvec3 face_normal(const Mesh& mesh, std::size_t triangle) {
    const auto corner = [&](std::size_t i) { return glm::dvec3(mesh.positions[mesh.indices[3 * triangle + i]]); };
    return glm::normalize(glm::cross(corner(1) - corner(0), corner(2) - corner(0)));
}

glm::dvec3 normal_at(const Mesh& mesh, std::size_t triangle, std::size_t corner) {
    return mesh.normals[mesh.indices[3 * triangle + corner]];
}

/// Returns the largest angle in degrees between a corner's normal and its triangle's.
double largest_bend_deg(const Mesh& mesh) {
    double least = 1.0;
    for (std::size_t triangle = 0; triangle < mesh.triangle_count(); ++triangle)
        for (std::size_t corner = 0; corner < 3; ++corner)
            least = std::min(least, glm::dot(face_normal(mesh, triangle), normal_at(mesh, triangle, corner)));
    return glm::degrees(std::acos(std::clamp(least, -1.0, 1.0)));
}

/// Counts the normals that meet at a position.
std::size_t normals_at(const Mesh& mesh, const glm::vec3& place) {
    std::size_t count = 0;
    for (const glm::vec3& position : mesh.positions) count += glm::length(position - place) < 1e-5F;
    return count;
}

/// Writes a box with random edge lengths in a random pose, each side a quad or two triangles.
std::string box(std::mt19937& random, bool in_triangles) {
    std::normal_distribution<double> normal;
    const glm::dvec3 a = glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
    const glm::dvec3 b = glm::normalize(glm::cross(a, glm::dvec3(0.2, 0.7, -0.4)));
    const glm::dvec3 axes[] = {a, b, glm::cross(a, b)};
    std::uniform_real_distribution<double> length(0.1, 5.0);
    const glm::dvec3 size(length(random), length(random), length(random));
    std::ostringstream text;
    text.precision(17);
    for (int corner = 0; corner < 8; ++corner) {
        glm::dvec3 place(1e4, -2e5, 0.0);
        for (int axis = 0; axis < 3; ++axis) place += axes[axis] * (corner >> axis & 1 ? size[axis] : 0.0);
        text << "v " << place.x << ' ' << place.y << ' ' << place.z << '\n';
    }
    const int sides[6][4] = {{1, 3, 4, 2}, {5, 6, 8, 7}, {1, 2, 6, 5}, {3, 7, 8, 4}, {1, 5, 7, 3}, {2, 4, 8, 6}};
    for (const auto& side : sides)
        if (in_triangles)
            text << "f " << side[0] << ' ' << side[1] << ' ' << side[2] << "\nf " << side[0] << ' ' << side[2] << ' '
                 << side[3] << '\n';
        else
            text << "f " << side[0] << ' ' << side[1] << ' ' << side[2] << ' ' << side[3] << '\n';
    return text.str();
}

TEST(ObjNormals, BoxHasThoseOfItsSides) {
    std::mt19937 random(seed);
    for (int i = 0; i < 40; ++i) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", box " + std::to_string(i));
        const std::string text = box(random, i % 2 == 1);
        const Mesh mesh = read(text);
        EXPECT_LT(largest_bend_deg(mesh), 0.1);
        EXPECT_EQ(mesh.positions.size(), 24U) << "four corners a side, even of two triangles";
        EXPECT_LT(largest_bend_deg(read(text, 89.0)), 0.1);
        EXPECT_NEAR(largest_bend_deg(read(i % 2 == 1 ? "s off\n" + text : text, 0.0)), 0.0, 0.1);
    }
}

/// Writes two squares that share an edge and meet at an angle, where 0 means that they are in one plane.
std::string hinge(double angle_deg, const std::string& before = "", const std::string& between = "") {
    const double angle = glm::radians(angle_deg);
    std::ostringstream text;
    text.precision(17);
    text << "v -1 0 0\nv -1 0 1\nv 0 0 0\nv 0 0 1\nv " << std::cos(angle) << ' ' << std::sin(angle) << " 0\nv "
         << std::cos(angle) << ' ' << std::sin(angle) << " 1\n"
         << before << "f 1 2 4 3\n"
         << between << "f 3 4 6 5\n";
    return text.str();
}

TEST(ObjNormals, EdgeIsSmoothUpToTheCreaseAngle) {
    for (const double crease : {0.0, 10.0, 30.0, 89.0, 90.0, 120.0, 179.0}) {
        for (const double angle : {crease - 0.5, crease, crease + 0.5}) {
            if (angle < 0.0) continue;
            SCOPED_TRACE(std::to_string(angle) + " against " + std::to_string(crease));
            const Mesh mesh = read(hinge(angle), crease);
            const bool is_smooth = angle <= crease;
            EXPECT_EQ(mesh.positions.size(), is_smooth ? 6U : 8U);
            EXPECT_NEAR(largest_bend_deg(mesh), is_smooth ? angle / 2.0 : 0.0, 0.1)
                << "halfway between two equal squares";
        }
    }
    EXPECT_EQ(read(hinge(30.0)).positions.size(), 6U) << "the default is 30 degrees";
    EXPECT_EQ(read(hinge(30.5)).positions.size(), 8U);
    EXPECT_EQ(read(hinge(179.9), 180.0).positions.size(), 6U);
}

TEST(ObjNormals, FollowSmoothingGroups) {
    EXPECT_EQ(read(hinge(80.0, "s 1\n")).positions.size(), 6U) << "one group is smooth at any angle";
    EXPECT_EQ(read(hinge(80.0, "s 1\n"), 0.0).positions.size(), 6U);
    EXPECT_EQ(read(hinge(80.0, "s on\n")).positions.size(), 6U);
    EXPECT_EQ(read(hinge(5.0, "s 1\n", "s 2\n")).positions.size(), 8U) << "two groups are never smooth";
    EXPECT_EQ(read(hinge(5.0, "s 1\n", "s 01\n")).positions.size(), 6U) << "both names mean one group";
    EXPECT_EQ(read(hinge(5.0, "s off\n")).positions.size(), 8U);
    EXPECT_EQ(read(hinge(5.0, "s 0\n"), 180.0).positions.size(), 8U);
    EXPECT_EQ(read(hinge(5.0, "s 1\n", "s off\n")).positions.size(), 8U);
    EXPECT_EQ(read(hinge(5.0, "", "s 1\n")).positions.size(), 8U) << "faces before the first group have none";
}

/// Writes a tube of `sides` quads without caps.
std::string tube(int sides) {
    std::ostringstream text;
    text.precision(17);
    for (int i = 0; i < sides; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / sides;
        for (const int y : {0, 1}) text << "v " << std::cos(angle) << ' ' << y << ' ' << -std::sin(angle) << '\n';
    }
    for (int i = 0; i < sides; ++i) {
        const int here = 2 * i + 1, next = 2 * ((i + 1) % sides) + 1;
        text << "f " << here << ' ' << next << ' ' << next + 1 << ' ' << here + 1 << '\n';
    }
    return text.str();
}

TEST(ObjNormals, RoundTubePointsAwayFromItsAxis) {
    const Mesh round = read(tube(24)), edged = read(tube(8));
    ASSERT_EQ(round.positions.size(), 48U);
    for (std::size_t i = 0; i < round.positions.size(); ++i) {
        const glm::vec3 out = glm::normalize(round.positions[i] * glm::vec3(1, 0, 1));
        EXPECT_LT(glm::length(round.normals[i] - out), 1e-5);
    }
    EXPECT_EQ(edged.positions.size(), 32U) << "45 degrees between sides";
    EXPECT_LT(largest_bend_deg(edged), 0.1);
}

// A pyramid with many sides. Around its tip, each side joins the next one smoothly, so all share one normal.
TEST(ObjNormals, AreJoinedAcrossEdgesAroundATip) {
    std::ostringstream text;
    text << "v 0 2 0\n";
    for (int i = 0; i < 16; ++i)
        text << "v " << std::cos(std::numbers::pi * i / 8) << " 0 " << -std::sin(std::numbers::pi * i / 8) << '\n';
    for (int i = 0; i < 16; ++i) text << "f 1 " << 2 + i << ' ' << 2 + (i + 1) % 16 << '\n';
    const Mesh mesh = read(text.str());
    EXPECT_EQ(mesh.positions.size(), 17U);
    EXPECT_LT(glm::length(mesh.normals[0] - glm::vec3(0, 1, 0)), 1e-5);
    EXPECT_EQ(normals_at(mesh, {0, 1, 0}), 1U);
}

TEST(ObjNormals, FaceWithoutNormalsLeavesTheOthers) {
    const std::string given = "vn 0 0.6 0.8\n";
    const Mesh mesh = read(hinge(10.0, given + "f 1//1 2//1 4//1 3//1\n") + "f 3//1 6//1 4\n");
    std::set<std::size_t> made;
    for (std::size_t triangle = 0; triangle < mesh.triangle_count(); ++triangle)
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const bool is_given = triangle < 2 || (triangle == 6 && corner < 2);
            EXPECT_EQ(glm::length(normal_at(mesh, triangle, corner) - glm::dvec3(0, 0.6, 0.8)) < 1e-6, is_given)
                << triangle << ", " << corner;
        }
}

TEST(ObjNormals, BothSidesOfASheetKeepTheirOwn) {
    for (const char* smoothing : {"", "s 1\n", "s off\n"}) {
        const Mesh mesh = read(std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\n") + smoothing + "f 1 2 3\nf 3 2 1\n");
        ASSERT_EQ(mesh.triangle_count(), 2U);
        if (std::string(smoothing) != "s 1\n") {
            EXPECT_LT(largest_bend_deg(mesh), 0.1) << smoothing;
        }
        for (const glm::vec3& normal : mesh.normals) EXPECT_NEAR(std::abs(normal.z), 1.0, 1e-6) << smoothing;
    }
}

TEST(ObjNormals, ManyFacesAtOneEdgeTakeProportionalTime) {
    std::string text = "v 0 0 0\nv 0 1 0\nv 1 0 0\nv 0 0 1\n";
    for (int i = 0; i < 200'000; ++i) text += i % 2 == 0 ? "f 1 2 3\n" : "f 1 2 4\n";
    EXPECT_EQ(read(text).triangle_count(), 200'000U);
}

}  // namespace
}  // namespace viewing::obj_normals
