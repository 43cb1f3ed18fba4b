// Pictures with several planes, lights and mirrors do not depend on the sign and scale of a plane's equation, the
// culling of closed objects, the choice between mirroring scene and camera, the clipping method, or the depth format.
// planes_rays_test.cpp checks the content of such pictures; planes_switches_test.cpp has the broken states.
#include "planes_room.h"
#include "render/buffer_read.h"

namespace viewing {
namespace {

using testing::object;
using testing::params_with;
using testing::pixels_beyond;
using testing::Rgb;
using testing::rgb_at;
using testing::Room;
using testing::scene_of;
using testing::worst_channel;

constexpr glm::ivec2 planes_px(96, 54);
constexpr unsigned first_room = 62000;

/// Returns a realistic room with semitransparent mirrors and shadows. It has one depth format and at most two lights,
/// because a software renderer takes a long time to compile shaders for more.
Room lived_in(unsigned number) {
    Room room = testing::room(number);
    Random random(number);
    room.params.shadow.opacity = random.number(0.3, 0.7);
    room.params.shadow.stencil_once = true;
    room.params.shadow.offset = number % 3 == 0 ? ShadowOffset::lift : ShadowOffset::polygon_offset;
    room.params.reflection.reflectance = random.number(0.2, 0.9);
    room.params.reflection.enabled = room.params.shadow.enabled = true;
    room.params.depth.format = DepthFormat::d24;
    if (room.params.lights.size() > 2) room.params.lights.resize(2);
    return room;
}

/// Counts the pixels that differ by more than `worst` levels. Edges may move by a pixel, so pixels are ignored if `b`
/// varies noticeably among the pixel and its eight neighbors.
int pixels_beyond_edges(const Image& a, const Image& b, int worst) {
    constexpr int flat = 6;
    int count = 0;
    for (int y = 1; y + 1 < a.height; ++y) {
        for (int x = 1; x + 1 < a.width; ++x) {
            int change = 0;
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx)
                    change = std::max(change, worst_channel(rgb_at(b, {x + dx, y + dy}), rgb_at(b, {x, y})));
            count += change <= flat && worst_channel(rgb_at(a, {x, y}), rgb_at(b, {x, y})) > worst;
        }
    }
    return count;
}

class Planes : public testing::GlTest {
protected:
    /// Draws each room unchanged and changed, and expects the same picture away from edges.
    template <typename Change>
    static void expect_same_off_edges(const Change& change) {
        int mirrored = 0;
        for (unsigned number = first_room; number < first_room + testing::rooms(20); ++number) {
            SCOPED_TRACE("room " + std::to_string(number));
            const Room room = lived_in(number);
            Params changed = room.params, without = room.params;
            change(changed);
            without.reflection.enabled = false;
            const Image a = draw(room.params, room.scene, planes_px), b = draw(changed, room.scene, planes_px);
            // A rasterizer may leave pinholes where it clips.
            EXPECT_LE(pixels_beyond_edges(a, b, 2) + pixels_beyond_edges(b, a, 2), 2);
            mirrored += pixels_beyond(a, draw(without, room.scene, planes_px), 8) > 150;
        }
        EXPECT_GT(mirrored, 8);
    }
};

TEST_F(Planes, EveryPlaneTimesAnyFactorGivesTheSamePicture) {
    for (unsigned number = first_room; number < first_room + testing::rooms(20); ++number) {
        const Room room = lived_in(number);
        const Image picture = draw(room.params, room.scene, planes_px);
        constexpr double all_factors[][2] = {{-1.0, -1.0}, {2.0, 2.0}, {1.0, -2.0}};  // used by the planes in turn
        for (const auto& factors : all_factors) {
            Params same = room.params;
            for (std::size_t i = 0; i < same.planes.size(); ++i) same.planes[i].equation *= factors[i % 2];
            EXPECT_EQ(draw(same, room.scene, planes_px), picture) << "room " << number << " times " << factors[0];
        }
    }
}

TEST_F(Planes, CullingBackFacesOfClosedObjectsIsInvisible) {
    for (unsigned number = first_room; number < first_room + testing::rooms(20); ++number) {
        Room room = lived_in(number);
        room.params.cull.enabled = false;
        const Image all = draw(room.params, room.scene, planes_px);
        room.params.cull.enabled = true;
        const Image culled = draw(room.params, room.scene, planes_px);
        EXPECT_EQ(pixels_beyond_edges(culled, all, 0), 0) << "room " << number;
        // Front and back meet on an outline; at equal depth the first one drawn is visible.
        EXPECT_LE(pixels_beyond(culled, all, 0), 4) << "room " << number;
    }
}

TEST_F(Planes, MirroringTheCameraEqualsMirroringTheScene) {
    expect_same_off_edges([](Params& params) {
        const bool was_scene = params.reflection.mirrored == MirroredThing::scene;
        params.reflection.mirrored = was_scene ? MirroredThing::camera : MirroredThing::scene;
    });
}

TEST_F(Planes, AnObliqueNearPlaneEqualsAClipDistance) {
    expect_same_off_edges([](Params& params) {
        const bool was_oblique = params.reflection.clip == MirrorClip::oblique;
        params.reflection.clip = was_oblique ? MirrorClip::clip_distance : MirrorClip::oblique;
    });
}

TEST_F(Planes, TheOrderOfPlanesAndLightsDoesNotMatter) {
    // Painted shadows are excluded: the last shadow covers the others, and all of them cover the image in the mirror.
    for (unsigned number = first_room; number < first_room + testing::rooms(20); ++number) {
        Room room = lived_in(number);
        if (room.params.planes.size() < 3) continue;
        room.params.shadow.style = ShadowStyle::missing_light;
        const Image picture = draw(room.params, room.scene, planes_px);
        std::reverse(room.params.planes.begin() + 1, room.params.planes.end());
        std::reverse(room.params.lights.begin() + 1, room.params.lights.end());
        const Image reversed = draw(room.params, room.scene, planes_px);
        EXPECT_LE(pixels_beyond_edges(picture, reversed, 2), 2) << "room " << number;
    }
}

/// Returns convex solids that touch neither each other nor the three patches of the test below. The patches do not meet
/// either.
Scene floating() {
    return scene_of({object("box", box_mesh(), {-1.3, 1.1, -0.2}, {0.6, 0.5, 0.7}),
                     object("ball", sphere_mesh(), {1.2, 1.0, 0.6}, glm::dvec3(0.7)),
                     object("high box", box_mesh(), {0.1, 2.6, -1.0}, {0.5, 0.3, 0.4})});
}

TEST_F(Planes, MasksOfSixteenBitDepthEqualTheStencil) {
    const Scene scene = floating();
    Random random(seed);
    int shadows = 0;
    for (int trial = 0; trial < 8; ++trial) {
        SCOPED_TRACE("trial " + std::to_string(trial));
        Params params = params_with(
            {"view.samples=0", "cull.enabled=true", "projection.near=2", "projection.far=60", "plane.extent=3",
             R"(planes=[{"equation":[0,0,1,4.5],"extent":3},{"equation":[1,0,0,5],"extent":2.5,"gloss":true}])",
             R"(lights=[{"position":[-2,5,4,0]},{"position":[3,6,1,1]}])"});
        params.camera.position = {random.number(0, 4), random.number(1.5, 5.0), random.number(6, 9)};
        const Angles angles = angles_looking_at(params.camera.position, {-1.0, 0.7, -1.0});
        params.camera.yaw = angles.yaw_deg;
        params.camera.pitch = angles.pitch_deg;
        params.shadow.style = trial % 2 == 0 ? ShadowStyle::blend : ShadowStyle::missing_light;
        params.shadow.offset = ShadowOffset::no_depth_test;
        params.shadow.own_stencil = trial % 5 != 4;
        params.reflection.bounces = 1 + trial % 3;
        params.reflection.clip = trial % 4 < 2 ? MirrorClip::clip_distance : MirrorClip::oblique;
        params.reflection.mirrored = trial % 3 == 0 ? MirroredThing::camera : MirroredThing::scene;
        for (const Shows shows : {Shows::color, Shows::stencil}) {
            params.view.shows = shows;
            params.depth.format = DepthFormat::d24;
            const Image picture = draw(params, scene, planes_px);
            params.depth.format = DepthFormat::d16;
            EXPECT_EQ(pixels_beyond(draw(params, scene, planes_px), picture, 0), 0) << static_cast<int>(shows);
            params.shadow.enabled = false;
            shadows += pixels_beyond(draw(params, scene, planes_px), picture, 8) > 50;
            params.shadow.enabled = true;
        }
    }
    EXPECT_GT(shadows, 12);
}

TEST_F(Planes, GlossIsMissingOnlyWhereTheLightIsBlocked) {
    const Scene scene = testing::scene_named("torus-and-boxes");
    for (const bool is_painted : {true, false}) {
        Params params = params_with({"view.samples=0", "reflection.enabled=false", "light.position=[-2,6,-7,1]"});
        params.shadow.style = is_painted ? ShadowStyle::blend : ShadowStyle::missing_light;
        View view;
        const Derived derived = derive_for(params, scene, planes_px);
        const Image plain = draw(plan(params, derived), scene, planes_px, renderer(), view);
        Result<BufferReader> reader = BufferReader::make(renderer().capabilities());
        ASSERT_TRUE(reader) << reader.error();
        const std::vector<StoredPixel> stored = reader->stored(view, params.depth.format, {{0, 0}, planes_px});
        params.planes.front().gloss = true;
        const Image glossy = draw(params, scene, planes_px);
        int changed_in_shadow = 0, changed_in_light = 0;
        for (int y = 0; y < planes_px.y; ++y) {
            for (int x = 0; x < planes_px.x; ++x) {
                const bool in_shadow = stored[static_cast<std::size_t>(y * planes_px.x + x)].stencil >> 4 != 0;
                (in_shadow ? changed_in_shadow : changed_in_light) += rgb_at(plain, {x, y}) != rgb_at(glossy, {x, y});
            }
        }
        EXPECT_GT(changed_in_light, 50);
        EXPECT_EQ(changed_in_shadow > 20, is_painted) << changed_in_shadow;
        EXPECT_EQ(changed_in_shadow == 0, !is_painted) << changed_in_shadow;
    }
}

}  // namespace
}  // namespace viewing
