// Measures of matrices, tested on matrices with known values.
#include "frame/matrix_facts.h"

#include <gtest/gtest.h>

namespace viewing {
namespace {

TEST(MatrixFacts, SameMapUpToAFactorHasNoDifference) {
    const glm::dmat4 shadow{{5.2, 0, 0, 0}, {-2.6, 0, -2.2, -1}, {0, 0, 5.2, 0}, {0, 0, 0, 5.2}};
    for (const double factor : {1.0, 2.0, -1.0, 1e-6, -3e5})
        EXPECT_LT(largest_difference_up_to_scale(factor * shadow, shadow), 1e-12) << factor;
    glm::dmat4 wrong = shadow;
    wrong[3][0] += 1.0;
    EXPECT_GT(largest_difference_up_to_scale(wrong, shadow), 0.9);
    EXPECT_EQ(largest_difference_up_to_scale(glm::dmat4(0.0), shadow), 5.2) << "zero is not a factor of a matrix";
}

TEST(MatrixFacts, RankCountsIndependentColumns) {
    EXPECT_EQ(rank_of(glm::dmat4(0.0)), 0);
    EXPECT_EQ(rank_of(glm::dmat4(7.0)), 4);
    EXPECT_EQ(rank_of(glm::dmat4(glm::dvec4(1, 2, 3, 4), glm::dvec4(2, 4, 6, 8), glm::dvec4(0, 0, 1, 0),
                                 glm::dvec4(1, 2, 4, 4))),
              2);
}

}  // namespace
}  // namespace viewing
