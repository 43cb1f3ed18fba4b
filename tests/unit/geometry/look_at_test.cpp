// Eye, center and up: the round trip, the comparison with glm::lookAt, and the two degenerate cases.
#include "geometry/look_at.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "unit/geometry/random.h"

namespace viewing {
namespace {

glm::dmat4 view_of(const LookAt& at) {
    return view_from_world(world_from_view(at.eye, camera_looking_at(at).angles));
}

TEST(LookAt, CamerasGoThereAndBack) {
    SCOPED_TRACE(seed);
    Random random(seed);
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 eye = random.vec3(100);
        Angles angles = random.angles();
        if (i % 3 == 0) angles.roll_deg = 0.0;
        if (i % 10 == 0) angles.pitch_deg = i % 20 == 0 ? 89.99 : -89.99;
        const double distance = random.number(0.1, 50);
        const LookAt at = look_at_of(eye, angles, distance);
        const Looking back = camera_looking_at(at);
        ASSERT_EQ(back.fault, LookAtFault::none);
        EXPECT_LT(worst_difference(rotation_from_angles(back.angles), rotation_from_angles(angles)), 1e-9);
        const bool near_pole = std::abs(angles.pitch_deg) > 89.0;  // yaw and roll are less certain than their sum
        EXPECT_NEAR(back.angles.pitch_deg, angles.pitch_deg, 1e-9);
        EXPECT_NEAR(std::remainder(back.angles.yaw_deg - angles.yaw_deg, 360), 0, near_pole ? 1e-6 : 1e-9);
        EXPECT_NEAR(std::remainder(back.angles.roll_deg - angles.roll_deg, 360), 0, near_pole ? 1e-6 : 1e-9);
        EXPECT_NEAR(glm::distance(at.eye, at.center), distance, 1e-12 * (100 + distance));
    }
}

TEST(LookAt, IsTheViewMatrixOfGlm) {
    SCOPED_TRACE(seed);
    Random random(seed);
    for (int i = 0; i < 1000; ++i) {
        const LookAt at{random.vec3(100), random.vec3(100), 7.0 * random.direction()};
        EXPECT_LT(worst_difference(view_of(at), glm::lookAtRH(at.eye, at.center, at.up)), 1e-9);
        const LookAt again = look_at_of(at.eye, camera_looking_at(at).angles, glm::distance(at.eye, at.center));
        EXPECT_LT(glm::distance(again.center, at.center), 1e-9);
    }
}

TEST(LookAt, CamerasOfBooks) {
    const LookAt tiny{{1, 1, 3}, {0, 0, 0}, {0, 1, 0}};  // tinyrenderer's camera
    EXPECT_LT(worst_difference(view_of(tiny), glm::lookAtRH(tiny.eye, tiny.center, tiny.up)), 1e-12);
    EXPECT_NEAR(camera_looking_at(tiny).angles.roll_deg, 0.0, 1e-12);
    EXPECT_EQ(look_at_of(tiny.eye, camera_looking_at(tiny).angles, 1.0).up.x, 0.0);

    const LookAt down{{100, 30, 100}, {100, 0, 100}, {0, 0, -1}};
    EXPECT_EQ(camera_looking_at(down).angles, (Angles{0, -90, 0}));
    const LookAt again = look_at_of(down.eye, {25, -90, 0}, 30.0);
    EXPECT_LT(glm::distance(again.center, down.center), 1e-12);
    EXPECT_NEAR(camera_looking_at(again).angles.yaw_deg, 25.0, 1e-9);
}

TEST(LookAt, DegenerateOnesDefineACamera) {
    const Looking nowhere = camera_looking_at({{1, 2, 3}, {1, 2, 3}, {0, 1, 0}});
    EXPECT_EQ(nowhere.fault, LookAtFault::center_is_eye);
    EXPECT_EQ(nowhere.angles, Angles{});
    for (const glm::dvec3 up : {glm::dvec3(0, 1, 0), glm::dvec3(0, -2, 0), glm::dvec3(0)}) {
        const Looking down = camera_looking_at({{0, 5, 0}, {0, 0, 0}, up});
        EXPECT_EQ(down.fault, LookAtFault::up_along_view);
        EXPECT_EQ(down.angles, (Angles{0, -90, 0}));
    }
}

}  // namespace
}  // namespace viewing
