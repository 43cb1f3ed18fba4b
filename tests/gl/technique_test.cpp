// The visual effect of the passes: each switch of shadow, mirror, depth test and culling, on scenes small enough to
// predict the color of a pixel. ray_caster_test.cpp compares whole pictures.
#include <cmath>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>

#include "frame/ground.h"
#include "gl_test.h"
#include "unit/geometry/random.h"

namespace viewing {
namespace {

using testing::box_scene;
using testing::object;
using testing::params_with;
using testing::pixel_of;
using testing::pixels_beyond;
using testing::Rgb;
using testing::rgb_at;
using testing::scene_named;
using testing::scene_of;
using testing::worst_channel;

constexpr glm::ivec2 technique_px(160, 120);

class Technique : public testing::GlTest {
protected:
    static Rgb color_at(const std::vector<std::string>& settings, const Scene& scene, const glm::dvec3& point) {
        const Params params = params_with(settings);
        return rgb_at(draw(params, scene, technique_px),
                      pixel_of(point, derive_for(params, scene, technique_px), technique_px));
    }
};

/// Returns settings for a view from above at an angle, without multisampling or reflection, followed by `more`.
std::vector<std::string> plain(std::vector<std::string> more) {
    std::vector<std::string> all = {"view.samples=0", "reflection.enabled=false", "camera.position=[0,6,8]",
                                    "camera.yaw=0",   "camera.pitch=-36.87",      "light.position=[4,8,0,1]"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

/// The box spans ±1 and rests on the ground; its shadow extends from x = −1 to shadow_end().
const glm::dvec3 in_shadow(-1.6, 0.0, 0.3);
const glm::dvec3 in_light(2.6, 0.0, 0.3);

glm::dvec3 shadow_end() {
    // From (4, 8) past the box's far top edge (−1, 2) down to the ground.
    return {4.0 + (-1.0 - 4.0) * 8.0 / (8.0 - 2.0), 0.0, 0.0};
}

TEST_F(Technique, CoincidentLightsAreAsBrightAsOne) {
    Params params = params_with(plain({"shadow.enabled=false"}));
    const Image one = draw(params, box_scene(), technique_px);
    while (params.lights.size() < most_lights) {
        params.lights.push_back(params.lights.front());
        EXPECT_EQ(pixels_beyond(draw(params, box_scene(), technique_px), one, 1), 0)
            << params.lights.size() << " lights";
    }
}

TEST_F(Technique, ShadowDarkensOnceWithTheStencilAndTwiceWithoutIt) {
    const Rgb lit = color_at(plain({"shadow.enabled=false"}), box_scene(), in_shadow);
    const Rgb once = color_at(plain({}), box_scene(), in_shadow);
    const Rgb twice = color_at(plain({"shadow.stencil_once=false"}), box_scene(), in_shadow);
    for (int channel = 0; channel < 3; ++channel) {
        EXPECT_GT(lit[channel], 40);
        EXPECT_NEAR(once[channel], lit[channel] * 0.5, 1.5);
        EXPECT_NEAR(twice[channel], lit[channel] * 0.25, 1.5);  // lit and unlit faces each darken by half
    }
    EXPECT_EQ(color_at(plain({"shadow.enabled=false"}), box_scene(), in_light),
              color_at(plain({}), box_scene(), in_light));
}

/// Returns the kind of caster_colors to which a shaded color belongs, judged by its proportions of red, green and blue.
std::size_t caster_kind(const Rgb& shaded) {
    const auto shares = [](const glm::dvec3& color) { return color / (color.r + color.g + color.b); };
    std::size_t nearest = 0;
    double least = 1e9;
    for (std::size_t kind = 0; kind < caster_colors.size(); ++kind) {
        const Color& color = caster_colors[kind];
        const double apart = glm::distance(shares(glm::dvec3(color.r, color.g, color.b)), shares(glm::dvec3(shaded)));
        if (apart < least) nearest = kind;
        least = std::min(least, apart);
    }
    return nearest;
}

TEST_F(Technique, CastersAreColoredByTheirSideOfPlaneAndLight) {
    constexpr std::size_t casts = 0, behind_plane = 1, beyond_light = 2;
    // A pillar from y = -2 to 4 with its front at z = 0.5, and a ground that is not at the origin.
    const Scene scene = scene_of({object("pillar", box_mesh(), {0, 1, 0}, {0.5, 3, 0.5})});
    const auto kind_at = [&](const std::string& light, double y) {
        return caster_kind(
            color_at({"view.samples=0", "reflection.enabled=false", "shadow.enabled=false", "camera.position=[0,1,12]",
                      "camera.yaw=0", "camera.pitch=0", "plane.equation=[0,1,0,-0.5]", "view.shows=shadow_w", light},
                     scene, {0, y, 0.5}));
    };
    const std::string lamp = "light.position=[4,2,0,1]", sun = "light.position=[4,2,0,0]",
                      below = "light.position=[4,-1,0,1]";
    EXPECT_EQ(kind_at(lamp, -1.0), behind_plane);
    EXPECT_EQ(kind_at(lamp, 1.0), casts);
    EXPECT_EQ(kind_at(lamp, 3.0), beyond_light);
    EXPECT_EQ(kind_at(sun, -1.0), behind_plane);
    EXPECT_EQ(kind_at(sun, 3.0), casts) << "nothing is beyond a directional light";
    EXPECT_EQ(kind_at(below, -0.25), casts) << "the light is on the other side";
    EXPECT_EQ(kind_at(below, -1.5), beyond_light);
    EXPECT_EQ(kind_at(below, 1.5), behind_plane);
}

TEST_F(Technique, ShadowEndsWhereTheFormulaPredicts) {
    EXPECT_NEAR(shadow_end().x, -8.0 / 3.0, 1e-12);
    const Rgb lit = color_at(plain({"shadow.enabled=false"}), box_scene(), {-2.5, 0, 0.3});
    EXPECT_LT(color_at(plain({}), box_scene(), {-2.5, 0, 0.3}).g, lit.g - 20);
    const glm::dvec3 beyond(-2.85, 0, 0.3);
    EXPECT_EQ(color_at(plain({}), box_scene(), beyond), color_at(plain({"shadow.enabled=false"}), box_scene(), beyond));
}

TEST_F(Technique, ShadowHasItsColorAndOpacity) {
    EXPECT_LE(worst_channel(color_at(plain({"shadow.color=#c0ffee", "shadow.opacity=1"}), box_scene(), in_shadow),
                            {0xc0, 0xff, 0xee}),
              1);
    EXPECT_EQ(color_at(plain({"shadow.opacity=0"}), box_scene(), in_shadow),
              color_at(plain({"shadow.enabled=false"}), box_scene(), in_shadow));
}

TEST_F(Technique, ShadowStaysOnItsReceiverOnlyWhileClipped) {
    const Rgb background{0x1b, 0x1f, 0x27};
    const auto beside_the_patch = [&](const std::vector<std::string>& more) {
        std::vector<std::string> settings = {"plane.extent=1.2"};
        settings.insert(settings.end(), more.begin(), more.end());
        return color_at(plain(settings), box_scene(), in_shadow);
    };
    EXPECT_EQ(beside_the_patch({}), background);
    EXPECT_EQ(beside_the_patch({"shadow.stencil_once=false"}), background);
    const Rgb once = beside_the_patch({"shadow.clip_to_receiver=false"});
    const Rgb twice = beside_the_patch({"shadow.clip_to_receiver=false", "shadow.stencil_once=false"});
    for (int channel = 0; channel < 3; ++channel) {
        EXPECT_NEAR(once[channel], background[channel] * 0.5, 1.0);
        EXPECT_NEAR(twice[channel], background[channel] * 0.25, 1.0);
    }
}

TEST_F(Technique, ObjectsBehindTheReceiverCastFalseShadows) {
    const Scene below = scene_of({object("below", box_mesh(), {0, -3, 0})});
    // Seen from the light, (0, −2, 0) is behind the point where the ray to it pierces the ground: (4, 8) + t (−4, −10).
    const glm::dvec3 pierced(4.0 - 4.0 * 0.8, 0.0, 0.0);
    const Rgb lit = color_at(plain({"shadow.enabled=false"}), below, pierced);
    EXPECT_EQ(color_at(plain({}), below, pierced), lit);
    EXPECT_LT(color_at(plain({"shadow.clip_casters=false"}), below, pierced).g, lit.g - 20);
}

TEST_F(Technique, NothingBeyondTheLightCastsAShadow) {
    const Scene above = scene_of({object("above", box_mesh(), {0, 12, 0})});
    const Image without = draw(params_with(plain({"shadow.enabled=false"})), above, technique_px);
    EXPECT_EQ(draw(params_with(plain({})), above, technique_px), without);
    EXPECT_EQ(draw(params_with(plain({"shadow.clip_casters=false"})), above, technique_px), without);
    const Image parallel = draw(params_with(plain({"light.position=[0,1,0,0]"})), above, technique_px);
    EXPECT_GT(
        pixels_beyond(
            parallel,
            draw(params_with(plain({"light.position=[0,1,0,0]", "shadow.enabled=false"})), above, technique_px), 20),
        100);
}

/// The sign is forced for each vertex: a vertex beyond the light is negated, and one in front of the light is
/// unchanged.
TEST_F(Technique, ForcedSignCastsAnAntiShadowThroughTheLight) {
    const std::vector<std::string> forced = plain({"shadow.sign=forced", "shadow.clip_at_light=false"});
    const Scene above = scene_of({object("above", box_mesh(), {5, 12, 0})});
    // From (5, 12) through the light at (4, 8) down to the ground, which is twice as far below the light as (5, 12) is
    // above it.
    const glm::dvec3 through_the_light(4.0 + 2.0 * (4.0 - 5.0), 0.0, 0.3);
    const Rgb lit = color_at(plain({}), above, through_the_light);
    const Rgb dark = color_at(forced, above, through_the_light);
    for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(dark[channel], lit[channel] * 0.5, 1.5);
    EXPECT_EQ(color_at(forced, box_scene(), in_shadow), color_at(plain({}), box_scene(), in_shadow));
}

TEST_F(Technique, EveryOffsetThatFixesFightingGivesTheSameShadow) {
    const Params offset = params_with(plain({}));
    const Image expected = draw(offset, box_scene(), technique_px);
    for (const char* const way : {"shadow.offset=no_depth_test", "shadow.offset=lift"}) {
        for (const char* const mapping :
             {"depth.mapping=standard", "depth.mapping=reversed", "depth.mapping=logarithmic"}) {
            const Image other =
                draw(params_with(plain({way, mapping, "shadow.lift=0.001"})), box_scene(), technique_px);
            EXPECT_LE(pixels_beyond(expected, other, 3), 20) << way << " " << mapping;
        }
    }
    // Without an offset, depths are equal up to rounding, and "less" leaves out parts of the shadow.
    EXPECT_GT(pixels_beyond(expected, draw(params_with(plain({"shadow.offset=none"})), box_scene(), technique_px), 3),
              100);
    // The offset suffices in every format; only the shadow's edge differs.
    for (const char* const format : {"depth.format=d16", "depth.format=d32f", "depth.format=d12"})
        for (const char* const mapping :
             {"depth.mapping=standard", "depth.mapping=reversed", "depth.mapping=logarithmic"})
            EXPECT_LE(
                pixels_beyond(expected, draw(params_with(plain({format, mapping})), box_scene(), technique_px), 3), 60)
                << format << " " << mapping;
}

TEST_F(Technique, MissingLightLeavesTheAmbientPart) {
    const Rgb lit = color_at(plain({"shadow.enabled=false"}), box_scene(), in_shadow);
    const Rgb missing = color_at(plain({"shadow.style=missing_light"}), box_scene(), in_shadow);
    // When the light is below the patch, the patch receives only ambient light.
    const Rgb ambient = color_at(plain({"light.position=[4,-8,0,1]"}), box_scene(), in_shadow);
    EXPECT_LE(worst_channel(missing, ambient), 1);
    EXPECT_LT(missing.g, lit.g - 20);
    EXPECT_EQ(color_at(plain({"shadow.style=missing_light"}), box_scene(), in_light),
              color_at(plain({"shadow.enabled=false"}), box_scene(), in_light));
    const Rgb through_mirror =
        color_at(plain({"shadow.style=missing_light", "reflection.enabled=true"}), box_scene(), in_shadow);
    EXPECT_LT(through_mirror.g, lit.g - 10);
}

TEST_F(Technique, CullingDoesNotChangeTheShadows) {
    for (const char* const face : {"cull.face=front", "cull.face=back", "cull.face=front_and_back"}) {
        for (const char* const winding : {"cull.front_face=ccw", "cull.front_face=cw"}) {
            EXPECT_EQ(color_at(plain({"cull.enabled=true", face, winding}), box_scene(), in_shadow),
                      color_at(plain({}), box_scene(), in_shadow));
        }
    }
}

TEST_F(Technique, CullingBackFacesOfClosedObjectsIsInvisible) {
    Random random(seed);
    for (const char* const name : {"torus-and-boxes", "curved"}) {
        const Scene scene = scene_named(name);
        for (int trial = 0; trial < 8; ++trial) {
            SCOPED_TRACE(std::string(name) + " seed " + std::to_string(seed) + " trial " + std::to_string(trial));
            Params params = params_with({"view.samples=0", "reflection.reflectance=0.6"});
            const glm::dvec3 towards = random.direction();
            params.camera.position =
                glm::dvec3(0, 0.8, 0) + 6.5 * glm::dvec3(towards.x, std::abs(towards.y), towards.z);
            const Angles angles = angles_looking_at(params.camera.position, {0, 0.8, 0});
            params.camera.yaw = angles.yaw_deg;
            params.camera.pitch = angles.pitch_deg;
            Params culled = params;
            culled.cull.enabled = true;
            const Image all = draw(params, scene, technique_px);
            // On an outline, both faces may cover a pixel with depths that round to the same code.
            EXPECT_LE(pixels_beyond(all, draw(culled, scene, technique_px), 0), 4);
            culled.cull.face = CullFace::front;
            EXPECT_GT(pixels_beyond(all, draw(culled, scene, technique_px), 3), 200);
        }
    }
}

TEST_F(Technique, PlaneTimesAnyFactorGivesTheSamePicture) {
    Random random(seed);
    const Scene scene = scene_named("torus-and-boxes");
    int pictures_with_shadow = 0;
    for (int trial = 0; trial < 30; ++trial) {
        SCOPED_TRACE("seed " + std::to_string(seed) + " trial " + std::to_string(trial));
        Params params;
        params.view.samples = 0;
        params.planes.front().equation = {random.direction(), random.number(-1.0, 1.0)};
        params.lights.front().position = {random.vec3(5), trial % 3 == 0 ? 0.0 : 1.0};
        params.camera.position = 7.0 * random.direction();
        const Angles angles = angles_looking_at(params.camera.position, {0, 0.5, 0});
        params.camera.yaw = angles.yaw_deg;
        params.camera.pitch = angles.pitch_deg;
        params.camera.roll = random.number(-180, 180);
        params.reflection.clip = trial % 2 == 0 ? MirrorClip::clip_distance : MirrorClip::oblique;
        params.shadow.offset = trial % 5 == 0 ? ShadowOffset::lift : ShadowOffset::polygon_offset;
        params.reflection.reflectance = random.number(0.1, 1.0);
        const Image picture = draw(params, scene, technique_px);
        for (const double factor : {-1.0, 2.0}) {
            Params same = params;
            same.planes.front().equation *= factor;
            EXPECT_EQ(draw(same, scene, technique_px), picture) << "times " << factor;
        }
        Params without = params;
        without.shadow.enabled = false;
        pictures_with_shadow += pixels_beyond(picture, draw(without, scene, technique_px), 3) > 50 ? 1 : 0;
    }
    EXPECT_GE(pictures_with_shadow, 8);
}

/// Returns a square that faces a camera at the origin.
SceneObject facing_quad(const std::string& name, double distance, const Color& color) {
    SceneObject made = object(name, quad_mesh(), {0, 0, -distance});
    made.description.color = color;
    made.world_from_model = world_from_model({0, 0, -distance}, {0, 90, 0}, glm::dvec3(0.1 * distance));
    return made;
}

/// Returns settings with the camera at the origin and the plane out of sight, followed by `more`.
std::vector<std::string> from_origin(std::vector<std::string> more) {
    std::vector<std::string> all = {"view.samples=0",
                                    "reflection.enabled=false",
                                    "shadow.enabled=false",
                                    "camera.position=[0,0,0]",
                                    "camera.yaw=0",
                                    "camera.pitch=0",
                                    "plane.equation=[0,1,0,1000]",
                                    "plane.extent=0.001",
                                    "light.position=[0,0,1,0]"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

enum class Seen { background, near_quad, far_quad };

Seen seen(const Image& image) {
    const Rgb center = rgb_at(image, technique_px / 2);
    if (center == Rgb(0x1b, 0x1f, 0x27)) return Seen::background;
    return center.r > center.b ? Seen::near_quad : Seen::far_quad;
}

TEST_F(Technique, EveryDepthFunctionInBothOrders) {
    struct Case {
        const char* func;
        Seen near_first, far_first;
    };
    const SceneObject near_quad = facing_quad("near", 3, {255, 0, 0}), far_quad = facing_quad("far", 6, {0, 0, 255});
    const Scene near_first = scene_of({near_quad, far_quad}), far_first = scene_of({far_quad, near_quad});
    for (const char* const mapping :
         {"depth.mapping=standard", "depth.mapping=reversed", "depth.mapping=logarithmic"}) {
        for (const Case& each : {Case{"never", Seen::background, Seen::background},
                                 {"less", Seen::near_quad, Seen::near_quad},
                                 {"equal", Seen::background, Seen::background},
                                 {"lequal", Seen::near_quad, Seen::near_quad},
                                 {"greater", Seen::background, Seen::background},
                                 {"notequal", Seen::far_quad, Seen::near_quad},
                                 {"gequal", Seen::background, Seen::background},
                                 {"always", Seen::far_quad, Seen::near_quad}}) {
            SCOPED_TRACE(std::string(mapping) + " " + each.func);
            const Params params = params_with(from_origin({mapping, std::string("depth.func=") + each.func}));
            EXPECT_EQ(seen(draw(params, near_first, technique_px)), each.near_first);
            EXPECT_EQ(seen(draw(params, far_first, technique_px)), each.far_first);
        }
        for (const char* const last_wins : {"depth.test=false", "depth.write=false", "visibility.method=none"}) {
            SCOPED_TRACE(std::string(mapping) + " " + last_wins);
            const Params params = params_with(from_origin({mapping, last_wins}));
            EXPECT_EQ(seen(draw(params, near_first, technique_px)), Seen::far_quad);
            EXPECT_EQ(seen(draw(params, far_first, technique_px)), Seen::near_quad);
        }
    }
}

TEST_F(Technique, UnclearedDepthHidesLaterObjects) {
    const Scene near_only = scene_of({facing_quad("near", 3, {255, 0, 0})});
    const Scene far_only = scene_of({facing_quad("far", 6, {0, 0, 255})});
    for (const char* const mapping : {"depth.mapping=standard", "depth.mapping=reversed"}) {
        for (const bool clears : {true, false}) {
            SCOPED_TRACE(std::string(mapping) + (clears ? " cleared" : " not cleared"));
            const Params params =
                params_with(from_origin({mapping, clears ? "depth.clear=true" : "depth.clear=false"}));
            const FramePlan frame = plan(params, derive_for(params, near_only, technique_px));
            View view;
            // A view's first frame has no predecessor, and nothing undefined may appear in it.
            draw(frame, near_only, technique_px, renderer(), view);
            const Seen later = seen(draw(frame, far_only, technique_px, renderer(), view));
            EXPECT_EQ(later, clears ? Seen::far_quad : Seen::background);
            View fresh;
            const Seen first = seen(draw(frame, far_only, technique_px, renderer(), fresh));
            EXPECT_EQ(first,
                      clears ? Seen::far_quad : Seen::background);  // drawn twice; the second time, GL_LESS fails
        }
    }
}

TEST_F(Technique, OnlyDecalsAreOffset) {
    SceneObject decal = facing_quad("decal", 3, {255, 0, 0});
    const SceneObject wall = facing_quad("wall", 3, {0, 0, 255});
    for (const char* const mapping :
         {"depth.mapping=standard", "depth.mapping=reversed", "depth.mapping=logarithmic"}) {
        const Params towards = params_with(from_origin({mapping, "depth.offset.units=-4", "depth.offset.factor=-1"}));
        const Params away = params_with(from_origin({mapping, "depth.offset.units=4", "depth.func=lequal"}));
        EXPECT_EQ(seen(draw(towards, scene_of({wall, decal}), technique_px)), Seen::far_quad)
            << "not marked: no offset";
        decal.description.decal = true;
        EXPECT_EQ(seen(draw(towards, scene_of({wall, decal}), technique_px)), Seen::near_quad) << mapping;
        EXPECT_EQ(seen(draw(away, scene_of({wall, decal}), technique_px)), Seen::far_quad) << mapping;
        decal.description.decal = false;
    }
}

TEST_F(Technique, FacingDistinguishesFrontFromBack) {
    const Scene ball = scene_of({object("ball", sphere_mesh(), {0, 0, -5})});
    const auto center = [&](const std::vector<std::string>& more) {
        std::vector<std::string> settings = {"view.shows=facing"};
        settings.insert(settings.end(), more.begin(), more.end());
        return rgb_at(draw(params_with(from_origin(settings)), ball, technique_px), technique_px / 2);
    };
    const Rgb front = center({}), back = center({"cull.enabled=true", "cull.face=front"});
    EXPECT_GT(front.b, front.r + 40);  // blue
    EXPECT_GT(back.r, back.b + 40);    // ochre
    EXPECT_GT(center({"cull.front_face=cw"}).r, center({"cull.front_face=cw"}).b + 40);
    EXPECT_EQ(center({"cull.enabled=true", "cull.face=front_and_back"}), Rgb(0x1b, 0x1f, 0x27));
}

TEST_F(Technique, FacingInTheMirrorNeedsTheFlippedWinding) {
    const auto mirrored = [&](const std::vector<std::string>& more) {
        std::vector<std::string> settings = {"reflection.enabled=true", "reflection.reflectance=1",
                                             "shadow.enabled=false", "view.shows=facing"};
        settings.insert(settings.end(), more.begin(), more.end());
        // A point in the mirror image of the box's front side, near its foot: (0, −0.5, 1).
        return color_at(plain(settings), box_scene(), {0.0, -0.5, 1.0});
    };
    EXPECT_GT(mirrored({}).b, mirrored({}).r + 30);
    EXPECT_GT(mirrored({"reflection.flip_winding=false"}).r, mirrored({"reflection.flip_winding=false"}).b + 30);
    // With culling, the flip decides whether the outside of the near walls or the inside of the far walls is visible.
    const auto picture = [&](const std::vector<std::string>& more) {
        std::vector<std::string> settings = {"reflection.enabled=true", "reflection.reflectance=1",
                                             "shadow.enabled=false"};
        settings.insert(settings.end(), more.begin(), more.end());
        return draw(params_with(plain(settings)), box_scene(), technique_px);
    };
    EXPECT_LE(pixels_beyond(picture({}), picture({"cull.enabled=true"}), 3), 10);
    EXPECT_GT(pixels_beyond(picture({}), picture({"cull.enabled=true", "reflection.flip_winding=false"}), 3), 100);
}

TEST_F(Technique, StencilViewShowsTheValues) {
    const Rgb of_0(18, 20, 28), of_patch(43, 186, 140), of_missing(230, 158, 0), beside_patch(204, 121, 167);
    const auto shown = [&](const std::vector<std::string>& more, const glm::dvec3& point) {
        std::vector<std::string> settings = {"view.shows=stencil"};
        settings.insert(settings.end(), more.begin(), more.end());
        return color_at(plain(settings), box_scene(), point);
    };
    EXPECT_LE(worst_channel(shown({}, in_light), of_patch), 1);
    EXPECT_LE(worst_channel(shown({}, in_shadow), of_missing), 1);
    EXPECT_LE(worst_channel(shown({"plane.extent=1.2"}, in_light), of_0), 1);
    EXPECT_LE(worst_channel(shown({"shadow.stencil_once=false"}, in_shadow), of_patch), 1);
    EXPECT_LE(worst_channel(shown({"plane.extent=1.2", "shadow.clip_to_receiver=false"}, in_shadow), beside_patch), 1);
    EXPECT_LE(worst_channel(shown({"shadow.style=missing_light"}, in_shadow), of_missing), 1);
}

TEST_F(Technique, DepthViewIsBlackNearAndWhiteFar) {
    const Scene ball_scene = scene_of({facing_quad("quad", 10, {255, 255, 255})});
    for (const char* const mapping :
         {"depth.mapping=standard", "depth.mapping=reversed", "depth.mapping=logarithmic"}) {
        SCOPED_TRACE(mapping);
        const Image linear = draw(params_with(from_origin({mapping, "view.shows=depth", "depth.format=d32f"})),
                                  ball_scene, technique_px);
        const double grey = 255.0 * (10 - 0.5) / (40 - 0.5);
        EXPECT_LE(worst_channel(rgb_at(linear, technique_px / 2), Rgb(glm::round(glm::dvec3(grey)))), 1);
        const Rgb unwritten = rgb_at(linear, {2, 2});
        EXPECT_GT(unwritten.b, unwritten.r + 20);  // tinted
        const Image window = draw(params_with(from_origin({mapping, "view.shows=depth", "view.depth_scale=window"})),
                                  ball_scene, technique_px);
        const bool logarithmic = std::string(mapping) == "depth.mapping=logarithmic";
        const double depth = logarithmic ? std::log(20.0) / std::log(80.0) : 40.0 / 39.5 * (1.0 - 0.5 / 10.0);
        EXPECT_LE(worst_channel(rgb_at(window, technique_px / 2), Rgb(glm::round(glm::dvec3(255.0 * depth)))), 1);
    }
}

TEST_F(Technique, MirroredLightIlluminatesTheMirroredSide) {
    // The mirror image of the box's top is lit from below when the light is mirrored; otherwise light comes from above
    // and leaves it unlit.
    const std::vector<std::string> mirror = {"reflection.enabled=true", "reflection.reflectance=1",
                                             "shadow.enabled=false", "light.position=[0,8,0.5,1]"};
    const Scene floating = scene_of({object("box", box_mesh(), {0, 2.5, 0})});
    // The image of the underside, y = 1.5, appears at y = −1.5. The underside faces away from the light in both worlds.
    const auto color = [&](const char* light, double y_world) {
        std::vector<std::string> settings = mirror;
        settings.emplace_back(light);
        return color_at(plain(settings), floating, {0.0, -y_world, 1.0 - 0.05});
    };
    const Rgb mirrored = color("reflection.reflect_light=true", 1.5),
              not_mirrored = color("reflection.reflect_light=false", 1.5);
    EXPECT_GT(not_mirrored.b,
              mirrored.b + 40);  // the light itself is above, so it wrongly lights the side that faces up
}

TEST_F(Technique, MirrorImageEqualsTheMirroredCamerasView) {
    // Compares the picture of R · scene, drawn with flipped winding, with the mirrored camera's picture, flipped left
    // to right.
    Random random(seed);
    const Scene scene = scene_named("torus-and-boxes");
    for (int trial = 0; trial < 10; ++trial) {
        SCOPED_TRACE("seed " + std::to_string(seed) + " trial " + std::to_string(trial));
        Params params =
            params_with({"view.samples=0", "shadow.enabled=false", "reflection.reflectance=1", "cull.enabled=true"});
        params.planes.front().equation = {random.direction(), random.number(-0.5, 0.5)};
        params.camera.position = 7.0 * random.direction();
        const Angles angles = angles_looking_at(params.camera.position, {0, 0, 0});
        params.camera.yaw = angles.yaw_deg;
        params.camera.pitch = angles.pitch_deg;
        const Derived derived = derive_for(params, scene, technique_px);
        FramePlan image = plan(params, derived);
        std::erase_if(image.passes,
                      [](const Pass& pass) { return pass.subject != Subject::objects || !pass.is_mirror_image; });
        ASSERT_EQ(image.passes.size(), 1U);
        image.passes[0].stencil = {};
        image.passes[0].clip_planes.clear();

        // C′ = R C with x negated is a rigid pose again.
        const glm::dmat4 mirrored_camera = derived.planes[0].mirrored_world_from_world * derived.world_from_view *
                                           glm::scale(glm::dmat4(1.0), {-1, 1, 1});
        const Angles mirrored_angles = angles_from_rotation(glm::dmat3(mirrored_camera));
        Params from_behind = params;
        from_behind.camera.position = glm::dvec3(mirrored_camera[3]);
        from_behind.camera.yaw = mirrored_angles.yaw_deg;
        from_behind.camera.pitch = mirrored_angles.pitch_deg;
        from_behind.camera.roll = mirrored_angles.roll_deg;
        FramePlan direct = plan(from_behind, derive_for(from_behind, scene, technique_px));
        std::erase_if(direct.passes,
                      [](const Pass& pass) { return pass.subject != Subject::objects || pass.is_mirror_image; });

        Image flipped = draw(direct, scene, technique_px);
        for (int y = 0; y < flipped.height; ++y)
            for (int x = 0; x < flipped.width / 2; ++x)
                std::swap_ranges(flipped.row(y) + 4 * x, flipped.row(y) + 4 * x + 4,
                                 flipped.row(y) + 4 * (flipped.width - 1 - x));
        const Image mirrored = draw(image, scene, technique_px);
        const Image background(draw(params, scene_of({}), technique_px));
        EXPECT_GT(pixels_beyond(mirrored, background, 10), 300);
        EXPECT_LE(pixels_beyond(mirrored, flipped, 2), 60);  // edges: rasterization is not symmetric
    }
}

TEST_F(Technique, ObliqueNearPlaneAndClipDistanceCutAlike) {
    Random random(seed);
    const Scene scene = scene_named("torus-and-boxes");
    int cut = 0;
    for (int trial = 0; trial < 12; ++trial) {
        SCOPED_TRACE("seed " + std::to_string(seed) + " trial " + std::to_string(trial));
        Params params = params_with({"view.samples=0", "reflection.reflectance=1"});
        params.projection.type = trial % 3 == 2 ? ProjectionType::orthographic : ProjectionType::perspective;
        params.planes.front().equation = {random.direction(), random.number(-0.5, 0.5)};
        params.camera.position = 7.0 * random.direction();
        const Angles angles = angles_looking_at(params.camera.position, {0, 0.3, 0});
        params.camera.yaw = angles.yaw_deg;
        params.camera.pitch = angles.pitch_deg;
        const Image by_distance = draw(params, scene, technique_px);
        params.reflection.clip = MirrorClip::oblique;
        EXPECT_LE(pixels_beyond(by_distance, draw(params, scene, technique_px), 3), 80);
        params.reflection.clip = MirrorClip::none;
        cut += pixels_beyond(by_distance, draw(params, scene, technique_px), 3) > 200 ? 1 : 0;
    }
    EXPECT_GE(cut, 6) << "the planes have to cut through the scene";
}

TEST_F(Technique, MirrorStaysInsideItsPatchOnlyWithTheStencil) {
    const std::vector<std::string> mirror = {"reflection.enabled=true", "reflection.reflectance=1",
                                             "shadow.enabled=false", "plane.extent=1.05"};
    const Scene floating = scene_of({object("box", box_mesh(), {0, 2.5, 0})});
    const glm::dvec3 image_beside_patch(0.0, -2.5, 1.0);
    EXPECT_EQ(color_at(plain(mirror), floating, image_beside_patch), Rgb(0x1b, 0x1f, 0x27));
    std::vector<std::string> open = mirror;
    open.emplace_back("reflection.stencil=false");
    EXPECT_GT(color_at(plain(open), floating, image_beside_patch).b, 0x60);
}

TEST_F(Technique, OrthographicFacesAreLitByTheViewDirection) {
    // This side is off the axis and leans 10° from +x toward the camera. Parallel view rays meet its lit outside,
    // whichever side of its plane the camera is on.
    SceneObject leaning = object("leaning", quad_mesh(), {0, 0, 0});
    leaning.world_from_model = glm::translate(glm::dmat4(1.0), {3, 0, -5}) *
                               glm::rotate(glm::dmat4(1.0), glm::radians(-10.0), {0, 1, 0}) *
                               glm::rotate(glm::dmat4(1.0), glm::radians(-90.0), {0, 0, 1});
    const Scene scene = scene_of({leaning});
    const auto color_from = [&](double camera_x) {
        Params params = params_with(
            from_origin({"projection.type=orthographic", "projection.height=4", "light.position=[1,0,0.3,0]"}));
        params.camera.position.x = camera_x;
        const Derived derived = derive_for(params, scene, technique_px);
        return rgb_at(draw(params, scene, technique_px), pixel_of({3, 0, -5}, derived, technique_px));
    };
    EXPECT_GT(color_from(5.0).b, 150);
    EXPECT_LE(worst_channel(color_from(5.0), color_from(1.0)), 1);
}

}  // namespace
}  // namespace viewing
