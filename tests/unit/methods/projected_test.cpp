// The functions with which Newell's cheap tests decide whether two projections are separated along an axis, or do not
// overlap at all.
#include "topics/hidden/methods/projected.h"

#include <gtest/gtest.h>

namespace viewing {
namespace {

/// Returns screen corners in the form that project() produces.
Projected on_screen(std::vector<glm::dvec2> corners) {
    Projected made{0.0, 0.0, corners.front(), corners.front(), {}};
    for (const glm::dvec2& corner : corners) {
        made.min = glm::min(made.min, corner);
        made.max = glm::max(made.max, corner);
    }
    made.corners = std::move(corners);
    return made;
}

Projected square(double x, double y) {
    return on_screen({{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}});
}

TEST(Projected, IsSeparateOnAnAxisOnEitherSide) {
    const Projected middle = square(0, 0);
    for (const double side : {-1.5, 1.5}) {
        EXPECT_TRUE(apart_on(0, middle, square(side, 0)));
        EXPECT_FALSE(apart_on(1, middle, square(side, 0)));
        EXPECT_TRUE(apart_on(1, middle, square(0, side)));
        EXPECT_FALSE(apart_on(0, middle, square(0, side)));
    }
    for (const double side : {-1.0, 1.0}) EXPECT_TRUE(apart_on(0, middle, square(side, 0))) << "they touch";
    for (const double side : {-0.5, 0.5}) EXPECT_FALSE(apart_on(0, middle, square(side, 0)));
}

TEST(Projected, IsDisjointDespiteOverlappingExtents) {
    const Projected below = on_screen({{0, 0}, {4, 0}, {0, 4}});
    const Projected beyond = on_screen({{4, 1}, {4, 4}, {1, 4}}), across = on_screen({{3, 3}, {1, 1}, {3, 1}});
    EXPECT_FALSE(apart_on(0, below, beyond) || apart_on(1, below, beyond));
    EXPECT_TRUE(are_disjoint(below, beyond) && are_disjoint(beyond, below));
    EXPECT_FALSE(are_disjoint(below, across) || are_disjoint(across, below));
}

}  // namespace
}  // namespace viewing
