// The depth picture's contrast range spans the nearest to the farthest corner of the scene. The expected ranges are
// computed by hand for a camera that looks along −z.
#include "frame/plan/plan.h"
#include "unit/frame/frame_test.h"

namespace viewing::testing {
namespace {

glm::dvec2 range_of(const std::vector<std::string>& settings, const Scene& scene) {
    std::vector<std::string> all{"camera.yaw=0",      "camera.pitch=0",    "camera.roll=0", "camera.position=[0,1,10]",
                                 "projection.near=1", "projection.far=100"};
    all.insert(all.end(), settings.begin(), settings.end());
    const Params params = params_with(all);
    return contrast_range(params, derive(params, scene, {}), scene);
}

TEST(ContrastRange, SpansPatchAndObjects) {
    // The box reaches from z = −1 to 1, and the ground patch from −plane.extent to plane.extent.
    EXPECT_EQ(range_of({"plane.extent=4"}, box_scene()), glm::dvec2(6.0, 14.0));
    EXPECT_EQ(range_of({"plane.extent=0.5"}, box_scene()), glm::dvec2(9.0, 11.0));
    EXPECT_EQ(range_of({"plane.extent=4"}, Scene{}), glm::dvec2(6.0, 14.0)) << "only the patch";
    EXPECT_EQ(range_of({"plane.extent=0.5", "camera.position=[0,1,30]"}, box_scene()), glm::dvec2(29.0, 31.0));
}

TEST(ContrastRange, StaysBetweenNearAndFar) {
    EXPECT_EQ(range_of({"plane.extent=4", "projection.near=8"}, box_scene()), glm::dvec2(8.0, 14.0));
    EXPECT_EQ(range_of({"plane.extent=4", "projection.far=12"}, box_scene()), glm::dvec2(6.0, 12.0));
    EXPECT_EQ(range_of({"plane.extent=4", "camera.position=[0,1,-50]"}, box_scene()), glm::dvec2(1.0, 100.0))
        << "the scene is behind the eye";
}

TEST(ContrastRange, UsesTheRequestedRange) {
    EXPECT_EQ(range_of({"view.depth_range=[3,5]"}, box_scene()), glm::dvec2(3.0, 5.0));
    EXPECT_EQ(range_of({"view.depth_range=[0.5,200]"}, box_scene()), glm::dvec2(1.0, 100.0));
}

}  // namespace
}  // namespace viewing::testing
