// The camera queries that the methods use.
#include "topics/hidden/methods/viewpoint.h"

#include <gtest/gtest.h>

#include "unit/methods/scenes.h"

namespace viewing {
namespace {

TEST(Viewpoint, EyeDistanceAndNearPlane) {
    SCOPED_TRACE(seed);
    Random random(seed);
    for (int i = 0; i < 100; ++i) {
        const glm::dvec3 eye = random.vec3(5);
        const glm::dmat4 pose = world_from_view(eye, random.angles());
        const glm::dvec3 back(pose[2]);
        for (const bool orthographic : {false, true}) {
            const Viewpoint viewpoint{view_from_world(pose),
                                      clip_from_view({.orthographic = orthographic, .near = 0.25}, 1.5)};
            const glm::dvec4 expected = orthographic ? glm::dvec4(back, 0) : glm::dvec4(eye, 1);
            EXPECT_LT(glm::length(viewpoint.eye_world() - expected), 1e-12);
            EXPECT_NEAR(viewpoint.distance(eye - 3.0 * back), 3.0, 1e-12);
            const glm::dvec4 near = viewpoint.near_plane_world();
            EXPECT_NEAR(glm::dot(near, glm::dvec4(eye - 0.25 * back, 1)), 0.0, 1e-12);
            EXPECT_NEAR(glm::dot(near, glm::dvec4(eye - 1.25 * back, 1)), 1.0, 1e-12);
        }
    }
}

}  // namespace
}  // namespace viewing
