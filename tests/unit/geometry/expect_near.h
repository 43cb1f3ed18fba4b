// Vectors compared component by component.
#pragma once

#include <gtest/gtest.h>

#include <glm/glm.hpp>

namespace viewing::testing {

inline void expect_near(const glm::dvec3& actual, const glm::dvec3& expected, double tolerance) {
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(actual[i], expected[i], tolerance) << "component " << i;
    }
}

}  // namespace viewing::testing
