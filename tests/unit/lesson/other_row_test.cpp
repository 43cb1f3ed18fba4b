// A wrong row of R or S that would be right for another plane or light. The rows are computed from the images of
// points, not from R's and S's formulas.
#include "lesson/questions/other_row.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <random>

#include "lesson/questions/judge.h"

namespace viewing {
namespace {

constexpr glm::dvec4 light(3, 4, 0, 1), floor_plane(0, 1, 0, 0);

void expect_near(const std::optional<glm::dvec4>& found, const glm::dvec4& plane) {
    ASSERT_TRUE(found);
    for (int i = 0; i < 4; ++i) EXPECT_NEAR((*found)[i], plane[i], 1e-9) << i;
}

TEST(OtherRow, OfAMirrorRowMirrorsPointsAlike) {
    std::mt19937 random(15);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    for (int round = 0; round < 200; ++round) {
        const glm::dvec3 n = glm::normalize(glm::dvec3(number(random), number(random), number(random)));
        const double d = 2.0 * number(random);
        // The origin and the three unit points are reflected: each moves along the normal by twice its distance from
        // the plane.
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

TEST(OtherRow, OfAShadowRowIsWorkedOutByHand) {
    // The plane y = 0.5: w = 4 − p_y and s_x w = 3 (4 − p_y) + 3.5 (p_x − 3) = 3.5 p_x − 3 p_y + 1.5.
    expect_near(plane_of_shadow_row({3.5, -3, 0, 1.5}, 0, light, floor_plane), {0, 1, 0, -0.5});
    EXPECT_FALSE(plane_of_shadow_row({3.5, -2, 0, 1.5}, 0, light, floor_plane));
    EXPECT_FALSE(plane_of_shadow_row({0, 0, 3.5, 0}, 2, light, floor_plane)) << "ℓ_z is 0, so no plane follows";
    EXPECT_FALSE(plane_of_mirror_row({0, 0, 0, 2}, 3));
    EXPECT_FALSE(plane_of_mirror_row({1, 0, 0, 5}, 0));
}

TEST(OtherRow, IsToldForAnUnknownWrongMatrix) {
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
    EXPECT_EQ(judged({9, -3, 0, 1.5, 0, 0, 0, 0, 0, 0, 4, 0, 0, -1, 0, 4}).other_row, 0) << "no plane has this row";
    ask.expect = "{{1, 0, 0, 0}, {0, -1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}";
    const Verdict mirror = judged({1, 0, 0, 0, 0, -1, 0, 1, 0, 0, 1, 0, 0, 0, 0, 1});  // y′ = 1 − y: the plane y = 0.5
    EXPECT_EQ(mirror.other_row, 2);
    EXPECT_EQ(mirror.other_plane, (std::vector<double>{0, 1, 0, -0.5}));
}

/// Returns the row of S whose product with (p, 1) is s_i w, where s is a point on the line from the light through p.
/// Follows the rays through the unit points, without S's formula. `plane` has a unit normal, and the light's w is 1.
glm::dvec4 row_of_rays(const glm::dvec4& plane, const glm::dvec3& light_world, int index) {
    const auto height = [&](const glm::dvec3& p) { return glm::dot(glm::dvec3(plane), p) + plane.w; };
    const auto times_w = [&](const glm::dvec3& p) {  // s w with w = height(ℓ) − height(p), or w itself for row 3
        const double w = height(light_world) - height(p);
        const glm::dvec3 s_w = w * light_world + height(light_world) * (p - light_world);
        return index == 3 ? w : s_w[index];
    };
    glm::dvec4 row(0.0);
    row.w = times_w(glm::dvec3(0.0));
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 point(0.0);
        point[axis] = 1.0;
        row[axis] = times_w(point) - row.w;
    }
    return row;
}

Surroundings with_plane_and_light(const glm::dvec4& plane, const glm::dvec3& at) {
    Surroundings scene;
    scene.look_up = [=](const std::string& name, std::span<const double>) -> Result<Json> {
        return name == "plane" ? Json{{"equation", {plane.x, plane.y, plane.z, plane.w}}}
                               : Json{{"position", {at.x, at.y, at.z, 1}}};
    };
    return scene;
}

TEST(OtherRow, AllRowsOfAnotherLightTellThatLight) {
    std::mt19937 random(16);
    std::uniform_real_distribution<double> number(-3.0, 3.0);
    int told = 0;
    for (int round = 0; round < 200; ++round) {
        const glm::dvec3 n = glm::normalize(glm::dvec3(number(random), number(random), number(random)));
        const glm::dvec4 plane(n, number(random));
        const glm::dvec3 asked(number(random), number(random), number(random));
        const glm::dvec3 other(number(random), number(random), number(random));
        std::vector<double> typed;
        for (int row = 0; row < 4; ++row)
            for (int i = 0; i < 4; ++i) typed.push_back(row_of_rays(plane, other, row)[i]);
        const std::optional<OtherRow> found = other_row(
            typed, {}, "shadow_matrix(unit(plane.equation), light.position)", with_plane_and_light(plane, asked));
        ASSERT_TRUE(found) << "round " << round;
        EXPECT_EQ(found->row, 1);
        if (!found->is_light) continue;  // the first row may also be right for another plane
        ++told;
        expect_near(found->numbers, {other, 1.0});
    }
    EXPECT_GT(told, 190);
}

TEST(OtherRow, OneRowOfAnotherLightIsWorkedOutByHand) {
    // The floor: row 1 is (ℓ_y, −ℓ_x, 0, 0), row 3 is (0, −ℓ_z, ℓ_y, 0), row 4 is (0, −ℓ_w, 0, ℓ_y).
    expect_near(light_of_shadow_row({4, -1, 0, 0}, 0, floor_plane, light), {1, 4, 0, 1});
    expect_near(light_of_shadow_row({5, -1, 0, 0}, 0, floor_plane, light), {1, 5, 0, 1});
    expect_near(light_of_shadow_row({0, -2, 4, 0}, 2, floor_plane, light), {3, 4, 2, 1});
    expect_near(light_of_shadow_row({0, 0, 0, 4}, 3, floor_plane, light), {3, 4, 0, 0});
    EXPECT_FALSE(light_of_shadow_row({0, 0, 0, 0}, 1, floor_plane, light));
    EXPECT_FALSE(light_of_shadow_row({0, 4, 0, 0}, 1, floor_plane, light)) << "outside row 2's diagonal, Π is 0";
    EXPECT_FALSE(light_of_shadow_row({4, -1, 2, 0}, 0, floor_plane, light)) << "no light has this row";
    // The row gives another Π·L, which two of the light's numbers could each produce, so the light is undetermined.
    EXPECT_FALSE(light_of_shadow_row({9, -1, -1, 0}, 0, {0, 1, 1, 0}, light));
}

TEST(OtherRow, ARowOfAnotherLightIsToldForAnUnknownWrongMatrix) {
    Ask ask;
    ask.kind = AskKind::matrix;
    ask.rows = ask.columns = 4;
    ask.tolerance = 0.01;
    ask.expect = "{{4, -3, 0, 0}, {0, 0, 0, 0}, {0, 0, 4, 0}, {0, -1, 0, 4}}";
    const Surroundings scene = with_plane_and_light(floor_plane, {3, 4, 0});
    const auto judged = [&](std::vector<double> numbers) { return *judge(ask, {std::move(numbers), {}}, scene); };
    const Verdict other = judged({4, -3, 0, 0, 0, 0, 0, 0, 0, -2, 4, 0, 0, -1, 0, 4});
    EXPECT_EQ(other.places, (std::vector<int>{1, 2, 4}));
    EXPECT_EQ(other.other_row, 3);
    EXPECT_EQ(other.other_light, (std::vector<double>{3, 4, 2, 1}));
    EXPECT_TRUE(other.other_plane.empty());
    ask.up_to_factor = true;
    const Verdict twice = judged({8, -6, 0, 0, 0, 0, 0, 0, 0, -4, 8, 0, 0, -2, 0, 8});
    EXPECT_EQ(twice.other_row, 3);
    EXPECT_EQ(twice.other_light, (std::vector<double>{3, 4, 2, 1})) << "the light is not doubled";
    EXPECT_EQ(judged(std::vector<double>(16, 0.0)).other_row, 0) << "nothing is entered";
}

}  // namespace
}  // namespace viewing
