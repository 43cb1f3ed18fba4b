// A wrong row that belongs to another plane. The rows are worked out from where points go, not from R's and S's
// formulas.
#include "lesson/other_plane.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <random>

#include "lesson/judge.h"

namespace viewing {
namespace {

constexpr glm::dvec4 light(3, 4, 0, 1), floor_plane(0, 1, 0, 0);

void expect_near(const std::optional<glm::dvec4>& found, const glm::dvec4& plane) {
    ASSERT_TRUE(found);
    for (int i = 0; i < 4; ++i) EXPECT_NEAR((*found)[i], plane[i], 1e-9) << i;
}

TEST(OtherPlane, OfAMirrorRowMirrorsPointsAlike) {
    std::mt19937 random(15);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    for (int round = 0; round < 200; ++round) {
        const glm::dvec3 n = glm::normalize(glm::dvec3(number(random), number(random), number(random)));
        const double d = 2.0 * number(random);
        // Where mirroring takes the origin and the three unit points: each twice its distance along the normal.
        const auto mirrored = [&](const glm::dvec3& p) { return p - 2.0 * (glm::dot(n, p) + d) * n; };
        for (int row = 0; row < 3; ++row) {
            glm::dvec4 entries(0.0);
            entries[3] = mirrored(glm::dvec3(0.0))[row];
            for (int axis = 0; axis < 3; ++axis) {
                glm::dvec3 point(0.0);
                point[axis] = 1.0;
                entries[axis] = mirrored(point)[row] - entries[3];
            }
            if (std::abs(n[row]) < 0.01) continue;
            expect_near(plane_of_mirror_row(entries, row), (n[row] < 0.0 ? -1.0 : 1.0) * glm::dvec4(n, d));
        }
    }
}

TEST(OtherPlane, OfAShadowRowIsWorkedOutByHand) {
    // The plane y = 0.5: w = 4 − p_y and s_x w = 3 (4 − p_y) + 3.5 (p_x − 3) = 3.5 p_x − 3 p_y + 1.5.
    expect_near(plane_of_shadow_row({3.5, -3, 0, 1.5}, 0, light, floor_plane), {0, 1, 0, -0.5});
    EXPECT_FALSE(plane_of_shadow_row({3.5, -2, 0, 1.5}, 0, light, floor_plane));
    EXPECT_FALSE(plane_of_shadow_row({0, 0, 3.5, 0}, 2, light, floor_plane)) << "ℓ_z is 0: the row tells no plane";
    EXPECT_FALSE(plane_of_mirror_row({0, 0, 0, 2}, 3));
    EXPECT_FALSE(plane_of_mirror_row({1, 0, 0, 5}, 0));
}

TEST(OtherPlane, IsToldForAnUnknownWrongMatrix) {
    Surroundings scene;
    scene.look_up = [](const std::string& name, std::span<const double>) -> Result<Json> {
        return name == "plane" ? Json{{"equation", {0, 2, 0, 0}}} : Json{{"position", {3, 4, 0, 1}}};
    };
    Ask ask;
    ask.kind = AskKind::matrix;
    ask.rows = ask.columns = 4;
    ask.tolerance = 0.01;
    ask.expect = "{{4, -3, 0, 0}, {0, 0, 0, 0}, {0, 0, 4, 0}, {0, -1, 0, 4}}";
    const auto judged = [&](std::vector<double> numbers) { return *judge(ask, {std::move(numbers), {}}, scene); };
    const Verdict other = judged({3.5, -3, 0, 1.5, 0, 0, 0, 0, 0, 0, 4, 0, 0, -1, 0, 4});
    EXPECT_EQ(other.near, Near::right_parts);
    EXPECT_EQ(other.places, (std::vector<int>{2, 3, 4}));
    EXPECT_EQ(other.other_row, 1);
    EXPECT_EQ(other.other_plane, (std::vector<double>{0, 1, 0, -0.5}));
    EXPECT_EQ(judged({9, -3, 0, 1.5, 0, 0, 0, 0, 0, 0, 4, 0, 0, -1, 0, 4}).other_row, 0) << "of no plane";
    ask.expect = "{{1, 0, 0, 0}, {0, -1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}";
    const Verdict mirror = judged({1, 0, 0, 0, 0, -1, 0, 1, 0, 0, 1, 0, 0, 0, 0, 1});  // y′ = 1 − y: the plane y = 0.5
    EXPECT_EQ(mirror.other_row, 2);
    EXPECT_EQ(mirror.other_plane, (std::vector<double>{0, 1, 0, -0.5}));
}

}  // namespace
}  // namespace viewing
