// Comparing ID pictures: which polygon was drawn over which.
#include "topics/hidden/methods/difference.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace viewing {
namespace {

TEST(WorstPair, IsTheOneWithMostPixelsAndItsPlace) {
    IdImage reference(20, 10), image(20, 10);
    // The reference is 1 on the left and 2 on the right. The picture shows 2 in a block where the reference is 1, and 3
    // in a smaller block where the reference is 2.
    for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 20; ++x) {
            const std::size_t at = reference.index(x, y);
            reference.ids[at] = image.ids[at] = x < 10 ? 1 : 2;
            if (x >= 2 && x < 6 && y >= 4 && y < 8) image.ids[at] = 2;
            if (x >= 14 && x < 16 && y >= 1 && y < 3) image.ids[at] = 3;
        }
    reference.ids[reference.index(19, 9)] = IdImage::background;  // background pixels do not count
    const auto worst = worst_pair(reference, image);
    ASSERT_TRUE(worst);
    EXPECT_EQ(worst->seen, 1);
    EXPECT_EQ(worst->drawn, 2);
    EXPECT_EQ(worst->pixels, 16);
    EXPECT_EQ(worst->all_pixels, 20);
    EXPECT_EQ(worst->compared, 200);
    EXPECT_NEAR(worst->x, 4.0 / 20.0, 1e-12);
    EXPECT_NEAR(worst->y, 6.0 / 10.0, 1e-12);
    EXPECT_FALSE(worst_pair(reference, reference));
}

/// A quad that ends at x = 10 + `beyond` pixels, drawn one pixel too wide in one row.
std::int64_t wrong_beside_edge(double beyond) {
    IdImage reference(20, 10), image(20, 10);
    const double right = (10.0 + beyond) / 10.0 - 1.0;
    const std::vector<Polygon> drawn{*make_polygon({{-1, -1, 0}, {right, -1, 0}, {right, 1, 0}, {-1, 1, 0}}, 0, 1),
                                     *make_polygon({{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}, 1, 2)};
    std::fill(reference.ids.begin(), reference.ids.end(), 2);
    image.ids = reference.ids;
    image.ids[image.index(10, 4)] = 1;
    return difference(reference, image, drawn, glm::dmat4(1.0)).different;
}

/// The pixel's center is at 10.5.
TEST(Difference, DoesNotCountWhatRoundingAtAnEdgeMayDecide) {
    EXPECT_EQ(wrong_beside_edge(0.5), 0);
    EXPECT_EQ(wrong_beside_edge(0.49), 0);
    EXPECT_EQ(wrong_beside_edge(0.51), 0);
    EXPECT_EQ(wrong_beside_edge(0.48), 1);
    EXPECT_EQ(wrong_beside_edge(0.52), 1);
    EXPECT_EQ(wrong_beside_edge(5.0), 1);
}

}  // namespace
}  // namespace viewing
