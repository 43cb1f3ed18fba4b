// The camera's matrices, checked by their properties and against the lecture's slide for a heading.
#include "geometry/camera.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "unit/geometry/random.h"

namespace viewing {
namespace {

const glm::dmat4 identity(1.0);

TEST(Camera, ViewIsTheInverseOfTheCamera) {
    SCOPED_TRACE(seed);
    Random random(seed);
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 eye = random.vec3(50);
        const glm::dmat4 camera = world_from_view(eye, random.angles());
        const glm::dmat4 view = view_from_world(camera);
        EXPECT_LT(worst_difference(view * camera, identity), 1e-12);
        EXPECT_LT(worst_difference(view, glm::inverse(camera)), 1e-12);
        const glm::dvec4 eye_view = view * glm::dvec4(eye, 1.0);
        EXPECT_LT(glm::length(eye_view - glm::dvec4(0, 0, 0, 1)), 1e-12);
    }
}

TEST(Camera, RowsOfViewAreRightUpBack) {
    // At a yaw of 90° to the left, the camera looks along −x, so right is −z, up is y, and back is x.
    const glm::dmat4 view = view_from_world(world_from_view({1, 2, 3}, {90, 0, 0}));
    const glm::dmat4 rows = glm::transpose(view);
    EXPECT_EQ(glm::dvec3(rows[0]), glm::dvec3(0, 0, -1));
    EXPECT_EQ(glm::dvec3(rows[1]), glm::dvec3(0, 1, 0));
    EXPECT_EQ(glm::dvec3(rows[2]), glm::dvec3(1, 0, 0));
}

TEST(Camera, AnglesRotateTheDocumentedWay) {
    const glm::dvec3 up_view(0, 1, 0), forward_view(0, 0, -1);
    const glm::dvec3 pitched = glm::dmat3(rotation_from_angles({0, 30, 0})) * forward_view;
    EXPECT_NEAR(pitched.y, 0.5, 1e-15) << "positive pitch looks up";
    const glm::dvec3 rolled = glm::dmat3(rotation_from_angles({0, 0, 30})) * up_view;
    EXPECT_NEAR(rolled.x, -0.5, 1e-15) << "positive roll leans to the left";
}

TEST(Camera, RotationIsRyRxRz) {
    SCOPED_TRACE(seed);
    Random random(seed);
    for (int i = 0; i < 200; ++i) {
        const Angles a = random.angles();
        glm::dmat4 product = glm::rotate(identity, glm::radians(a.yaw_deg), {0, 1, 0});
        product = glm::rotate(product, glm::radians(a.pitch_deg), {1, 0, 0});
        product = glm::rotate(product, glm::radians(a.roll_deg), {0, 0, 1});
        EXPECT_LT(worst_difference(rotation_from_angles(a), product), 1e-14);
    }
}

TEST(Camera, LectureWorldMatrixForAHeadingIsView) {
    for (const double heading : {-170.0, -90.0, 0.0, 33.0, 180.0}) {
        const glm::dvec3 eye(3, 2, -7);
        glm::dmat4 world = glm::rotate(identity, glm::radians(-heading), {0, 1, 0});
        world = glm::translate(world, -eye);
        EXPECT_LT(worst_difference(view_from_world(world_from_view(eye, {heading, 0, 0})), world), 1e-14);
    }
}

TEST(Camera, AnglesRoundTrip) {
    SCOPED_TRACE(seed);
    Random random(seed);
    for (int i = 0; i < 500; ++i) {
        const Angles in = random.angles();
        const Angles out = angles_from_rotation(rotation_from_angles(in));
        EXPECT_NEAR(out.yaw_deg, in.yaw_deg, 1e-9);
        EXPECT_NEAR(out.pitch_deg, in.pitch_deg, 1e-9);
        EXPECT_NEAR(out.roll_deg, in.roll_deg, 1e-9);
    }
}

TEST(Camera, AtThePolesYawCarriesRoll) {
    for (const double pitch : {90.0, -90.0}) {
        const glm::dmat4 rotation = rotation_from_angles({40, pitch, 25});
        const Angles out = angles_from_rotation(rotation);
        EXPECT_EQ(out.pitch_deg, pitch);
        EXPECT_EQ(out.roll_deg, 0.0);
        EXPECT_NEAR(out.yaw_deg, pitch > 0 ? 40 - 25 : 40 + 25, 1e-9);
        EXPECT_LT(worst_difference(rotation_from_angles(out), rotation), 1e-14);
    }
}

TEST(Camera, RangeOfTheAngles) {
    EXPECT_EQ(angles_from_rotation(rotation_from_angles({-180, 0, -180})), (Angles{180, 0, 180}));
    EXPECT_EQ(angles_from_rotation(rotation_from_angles({450, 0, 0})), (Angles{90, 0, 0}));
}

TEST(Camera, QuarterTurnsAreExact) {
    const glm::dmat4 rotation = rotation_from_angles({180, 90, -90});
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) {
            EXPECT_EQ(std::abs(rotation[column][row]), std::round(std::abs(rotation[column][row])));
        }
    }
}

TEST(Camera, LooksAtTheTarget) {
    SCOPED_TRACE(seed);
    Random random(seed);
    for (int i = 0; i < 100; ++i) {
        const glm::dvec3 eye = random.vec3(10), target = random.vec3(10);
        const Angles angles = angles_looking_at(eye, target);
        const glm::dvec4 target_view = view_from_world(world_from_view(eye, angles)) * glm::dvec4(target, 1);
        EXPECT_NEAR(target_view.x, 0, 1e-12);
        EXPECT_NEAR(target_view.y, 0, 1e-12);
        EXPECT_NEAR(target_view.z, -glm::length(target - eye), 1e-12);
        EXPECT_EQ(angles.roll_deg, 0.0);
    }
    EXPECT_EQ(angles_looking_at({1, 2, 3}, {1, 2, 3}), Angles{});
    EXPECT_EQ(angles_looking_at({0, 5, 0}, {0, 0, 0}), (Angles{0, -90, 0}));
}

TEST(Camera, ModelIsTranslationRotationScale) {
    const glm::dmat4 model = world_from_model({1, 2, 3}, {90, 0, 0}, {2, 3, 4});
    EXPECT_EQ(model * glm::dvec4(1, 1, 1, 1), glm::dvec4(1 + 4, 2 + 3, 3 - 2, 1));
}

}  // namespace
}  // namespace viewing
