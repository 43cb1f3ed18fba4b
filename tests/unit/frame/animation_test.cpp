// What moves by itself: at its beginning nothing has moved, and the tremor stays as small as it says.
#include "frame/animation.h"

#include "unit/frame/frame_test.h"

namespace viewing {
namespace {

TEST(Animation, BeginsAtTheParametersThemselves) {
    const Params still = testing::params_with({"camera.yaw=12"});
    EXPECT_FALSE(is_animated(still));
    EXPECT_EQ(animated(still, 3.7), still);
    const Params jiggling = testing::params_with({"camera.yaw=12", "animation.jiggle=true"});
    EXPECT_TRUE(is_animated(jiggling));
    EXPECT_EQ(animated(jiggling, 0.0), jiggling);
}

TEST(Animation, TremblesByAThousandthOfTheTargetsDistance) {
    const Params params =
        testing::params_with({"camera.position=[0,0,50]", "camera.target=[0,0,0]", "animation.jiggle=true"});
    double farthest = 0.0;
    for (double time_s = 0.0; time_s < 20.0; time_s += 0.05) {
        const Params now = animated(params, time_s);
        Params unmoved = now;
        unmoved.camera.position = params.camera.position;
        EXPECT_EQ(unmoved, params);
        farthest = std::max(farthest, glm::distance(now.camera.position, params.camera.position));
    }
    EXPECT_GT(farthest, 0.5e-3 * 50.0);
    EXPECT_LT(farthest, 1.2e-3 * 50.0);
}

}  // namespace
}  // namespace viewing
