// Animation starts from the unanimated state, the jitter stays within its amplitude, and the light stays on its
// circle.
#include "frame/animation.h"

#include "unit/frame/frame_test.h"

namespace viewing {
namespace {

/// Animates for the given time, in steps as a window does.
Params animated_after(const Params& params, double time_s) {
    Moment moment;
    for (int step = 0; step < 100; ++step) moment = advanced(moment, params, time_s / 100.0);
    return animated(params, moment);
}

TEST(Animation, StartsFromTheParameters) {
    const Params still = testing::params_with({"camera.yaw=12"});
    EXPECT_FALSE(is_animated(still));
    EXPECT_EQ(animated_after(still, 3.7), still);
    const Params jiggling = testing::params_with({"camera.yaw=12", "animation.jiggle=true"});
    EXPECT_TRUE(is_animated(jiggling));
    EXPECT_EQ(animated(jiggling, {}), jiggling);
    const Params orbiting = testing::params_with({"light.position=[1,2,3,0.25]", "animation.light_orbit=true"});
    EXPECT_TRUE(is_animated(orbiting));
    EXPECT_EQ(animated(orbiting, {}), orbiting);
}

TEST(Animation, JittersByAThousandthOfTheTargetDistance) {
    const Params params =
        testing::params_with({"camera.position=[0,0,50]", "camera.target=[0,0,0]", "animation.jiggle=true"});
    double farthest = 0.0;
    for (double time_s = 0.0; time_s < 20.0; time_s += 0.05) {
        const Params now = animated_after(params, time_s);
        Params unmoved = now;
        unmoved.camera.position = params.camera.position;
        EXPECT_EQ(unmoved, params);
        farthest = std::max(farthest, glm::distance(now.camera.position, params.camera.position));
    }
    EXPECT_GT(farthest, 0.5e-3 * 50.0);
    EXPECT_LT(farthest, 1.2e-3 * 50.0);
}

TEST(Animation, RotatesTheLightLeftAboutTheWorldY) {
    // Seen from above, with x to the right and z down the page, a quarter turn to the left takes x to −z.
    const Params quarter =
        testing::params_with({"light.position=[2,5,0,1]", "animation.light_orbit=true", "animation.light_speed=30"});
    const glm::dvec4 turned = animated_after(quarter, 3.0).lights.front().position;
    EXPECT_LT(glm::length(turned - glm::dvec4(0, 5, -2, 1)), 1e-12);
    Params backwards = quarter;
    backwards.animation.light_speed = -30.0;
    EXPECT_LT(glm::length(animated_after(backwards, 3.0).lights.front().position - glm::dvec4(0, 5, 2, 1)), 1e-12);
}

TEST(Animation, RotatesOnlyTheChosenLight) {
    const Params params = testing::params_with({"light.position=[1,2,3,1]", "lights=[{\"position\":[2,5,0,1]}]",
                                                "view.light=2", "animation.light_orbit=true"});
    const Params now = animated_after(params, 3.0);
    EXPECT_LT(glm::length(now.lights[1].position - glm::dvec4(0, 5, -2, 1)), 1e-12);
    EXPECT_EQ(now.lights[0], params.lights[0]);
}

TEST(Animation, KeepsTheLightOnItsCircle) {
    for (const char* light :
         {"light.position=[2,5,-1,1]", "light.position=[-3,4,2,0]", "light.position=[1,-2,6,0.4]"}) {
        const Params params = testing::params_with(
            {light, "animation.light_orbit=true", "animation.light_speed=-77.5", "lights=[{\"position\":[1,2,3,1]}]"});
        const glm::dvec4 start = params.lights.front().position;
        for (double time_s = 0.0; time_s < 20.0; time_s += 0.37) {
            Params now = animated_after(params, time_s);
            const glm::dvec4 moved = now.lights.front().position;
            EXPECT_EQ(moved.y, start.y);
            EXPECT_EQ(moved.w, start.w);
            EXPECT_NEAR(std::hypot(moved.x, moved.z), std::hypot(start.x, start.z), 1e-9);
            now.lights.front().position = start;
            EXPECT_EQ(now, params) << "only the light moves";
        }
        EXPECT_LT(glm::length(animated_after(params, 360.0 / 77.5).lights.front().position - start), 1e-9)
            << "a full turn";
    }
}

TEST(Animation, NewSpeedContinuesFromTheCurrentLight) {
    Params params = testing::params_with({"light.position=[2,5,0,1]", "animation.light_orbit=true"});
    const Moment moment = advanced({}, params, 50.0);
    const glm::dvec4 before = animated(params, moment).lights.front().position;
    params.animation.light_speed = 31.0;
    EXPECT_EQ(animated(params, moment).lights.front().position, before);
    params.animation.light_speed = 0.0;
    EXPECT_FALSE(is_animated(params));
    EXPECT_EQ(animated(params, advanced(moment, params, 9.0)).lights.front().position, before);
}

}  // namespace
}  // namespace viewing
