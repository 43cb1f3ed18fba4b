// Shadow, mirror, patch and oblique near plane: worked examples, then properties over random planes.
#include "geometry/plane.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "geometry/projection.h"
#include "unit/geometry/expect_near.h"
#include "unit/geometry/random.h"

namespace viewing {
namespace {

using testing::expect_near;

const glm::dvec4 ground(0, 1, 0, 0);

glm::dvec4 tilted() {
    return glm::dvec4(glm::dvec3(1.0 / std::sqrt(3.0)), -2.0);
}

glm::dvec3 divided(const glm::dvec4& p) {
    return glm::dvec3(p) / p.w;
}

double distance(const glm::dvec4& plane, const glm::dvec3& point) {
    return glm::dot(plane, glm::dvec4(point, 1));
}

glm::dvec4 random_plane(Random& random) {
    return {random.direction(), random.number(-5, 5)};
}

glm::dvec4 random_light(Random& random, int i) {
    return {random.vec3(10), i % 3 == 0 ? 0.0 : i % 3 == 1 ? 1.0 : 0.4};
}

/// Computes the rank by Gaussian elimination with full pivoting.
int rank_of(glm::dmat4 m) {
    int rank = 0;
    for (; rank < 4; ++rank) {
        int best_column = rank, best_row = rank;
        for (int column = rank; column < 4; ++column) {
            for (int row = rank; row < 4; ++row) {
                if (std::abs(m[column][row]) > std::abs(m[best_column][best_row])) {
                    best_column = column, best_row = row;
                }
            }
        }
        if (std::abs(m[best_column][best_row]) < 1e-9) {
            break;
        }
        std::swap(m[rank], m[best_column]);
        for (int column = 0; column < 4; ++column) {
            std::swap(m[column][rank], m[column][best_row]);
        }
        for (int column = rank + 1; column < 4; ++column) {
            m[column] -= m[rank] * (m[column][rank] / m[rank][rank]);
        }
    }
    return rank;
}

TEST(Shadow, WorkedExamples) {
    const glm::dvec4 p(0, 10, 0, 1);
    expect_near(divided(shadow_matrix(ground, {12, 20, 0, 0}) * p), {-6, 0, 0}, 1e-12);
    expect_near(divided(shadow_matrix(ground, {12, 20, 0, 1}) * p), {-12, 0, 0}, 1e-12);
    expect_near(divided(shadow_matrix(tilted(), {5, 9, 7, 1}) * glm::dvec4(1, 2, 3, 1)), {0.323760, 0.816581, 2.323760},
                5e-7);
}

TEST(Shadow, IsTheLecturesMatrixOnTheGround) {
    // Rows of the slide: (l_y, −l_x, 0, 0), (0, 0, 0, 0), (0, −l_z, l_y, 0), (0, −1, 0, l_y).
    const glm::dmat4 rows = glm::transpose(shadow_matrix(ground, {2, 5, 3, 1}));
    EXPECT_EQ(rows, glm::dmat4(5, -2, 0, 0, 0, 0, 0, 0, 0, -3, 5, 0, 0, -1, 0, 5));
}

TEST(Shadow, Properties) {
    SCOPED_TRACE(seed);
    Random random(seed);
    for (int i = 0; i < 300; ++i) {
        const glm::dvec4 plane = random_plane(random), light = random_light(random, i);
        const double plane_dot_light = glm::dot(plane, light);
        if (std::abs(plane_dot_light) < 0.1) {
            continue;
        }
        const glm::dmat4 shadow = shadow_matrix(plane, light);
        EXPECT_LT(worst_difference(shadow * shadow, plane_dot_light * shadow), 1e-11);
        EXPECT_LT(glm::length(shadow * light), 1e-12 * glm::dot(light, light) * 10);
        EXPECT_NEAR(glm::determinant(shadow), 0, 1e-9);
        EXPECT_EQ(rank_of(shadow), 3);

        const glm::dvec3 point = random.vec3(10);
        const glm::dvec3 foot = point - distance(plane, point) * glm::dvec3(plane);
        expect_near(divided(shadow * glm::dvec4(foot, 1)), foot, 1e-9);
    }
}

TEST(Shadow, HasRankOneWhenTheLightIsInThePlane) {
    const glm::dmat4 shadow = shadow_matrix(ground, {3, 0, 5, 1});
    EXPECT_EQ(rank_of(shadow), 1);
    EXPECT_EQ(shadow_sign(ground, {3, 0, 5, 1}), 1.0);
}

TEST(Shadow, PointsAreOnThePlaneAndOnTheRay) {
    SCOPED_TRACE(seed);
    Random random(seed);
    for (int i = 0; i < 300; ++i) {
        const glm::dvec4 plane = random_plane(random), light(random.vec3(10), 1.0);
        const glm::dvec3 point = random.vec3(10);
        const glm::dvec4 image = shadow_matrix(plane, light) * glm::dvec4(point, 1);
        if (std::abs(image.w) < 0.5) {
            continue;
        }
        const glm::dvec3 shadow = divided(image), ray = glm::normalize(point - glm::dvec3(light));
        EXPECT_NEAR(distance(plane, shadow), 0, 1e-10);
        EXPECT_NEAR(glm::length(glm::cross(ray, shadow - point)), 0, 1e-10);
    }
}

TEST(Shadow, SignMakesWPositiveForCastersOnEitherSide) {
    SCOPED_TRACE(seed);
    Random random(seed);
    for (int i = 0; i < 300; ++i) {
        const glm::dvec4 plane = random_plane(random), light(random.vec3(10), 1.0);
        const double light_height = distance(plane, glm::dvec3(light));
        const glm::dvec3 foot = glm::dvec3(light) - light_height * glm::dvec3(plane);
        const glm::dvec3 caster = glm::mix(foot, glm::dvec3(light), random.number(0.01, 0.99));
        const glm::dmat4 uploaded = shadow_sign(plane, light) * shadow_matrix(plane, light);
        EXPECT_GT((uploaded * glm::dvec4(caster, 1)).w, 0.0);
        EXPECT_EQ(worst_difference(uploaded, shadow_sign(-plane, light) * shadow_matrix(-plane, light)), 0.0);
    }
    EXPECT_EQ(shadow_sign(ground, {0, -1, 0, 1}), -1.0);
    EXPECT_EQ(shadow_sign(ground, {0, 1, 0, 0}), 1.0);
}

TEST(Mirror, WorkedExample) {
    expect_near(glm::dvec3(mirror_matrix(tilted()) * glm::dvec4(1, 2, 3, 1)), {-0.690599, 0.309401, 1.309401}, 5e-7);
    EXPECT_EQ(mirror_matrix(ground), glm::dmat4(1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1));
}

TEST(Mirror, Properties) {
    SCOPED_TRACE(seed);
    Random random(seed);
    for (int i = 0; i < 300; ++i) {
        const glm::dvec4 plane = random_plane(random);
        const glm::dmat4 mirror = mirror_matrix(plane);
        EXPECT_LT(worst_difference(mirror * mirror, glm::dmat4(1.0)), 1e-13);
        EXPECT_NEAR(glm::determinant(mirror), -1, 1e-13);
        const glm::dvec4 normal(glm::dvec3(plane), 0);
        EXPECT_LT(glm::length(mirror * normal + normal), 1e-13);

        const glm::dvec3 point = random.vec3(10);
        const glm::dvec3 image(mirror * glm::dvec4(point, 1));
        EXPECT_NEAR(distance(plane, image), -distance(plane, point), 1e-12);
        EXPECT_NEAR(glm::length(glm::cross(glm::dvec3(plane), image - point)), 0, 1e-12);
        EXPECT_LT(worst_difference(mirror, mirror_matrix(-plane)), 1e-300);
    }
}

TEST(UnitPlane, KeepsTheSignAndThePlane) {
    EXPECT_EQ(unit_plane({0, -4, 0, 8}), glm::dvec4(0, -1, 0, 2));
    EXPECT_EQ(unit_plane({3, 0, 4, 5}), glm::dvec4(0.6, 0, 0.8, 1));
}

TEST(Patch, AxesMatchTheContract) {
    struct Case {
        glm::dvec4 plane;
        glm::dvec3 normal, u, v;
    };
    // By hand: e is the last axis with the smallest |component| of n′, u = unit(n′ × e), v = u × n′.
    const Case cases[] = {
        {{0, 1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}},
        {{0, -1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}},
        {{2, 0, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 0, 1}},
        {{0, 0, -3, 0}, {0, 0, 1}, {-1, 0, 0}, {0, 1, 0}},
        {{0, -3, -4, 0}, {0, 0.6, 0.8}, {0, 0.8, -0.6}, {1, 0, 0}},
    };
    for (const Case& c : cases) {
        const PlanePatch patch = plane_patch(c.plane, 4);
        expect_near(patch.normal, c.normal, 1e-15);
        expect_near(patch.u, c.u, 1e-15);
        expect_near(patch.v, c.v, 1e-15);
        EXPECT_EQ(patch.extent, 4.0);
    }
}

TEST(Patch, PropertiesAndEqualityForMultiples) {
    SCOPED_TRACE(seed);
    Random random(seed);
    for (int i = 0; i < 300; ++i) {
        const glm::dvec4 plane = random_plane(random);
        const PlanePatch patch = plane_patch(plane, 3);
        EXPECT_NEAR(distance(plane, patch.center), 0, 1e-12);
        EXPECT_NEAR(glm::length(glm::cross(patch.center, patch.normal)), 0, 1e-12) << "nearest to the origin";
        EXPECT_NEAR(glm::length(patch.u), 1, 1e-14);
        EXPECT_NEAR(glm::length(patch.v), 1, 1e-14);
        expect_near(glm::cross(patch.u, patch.normal), patch.v, 1e-14);
        const auto [least, most] = std::minmax({patch.normal.x, patch.normal.y, patch.normal.z});
        EXPECT_GT(most, -least) << "the largest component is positive";
        for (const glm::dvec3& corner : patch.corners()) {
            EXPECT_NEAR(distance(plane, corner), 0, 1e-12);
            EXPECT_NEAR(glm::length(corner - patch.center), 3 * std::sqrt(2.0), 1e-12);
        }
        for (const double factor : {-1.0, 2.0, -0.5}) {
            const PlanePatch same = plane_patch(plane * factor, 3);
            EXPECT_EQ(std::memcmp(&same, &patch, sizeof patch), 0) << "factor " << factor;
        }
    }
    const PlanePatch flipped = plane_patch(-ground, 3), straight = plane_patch(ground, 3);
    EXPECT_EQ(std::memcmp(&flipped, &straight, sizeof straight), 0) << "no negative zeros";
}

TEST(Patch, MatrixSendsTheQuadToThePatch) {
    const PlanePatch patch = plane_patch({1, 2, -2, 6}, 5);
    const glm::dmat4 world_from_patch = patch.world_from_patch();
    EXPECT_GT(glm::determinant(world_from_patch), 0.0) << "preserves the winding";
    expect_near(glm::dvec3(world_from_patch * glm::dvec4(0, 1, 0, 0)), patch.normal, 1e-15);
    const double side[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    for (std::size_t i = 0; i < 4; ++i) {
        expect_near(glm::dvec3(world_from_patch * glm::dvec4(side[i][0], 0, side[i][1], 1)), patch.corners()[i], 1e-12);
    }
}

TEST(ObliqueNearPlane, ReplacesNearAndKeepsTheRest) {
    SCOPED_TRACE(seed);
    Random random(seed);
    for (const bool orthographic : {false, true}) {
        const glm::dmat4 clip = clip_from_view({.orthographic = orthographic, .near = 0.5, .far = 40}, 1.6);
        for (int i = 0; i < 100; ++i) {
            const glm::dvec3 normal = random.direction();
            const glm::dvec3 in_front(0, 0, -random.number(2, 10));
            glm::dvec4 plane(normal, -glm::dot(normal, in_front));
            plane *= plane.w > 0 ? -1.0 : 1.0;  // the eye is on the negative side
            const glm::dmat4 oblique = with_oblique_near_plane(clip, plane);

            glm::dvec3 on_plane = random.vec3(10);
            on_plane -= distance(plane, on_plane) * glm::dvec3(plane);
            const glm::dvec4 image = oblique * glm::dvec4(on_plane, 1);
            EXPECT_NEAR(image.z, -image.w, 1e-9);

            const glm::dvec3 point = random.vec3(10);
            const glm::dvec4 before = clip * glm::dvec4(point, 1), after = oblique * glm::dvec4(point, 1);
            EXPECT_EQ(glm::dvec3(before.x, before.y, before.w), glm::dvec3(after.x, after.y, after.w));
            EXPECT_EQ(after.z >= -after.w, distance(plane, point) >= 0.0) << "clips the negative side";
        }
    }
}

TEST(ObliqueNearPlane, BeyondTheFrustumClipsEverything) {
    const glm::dmat4 clip = clip_from_view({.near = 1, .far = 10}, 1.0);
    const glm::dmat4 oblique = with_oblique_near_plane(clip, {0, 0, -1, -20});
    for (const double z : {-1.0, -5.0, -10.0}) {
        const glm::dvec4 image = oblique * glm::dvec4(0, 0, z, 1);
        EXPECT_TRUE(std::isfinite(image.z));
        EXPECT_LT(image.z, -image.w);
    }
}

}  // namespace
}  // namespace viewing
