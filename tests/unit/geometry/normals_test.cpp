// Transformed normals, checked against two transformed tangents.
#include "geometry/normals.h"

#include <gtest/gtest.h>

#include <limits>

#include "unit/geometry/random.h"

namespace viewing {
namespace {

TEST(Normals, StayPerpendicularToTheTransformedSurface) {
    Random random(seed);
    for (int i = 0; i < 500; ++i) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", matrix " + std::to_string(i));
        glm::dmat3 matrix(random.vec3(2), random.vec3(2), random.vec3(2));
        if (i % 5 == 0) matrix[2] = matrix[0] + 0.5 * matrix[1];  // a singular matrix
        const glm::dvec3 a = random.vec3(1), b = random.vec3(1);
        const glm::dvec3 moved = glm::cross(matrix * a, matrix * b);
        const glm::dvec3 normal = normal_matrix(matrix) * glm::cross(a, b);
        EXPECT_GT(glm::dot(normal, moved), 0.0);
        EXPECT_LT(glm::length(glm::cross(normal, moved)), 1e-12 * (1.0 + glm::length(normal) * glm::length(moved)));
    }
}

TEST(Normals, FitIntoFloats) {
    for (const double size : {1e-30, 1.0, 1e30}) {
        const glm::dmat3 made = normal_matrix(glm::dmat3(size));
        for (int axis = 0; axis < 3; ++axis) EXPECT_DOUBLE_EQ(made[axis][axis], 1.0) << size;
    }
    EXPECT_EQ(normal_matrix(glm::dmat3(0.0)), glm::dmat3(0.0));
}

TEST(Normals, DirectionsAreUnitForAnyVectorLength) {
    Random random(seed);
    for (const double size : {1e-300, 1e-30, 1.0, 1e30, 1e300}) {
        const glm::dvec3 vector = random.vec3(1), direction = direction_of(size * vector);
        EXPECT_NEAR(glm::length(direction), 1.0, 1e-12) << size;
        EXPECT_LT(glm::length(direction - glm::normalize(vector)), 1e-9) << size;
    }
    const double infinite = std::numeric_limits<double>::infinity(), none = std::numeric_limits<double>::quiet_NaN();
    for (const glm::dvec3& vector : {glm::dvec3(0.0), glm::dvec3(infinite, 0, 0), glm::dvec3(1, none, 0)})
        EXPECT_EQ(direction_of(vector), glm::dvec3(0.0));
}

}  // namespace
}  // namespace viewing
