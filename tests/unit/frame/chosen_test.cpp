// The chosen plane and light: all results equal those of a state with only that plane and that light.
#include "frame/animation.h"
#include "topics/planes/numbers/derivation.h"
#include "unit/frame/frame_test.h"
#include "unit/geometry/random.h"

namespace viewing {
namespace {

struct Pair {
    Params both, only;
};

/// Returns two planes and two lights with the second ones chosen, and the same state without the first ones.
Pair pair_of(Random& random) {
    Pair made;
    Params& only = made.only;
    only.follow = Follow{"box", 3};
    only.planes[0] = {.equation = {random.direction() * random.number(0.5, 2.0), random.number(-2, 2)},
                      .extent = random.number(1, 6)};
    only.lights[0].position = {random.vec3(6), random.number(0, 1) < 0.3 ? 0.0 : 1.0};
    made.both = only;
    made.both.planes.insert(made.both.planes.begin(), {.equation = {random.direction(), random.number(-2, 2)}});
    made.both.lights.insert(made.both.lights.begin(), {{random.vec3(6), 1.0}});
    made.both.view.plane = made.both.view.light = 2;
    return made;
}

void expect_same_told(const Params& both, const Params& only) {
    const Scene scene = testing::box_scene();
    const Viewport viewport{{400, 300}};
    const Derived of_both = derive(both, scene, viewport), of_only = derive(only, scene, viewport);
    const CastShadow &cast = of_both.chosen_shadow(), &only_cast = of_only.planes[0].shadows[0];
    EXPECT_EQ(of_both.chosen_light(), of_only.lights_world[0]);
    EXPECT_EQ(cast.shadowed_world_from_world, only_cast.shadowed_world_from_world);
    EXPECT_EQ(cast.sign, only_cast.sign);
    EXPECT_EQ(cast.by_hand, only_cast.by_hand);
    EXPECT_EQ(of_both.chosen_plane().mirrored_world_from_world, of_only.planes[0].mirrored_world_from_world);
    EXPECT_EQ(of_both.chosen_plane().mirror_by_hand, of_only.planes[0].mirror_by_hand);

    ASSERT_TRUE(of_both.followed && of_only.followed);
    EXPECT_EQ(of_both.followed->shadow_homogeneous, of_only.followed->shadow_homogeneous);
    EXPECT_EQ(of_both.followed->shadow_world, of_only.followed->shadow_world);
    EXPECT_EQ(of_both.followed->foot_world, of_only.followed->foot_world);
    EXPECT_EQ(of_both.followed->plane_distance, of_only.followed->plane_distance);
    EXPECT_EQ(of_both.followed->mirrored_world, of_only.followed->mirrored_world);

    const ObserverView light = derive_light_view(of_both, scene, viewport),
                       only_light = derive_light_view(of_only, scene, viewport);
    EXPECT_EQ(light.view_from_world, only_light.view_from_world);
    EXPECT_EQ(light.clip_from_world, only_light.clip_from_world);

    const FramePlan plan_both = plan(both, of_both), plan_only = plan(only, of_only);
    EXPECT_EQ(plan_both.caster_w, plan_only.caster_w);
    EXPECT_EQ(plan_both.caster_side, plan_only.caster_side);
}

TEST(Chosen, SecondOnesBehaveAsIfAlone) {
    Random random(seed);
    for (int trial = 0; trial < 50; ++trial) {
        SCOPED_TRACE("seed " + std::to_string(seed) + " trial " + std::to_string(trial));
        const Pair pair = pair_of(random);
        expect_same_told(pair.both, pair.only);
    }
}

TEST(Chosen, DerivedPointIsAboveTheChosenPlane) {
    Random random(seed);
    Pair pair = pair_of(random);
    pair.both.follow.reset();
    pair.only.follow.reset();
    const Scene scene = testing::box_scene();
    EXPECT_EQ(derivation_point(derive(pair.both, scene, {})), derivation_point(derive(pair.only, scene, {})));
}

TEST(Chosen, ManualMatricesBelongToTheirPlaneAndLight) {
    Random random(seed);
    Pair pair = pair_of(random);
    const glm::dmat4 shadow(2.0), mirror(3.0);
    pair.only.overrides[0].shadowed_world_from_world[0] = shadow;
    pair.only.overrides[0].mirrored_world_from_world = mirror;
    pair.both.overrides[1].shadowed_world_from_world[1] = shadow;
    pair.both.overrides[1].mirrored_world_from_world = mirror;
    expect_same_told(pair.both, pair.only);
    const Derived derived = derive(pair.both, testing::box_scene(), {});
    EXPECT_FALSE(derived.planes[0].mirror_by_hand);
    for (const auto& [plane, light] : {std::pair(0, 0), std::pair(0, 1), std::pair(1, 0)})
        EXPECT_FALSE(derived.planes[static_cast<std::size_t>(plane)].shadows[static_cast<std::size_t>(light)].by_hand);
}

TEST(Chosen, ManualMatricesComeFromTheFilesAdditionalOverrides) {
    const std::string matrix = "[[1,2,3,4],[5,6,7,8],[9,10,11,12],[0,0,0,1]]";
    const Params params =
        testing::params_with({"planes=[{}]", "lights=[{}]",
                              "overrides.further=[{\"plane\":2,\"light\":2,\"shadow_from_world\":" + matrix + "}]",
                              "overrides.further[1]={\"plane\":2,\"mirror_from_world\":" + matrix + "}"});
    const Derived derived = derive(params, testing::box_scene(), {});
    EXPECT_EQ(derived.planes[1].shadows[1].shadowed_world_from_world[3][0], 4.0);  // row 0, column 3
    EXPECT_EQ(derived.planes[1].mirrored_world_from_world[0][1], 5.0);
    EXPECT_FALSE(derived.planes[1].shadows[0].by_hand);
}

}  // namespace
}  // namespace viewing
