// The parameters of each way of mirroring.
#include "topics/planes/numbers/mirror_ways.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace viewing {
namespace {

TEST(MirrorWay, ChangesOnlyHowTheImageIsMade) {
    struct Expected {
        MirrorWay way;
        MirrorClip clip;
        MirroredThing mirrored;
    };
    Params odd;
    odd.reflection.clip = MirrorClip::oblique;
    odd.reflection.mirrored = MirroredThing::camera;
    odd.reflection.reflectance = 0.7;
    odd.reflection.same_projection = false;
    odd.reflection.enabled = false;
    odd.lights.front().position.x = 3.5;
    for (const Expected& expected :
         {Expected{MirrorWay::clip_distance, MirrorClip::clip_distance, MirroredThing::scene},
          Expected{MirrorWay::none, MirrorClip::none, MirroredThing::scene},
          Expected{MirrorWay::oblique, MirrorClip::oblique, MirroredThing::scene},
          Expected{MirrorWay::camera, MirrorClip::clip_distance, MirroredThing::camera}}) {
        for (const Params& before : {Params{}, odd}) {
            Params wanted = before;
            wanted.reflection.clip = expected.clip;
            wanted.reflection.mirrored = expected.mirrored;
            EXPECT_EQ(mirrored_in(before, expected.way), wanted) << name_of(expected.way);
        }
    }
    EXPECT_EQ(mirrored_in(Params{}, MirrorWay::clip_distance), Params{}) << "the correct default";
}

TEST(MirrorWay, HasAName) {
    EXPECT_STREQ(name_of(MirrorWay::clip_distance), "clip distance");
    EXPECT_STREQ(name_of(MirrorWay::none), "no clipping");
    EXPECT_STREQ(name_of(MirrorWay::oblique), "oblique near plane");
    EXPECT_STREQ(name_of(MirrorWay::camera), "mirrored camera");
    std::set<std::string> names;
    for (std::size_t way = 0; way < mirror_way_count; ++way) names.insert(name_of(static_cast<MirrorWay>(way)));
    EXPECT_EQ(names.size(), mirror_way_count);
}

}  // namespace
}  // namespace viewing
