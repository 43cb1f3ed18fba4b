// Answers that are a matrix: products of tiles, and the state that shows a product.
#include "lesson/questions/typed_matrix.h"

#include <gtest/gtest.h>

namespace viewing {
namespace {

Ask tiles() {
    Ask ask;
    ask.kind = AskKind::product;
    ask.factors = {"translation({1, 2, 3})", "rotation_y(90)",
                   "{{2, 0, 0, 0}, {0, 3, 0, 0}, {0, 0, 4, 0}, {0, 0, 0, 1}}", "{1, 2}"};
    return ask;
}

glm::dvec3 image_of(const glm::dmat4& matrix, const glm::dvec3& point) {
    return glm::dvec3(matrix * glm::dvec4(point, 1.0));
}

TEST(TypedMatrix, ProductsGrowFromLeftToRight) {
    const Result<std::vector<glm::dmat4>> grown = products_of(tiles(), {0, 1, 2}, {});
    ASSERT_TRUE(grown) << grown.error();
    ASSERT_EQ(grown->size(), 3U);
    // T alone shifts. In T R_y the rotation acts first: x goes to −z. In T R_y D the stretching acts before both.
    EXPECT_LT(glm::length(image_of((*grown)[0], {1, 0, 0}) - glm::dvec3(2, 2, 3)), 1e-12);
    EXPECT_LT(glm::length(image_of((*grown)[1], {1, 0, 0}) - glm::dvec3(1, 2, 2)), 1e-12);
    EXPECT_LT(glm::length(image_of((*grown)[2], {1, 1, 0}) - glm::dvec3(1, 5, 1)), 1e-12);
    EXPECT_TRUE(products_of(tiles(), {}, {})->empty());
    const Result<std::vector<glm::dmat4>> none = products_of(tiles(), {0, 3}, {});
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().find("4 by 4 matrix"), std::string::npos) << none.error();
}

TEST(TypedMatrix, AProductIsShownByTheCameraThatHasIt) {
    LessonStep step;
    step.ask = tiles();
    step.ask.shows_as = "C";
    const glm::dmat4 product = products_of(step.ask, {0, 1}, {})->back();
    const Result<LoadedState> shown = with_typed_matrix(step, product);
    ASSERT_TRUE(shown) << shown.error();
    EXPECT_EQ(shown->params.camera.position, glm::dvec3(1, 2, 3));
    EXPECT_NEAR(shown->params.camera.yaw, 90.0, 1e-9);
    EXPECT_NEAR(shown->params.camera.pitch, 0.0, 1e-9);
    // As V, the product undoes the camera's pose, so the eye is at R_y(−90°) (−1, −2, −3) = (3, −2, −1).
    step.ask.shows_as = "V";
    const Result<LoadedState> as_view = with_typed_matrix(step, product);
    ASSERT_TRUE(as_view) << as_view.error();
    EXPECT_LT(glm::length(as_view->params.camera.position - glm::dvec3(3, -2, -1)), 1e-9);
    EXPECT_NEAR(as_view->params.camera.yaw, -90.0, 1e-9);
    const Result<LoadedState> none = with_typed_matrix(step, products_of(step.ask, {0, 2}, {})->back());
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().find("no camera"), std::string::npos) << none.error();
}

}  // namespace
}  // namespace viewing
