// Cures for depth fighting: the new near distance, and the cures that are offered for a scene.
#include "topics/depth/numbers/cures.h"

#include "state/presets.h"
#include "unit/frame/frame_test.h"

namespace viewing {
namespace {

using testing::object;
using testing::scene_of;

/// Returns the cures for a box of side 2 · scale with its center at z, in front of the eye at the origin.
std::vector<Cure> cures_with_box(double near, double z, double scale = 1.0) {
    Params params;
    params.camera.position = {0.0, 0.0, 0.0};
    params.camera.yaw = params.camera.pitch = 0.0;
    params.planes.front().equation = {0.0, 0.0, 1.0, -50.0};  // behind the eye
    params.projection.near = near;
    const Scene scene = scene_of({object("box", box_mesh(), {0.0, 0.0, z}, glm::dvec3(scale))});
    return cures(params, derive(params, scene, {}), scene);
}

TEST(Cures, MoveNearToNineTenthsOfTheNearestDistance) {
    for (const double near : {0.001, 0.5, 3.6, 4.5})
        EXPECT_EQ(cures_with_box(near, -5.0).front().params.projection.near, 3.6) << near;
    EXPECT_EQ(cures_with_box(0.25, 0.0, 1e-4).front().params.projection.near, 0.25) << "the box reaches up to the eye";
}

TEST(Cures, IncludeDecalsOnlyIfThereAreAny) {
    const std::vector<Cure> without = cures_with_box(0.5, -5.0);
    ASSERT_EQ(without.size(), 4U);
    EXPECT_EQ(without.back().kind, CureKind::logarithmic);
    const LoadedState state = *load_state("fighting-decals");
    const Scene scene = *load_scene(state.params.scene, "");
    const std::vector<Cure> with = cures(state.params, derive(state.params, scene, {}), scene);
    ASSERT_EQ(with.size(), 7U);
    for (std::size_t i = 0; i < with.size(); ++i) EXPECT_EQ(with[i].kind, static_cast<CureKind>(i));
}

TEST(Cures, RestoreTheSwitchesOfAReversedBuffer) {
    Params params;
    params.depth.reversed_clear = params.depth.reversed_zero_to_one = params.depth.reversed_offset = false;
    const Scene scene = testing::box_scene();
    const DepthParams depth = cures(params, derive(params, scene, {}), scene)[2].params.depth;
    EXPECT_TRUE(depth.mapping == DepthMapping::reversed && depth.format == DepthFormat::d32f);
    EXPECT_TRUE(depth.reversed_clear && depth.reversed_zero_to_one && depth.reversed_offset);
}

}  // namespace
}  // namespace viewing
