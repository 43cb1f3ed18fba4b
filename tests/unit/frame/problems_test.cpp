// Every switch that breaks shadows or mirrors is explained where its effect is visible, and nowhere else.
#include "frame/problems.h"

#include <algorithm>

#include "frame_test.h"
#include "state/fields.h"
#include "state/person/language.h"
#include "state/presets.h"
#include "trials.h"

namespace viewing {
namespace {

using testing::box_scene;
using testing::object;
using testing::params_with;
using testing::says;
using testing::scene_of;
using Settings = std::vector<std::string>;

std::vector<Problem> problems_with(const Settings& settings, const Scene& scene) {
    return testing::problems_of(params_with(settings), scene);
}

std::string all_of(const std::vector<Problem>& problems) {
    std::string text;
    for (const Problem& problem : problems) text += std::string(problem.group) + ": " + say(problem.sentence) + "\n";
    return text;
}

/// The first four scenes have a box on the floor in front of the eye and a second box that crosses the floor, lies
/// below it, or reaches above the light.
Scene crossing_scene() {
    return scene_of({object("box", box_mesh(), {0, 1, 0}), object("sunk", box_mesh(), {2, 0, 0})});
}
Scene buried_scene() {
    return scene_of({object("box", box_mesh(), {0, 1, 0}), object("buried", box_mesh(), {2, -3, 0})});
}
Scene just_buried_scene() {
    return scene_of({object("box", box_mesh(), {0, 1, 0}), object("buried", box_mesh(), {1.5, -1.2, 0}, {1, 0.5, 1})});
}
Scene high_scene() {
    return scene_of({object("box", box_mesh(), {0, 1, 0}), object("tower", box_mesh(), {-1, 5, 0})});
}
Scene small_scene() {
    return scene_of({object("pea", sphere_mesh(), {0, 0.1, 0}, glm::dvec3(0.1))});
}

Scene far_shadow_scene() {
    return scene_of({object("ball", sphere_mesh(), {1.5, 1.2, 0.5}, glm::dvec3(0.7))});
}
Scene sheet_scene() {
    return scene_of({object("sheet", box_mesh(), {0, 0, 0}, {1, 0, 1})});
}
Scene lifted_sheet_scene() {
    return scene_of({object("sheet", box_mesh(), {0, 0.01, 0}, {1, 0, 1})});
}

Scene mirrored_scene() {
    return scene_of({object("twin", box_mesh(), {0, 1, 0}, {-1, 1, 1})});
}

Scene nothing() {
    return scene_of({});
}

Scene coplanar_scene() {
    return scene_of({object("red", quad_mesh(), {0, 1, 0}), object("blue", quad_mesh(), {0, 1, 0})});
}
Scene nearly_coplanar_scene() {
    return scene_of({object("red", quad_mesh(), {0, 1, 0}), object("blue", quad_mesh(), {0, 1.0001, 0})});
}

const std::string wall = "planes=[{\"equation\":[0,0,1,3]}]";
const std::string corner = "planes=[{\"equation\":[0,0,1,3]},{\"equation\":[1,0,0,3]}]";
const std::string facing_walls =
    "planes=[{\"equation\":[0,0,1,8],\"receives_shadow\":false},{\"equation\":[0,0,-1,8],\"receives_shadow\":false}]";
const std::string side_light = "lights=[{\"position\":[-3,5,2,1]}]";

struct Case {
    std::string group, words;
    Scene (*scene)();
    Settings told, not_told;
    Scene (*scene_of_not_told)() = nullptr;  ///< null: `scene`, as for `told`
};

const std::vector<Case>& cases() {
    static const std::vector<Case> all = {
        // shadow
        {"shadow",
         "the shadow is darker wherever",
         box_scene,
         {"shadow.stencil_once=false"},
         {"shadow.stencil_once=false", "shadow.opacity=1"}},
        {"shadow",
         "the shadow is darker wherever",
         box_scene,
         {"shadow.stencil_once=false"},
         {"shadow.stencil_once=false", "shadow.style=missing_light"}},
        {"shadow",
         "past the floor's edge",
         box_scene,
         {"shadow.clip_to_receiver=false", "plane.extent=1.5"},
         {"shadow.clip_to_receiver=false", "plane.extent=50"}},
        {"shadow",
         "past the floor's edge",
         box_scene,
         {"shadow.clip_to_receiver=false", "plane.extent=1.5"},
         {"plane.extent=1.5"}},
        {"shadow", "fight", box_scene, {"shadow.offset=none"}, {"shadow.offset=none", "depth.test=false"}},
        {"shadow",
         "fight",
         box_scene,
         {"shadow.offset_factor=0", "shadow.offset_units=0"},
         {"shadow.offset_factor=0", "shadow.offset_units=-8"}},
        {"shadow",
         "away from the eye",
         box_scene,
         {"shadow.offset_factor=1", "shadow.offset_units=1"},
         {"shadow.offset_factor=-1", "shadow.offset_units=0"}},
        {"shadow", "away from the eye", box_scene, {"shadow.offset_factor=0.5"}, {"shadow.offset_factor=-0.5"}},
        {"shadow", "floats 0.05 above", box_scene, {"shadow.offset=lift", "shadow.lift=0.05"}, {"shadow.lift=0.05"}},
        {"shadow",
         "writes its depth",
         box_scene,
         {"shadow.write_depth=true"},
         {"shadow.write_depth=true", "shadow.offset=no_depth_test"}},
        {"shadow",
         "highlight",
         box_scene,
         {"plane.gloss=true", "light.position=[-1.9,5,-6.2,1]"},
         {"plane.gloss=true", "light.position=[-1.9,5,-6.2,1]", "shadow.style=missing_light"}},
        {"shadow",
         "highlight",
         box_scene,
         {"plane.gloss=true", "light.position=[-1.9,5,-6.2,1]"},
         {"plane.gloss=true"}},
        {"shadow",
         "covers the plane's pattern",
         box_scene,
         {"shadow.opacity=1"},
         {"shadow.opacity=1", "shadow.enabled=false"}},
        {"shadow", "the part of sunk there is not clipped", crossing_scene, {"shadow.clip_casters=false"}, {}},
        {"shadow",
         "false shadow",
         buried_scene,
         {"shadow.clip_casters=false"},
         {"shadow.clip_casters=false"},
         box_scene},
        {"shadow",
         "the part of tower beyond the light",
         high_scene,
         {"shadow.sign=forced", "shadow.clip_at_light=false"},
         {"shadow.sign=forced"}},
        {"shadow",
         "anti-shadow",
         high_scene,
         {"shadow.sign=forced", "shadow.clip_at_light=false"},
         {"shadow.sign=forced", "shadow.clip_at_light=false"},
         box_scene},
        {"shadow",
         "removes every shadow",
         box_scene,
         {"shadow.sign=none", "plane.equation=[0,-1,0,0]"},
         {"shadow.sign=none"}},
        {"shadow",
         "removes every shadow",
         box_scene,
         {"shadow.sign=none", "plane.equation=[0,-1,0,0]"},
         {"plane.equation=[0,-1,0,0]"}},
        {"shadow",
         "Sᵀ sends the center of the plane",
         box_scene,
         {"slips.shadow_by_rows=true"},
         {"slips.shadow_by_rows=true", "light.position=[0,5,0,0]"}},
        {"shadow",
         "Sᵀ sends the center of the plane",
         box_scene,
         {"slips.shadow_by_rows=true"},
         {"slips.shadow_by_rows=true", "shadow.enabled=false"}},
        {"shadow",
         "the plane w = 0 through the light cuts tower",
         high_scene,
         {"shadow.clip_at_light=false"},
         {"shadow.clip_at_light=false", "light.position=[2.6,7,2.2,1]"}},
        {"shadow",
         "the part of tower that is not between the light and the plane (w",
         high_scene,
         {},
         {"light.position=[2.6,7,2.2,1]"}},
        {"shadow",
         "share one stencil value",
         far_shadow_scene,
         {"shadow.own_stencil=false", "planes=[{\"equation\":[1,0,0,2],\"extent\":0.5}]", "light.position=[4,2,0.5,1]"},
         {"shadow.own_stencil=false", "planes=[{\"equation\":[1,0,0,2],\"extent\":0.5}]", "light.position=[4,9,2,1]"}},
        {"shadow",  // without the depth test, the wall's shadow shows through the floor's patch
         "share one stencil value",
         box_scene,
         {"shadow.own_stencil=false", wall, "depth.test=false"},
         {"shadow.own_stencil=false", wall}},
        {"reflection",
         "the image in plane 2 is also drawn over plane 1",
         box_scene,
         {"shadow.own_stencil=false", wall},
         {"shadow.own_stencil=false", "planes=[{\"equation\":[0,0,1,3],\"mirrors\":false}]"}},
        {"depth", "sheet lies in the plane itself", sheet_scene, {}, {}, lifted_sheet_scene},
        {"depth", "sheet lies in the plane itself", sheet_scene, {}, {"depth.test=false"}},
        {"depth", "sheet lies in the plane itself", sheet_scene, {}, {"plane.equation=[0,1,0,0.01]"}},
        {"depth",
         "at the mirror image of box",
         box_scene,
         {"plane.equation=[0,0,1,3]", "camera.position=[0,1,-1.5]", "camera.yaw=0", "camera.pitch=0",
          "projection.near=0.00001"},
         {"plane.equation=[0,0,1,3]", "camera.position=[0,1,-1.5]", "camera.yaw=0", "camera.pitch=0"}},
        {"shadow", "share one stencil bit", box_scene, {"shadow.own_stencil=false", side_light}, {side_light}},
        // light
        {"light",
         "w = 0.05 makes this a point light at (52, 104, 44)",
         box_scene,
         {"light.position=[2.6,5.2,2.2,0.05]"},
         {"light.position=[2.6,5.2,2.2,0]"}},
        {"light",
         "w = 8·10⁻⁶ makes this a point light at (500000, 1.13·10⁶, 250000)",
         box_scene,
         {"light.position=[4,9,2,8e-6]"},
         {"light.position=[4,9,2,0]"}},
        {"light",
         "w = 0.5 makes light 2 a point light at (2, 10, −4)",
         box_scene,
         {"lights=[{\"position\":[1,5,-2,0.5]}]"},
         {side_light}},
        {"light",
         "the light lies in the plane",
         box_scene,
         {"light.position=[3,0,-2,1]"},
         {"light.position=[3,0.1,-2,1]"}},
        {"light",
         "the rays of parallel light 2 run along plane 1:",
         box_scene,
         {"lights=[{\"position\":[3,0,1,0]}]", wall},
         {"lights=[{\"position\":[3,0,1,0]}]"}},
        {"light",
         "the light and the eye are on opposite sides of planes 1, 2",
         box_scene,
         {"light.position=[0,-1,-9,1]", wall},
         {wall}},
        // plane
        {"plane", "the eye lies in plane 2", box_scene, {"planes=[{\"equation\":[1,0,0,-3.9]}]"}, {wall}},
        {"plane", "draws only one plane", box_scene, {wall, "visibility.method=bsp"}, {wall}},
        // mirror
        {"reflection",
         "beyond the mirror's edge",
         box_scene,
         {"reflection.stencil=false", "plane.extent=1.2"},
         {"reflection.stencil=false", "plane.extent=1.2"},
         small_scene},
        {"reflection",
         "beyond the mirror's edge",
         box_scene,
         {"reflection.stencil=false", "plane.extent=1.2"},
         {"plane.extent=1.2"}},
        {"reflection", "buried behind the mirror", just_buried_scene, {"reflection.clip=none"}, {}},
        {"reflection",  // a deeper box's image is so high that no line of sight to it meets the mirror
         "buried behind the mirror",
         just_buried_scene,
         {"reflection.clip=none"},
         {"reflection.clip=none"},
         buried_scene},
        {"reflection",
         "the mirror's plane cuts sunk",
         crossing_scene,
         {"reflection.clip=none"},
         {"reflection.clip=none"},
         box_scene},
        {"reflection",
         "the mirror is the image's near plane",
         box_scene,
         {"reflection.clip=oblique"},
         {"reflection.clip=oblique", "reflection.enabled=false"}},
        {"reflection",
         "the mirror is the image's near plane",
         box_scene,
         {"reflection.clip=oblique"},
         {"reflection.clip=oblique", "visibility.method=none"}},
        {"reflection",
         "appears inside out",
         box_scene,
         {"reflection.flip_winding=false", "cull.enabled=true"},
         {"reflection.flip_winding=false"}},
        {"reflection",
         "count as back-facing",
         box_scene,
         {"reflection.flip_winding=false", "view.shows=facing"},
         {"view.shows=facing"}},
        {"reflection",
         "not mirrored with the scene",
         box_scene,
         {"reflection.reflect_light=false"},
         {"reflection.reflect_light=false", "plane.mirrors=false"}},
        {"reflection",
         "writes the mirror's own depth",
         box_scene,
         {"reflection.mask_writes_depth=true"},
         {"reflection.mask_writes_depth=true", "depth.test=false"}},
        {"reflection",
         "covers the objects in front",
         box_scene,
         {"reflection.after_objects=true"},
         {"reflection.after_objects=true", "plane.equation=[0,0,1,-3]", "plane.extent=0.5"}},
        {"reflection",
         "seen from behind",
         box_scene,
         {"reflection.side_of_eye=false", "plane.equation=[0,-1,0,0]"},
         {"reflection.side_of_eye=false"}},
        {"reflection",
         "aspect ratio of a square",
         box_scene,
         {"reflection.mirrored=camera", "reflection.same_projection=false"},
         {"reflection.same_projection=false"}},
        {"reflection",
         "drawn with fovy 20° instead of the camera's 40°: the image is 2.06 times as large",
         box_scene,
         {"reflection.fovy=20"},
         {"reflection.fovy=20", "projection.fovy=20"}},
        {"reflection",
         "filled row by row",
         box_scene,
         {"reflection.printed_by_rows=true", "plane.equation=[0,1,0,0.5]"},
         {"reflection.printed_by_rows=true"}},
        {"reflection", "without shadows", box_scene, {"reflection.shadows=false", wall}, {"reflection.shadows=false"}},
        {"reflection",
         "hits up to 2 mirrors in a row: a mirror seen in a mirror",
         box_scene,
         {wall},
         {wall, "reflection.bounces=2"}},
        {"reflection",
         "hits up to 3 mirrors in a row: the mirror after 2",
         box_scene,
         {corner, "reflection.bounces=2"},
         {corner, "reflection.bounces=3"}},
        {"reflection",
         "endlessly: the mirror after 3 bounces",
         box_scene,
         {facing_walls, "reflection.bounces=3"},
         {facing_walls, "reflection.enabled=false"}},
        {"reflection",
         "of 16 bounces are drawn",
         box_scene,
         {facing_walls, "reflection.bounces=16"},
         {"reflection.bounces=16"}},
        {"reflection",
         "only the first of 6 bounces",
         box_scene,
         {facing_walls, "reflection.bounces=6", "reflection.stencil=false"},
         {facing_walls, "reflection.bounces=6"}},
        {"shadow",
         "n·ℓ + d < 0 for the light on plane 2",
         box_scene,
         {"shadow.sign=none", "planes=[{\"equation\":[0,0,-1,-3]}]"},
         {"shadow.sign=none", wall}},
        {"reflection",
         "part of plane 2 is behind the mirror of plane 1",
         box_scene,
         {"reflection.clip=none", "planes=[{\"equation\":[0,1,1,3]}]"},
         {"reflection.clip=none", wall}},
        {"reflection",
         "the oblique near plane is (0, 1, 0, 0)",
         box_scene,
         {"reflection.clip=oblique", "slips.oblique_in_world=true"},
         {"slips.oblique_in_world=true"}},
        {"reflection",
         "the oblique near plane is",
         box_scene,
         {"reflection.clip=oblique", "slips.oblique_in_world=true"},
         {"reflection.clip=oblique", "slips.oblique_in_world=true", "camera.position=[0,0,0]", "camera.yaw=0",
          "camera.pitch=0", "plane.equation=[0,0,1,3]"}},
        // matrices entered by hand
        {"shadow",
         "sign(n·ℓ + d) = −1 makes it",
         box_scene,
         {"overrides.shadow_from_world=[[1,0,0,0],[0,0,0,0],[0,0,1,0],[0,0,0,1]]", "plane.equation=[0,-1,0,0]"},
         {"overrides.shadow_from_world=[[1,0,0,0],[0,0,0,0],[0,0,1,0],[0,0,0,1]]", "plane.equation=[0,-1,0,0]",
          "shadow.sign=none"}},
        {"shadow",
         "S entered by hand is the transpose of the correct S",
         box_scene,
         {"overrides.shadow_from_world=[[5.2,0,0,0],[-2.6,0,-2.2,-1],[0,0,5.2,0],[0,0,0,5.2]]"},
         {"overrides.shadow_from_world=[[5.2,-2.6,0,0],[0,0,0,0],[0,-2.2,5.2,0],[0,-1,0,5.2]]"}},
        {"shadow",
         "does not send points into the plane: ",
         box_scene,
         {"overrides.shadow_from_world=[[1,0,0,0],[0,0.5,0,0],[0,0,1,0],[0,0,0,1]]"},
         {"overrides.shadow_from_world=[[1,0,0,0],[0,0,0,0],[0,0,1,0],[0,0,0,1]]"}},
        {"reflection",
         "is the reflection matrix for the plane y = 0.5, not for this one",
         box_scene,
         {"overrides.mirror_from_world=[[1,0,0,0],[0,-1,0,1],[0,0,1,0],[0,0,0,1]]"},
         {"overrides.mirror_from_world=[[1,0,0,0],[0,-1,0,0],[0,0,1,0],[0,0,0,1]]"}},
        {"reflection",
         "moves the points of the plane",
         box_scene,
         {"overrides.mirror_from_world=[[1,0,0,0],[0.3,-1,0,1],[0,0,1,0],[0,0,0,1]]"},
         {"overrides.mirror_from_world=[[1,0,0,0],[0,-1,0,0],[0,0,1,0],[0,0,0,1]]"}},
        // camera, light, plane
        {"camera",
         "roll creeps in",
         box_scene,
         {"slips.creeping_roll=true", "camera.navigation=walk"},
         {"slips.creeping_roll=true", "camera.navigation=fly"}},
        {"light",
         "points toward the light",
         box_scene,
         {"light.position=[1,-2,0.5,0]"},
         {"light.position=[1,-2,0.5,1]"}},
        {"plane",
         "seen edge-on",
         box_scene,
         {"camera.position=[0,0,8]"},
         {"camera.position=[0,0,8]", "reflection.enabled=false"}},
        // hidden surfaces
        {"visibility",
         "GL_FRONT_AND_BACK",
         box_scene,
         {"cull.enabled=true", "cull.face=front_and_back"},
         {"cull.face=front_and_back"}},
        {"visibility",
         "GL_FRONT culls",
         box_scene,
         {"cull.enabled=true", "cull.face=front"},
         {"cull.enabled=true", "cull.face=front", "cull.front_face=cw"}},
        {"visibility", "GL_CW declares", box_scene, {"cull.enabled=true", "cull.front_face=cw"}, {"cull.enabled=true"}},
        {"visibility",
         "GL_CW declares",
         box_scene,
         {"cull.enabled=true", "cull.front_face=cw"},
         {"cull.enabled=true", "cull.front_face=cw", "camera.yaw=180"}},
        {"visibility",
         "the scale of twin is negative",
         mirrored_scene,
         {"cull.enabled=true"},
         {"cull.enabled=true", "cull.face=front"}},
        {"visibility", "the scale of", mirrored_scene, {"cull.enabled=true"}, {"cull.enabled=true"}, box_scene},
        {"depth", "does not resolve gaps", box_scene, {"projection.near=0.0001"}, {"projection.near=0.01"}},
        {"depth",
         "does not resolve gaps",
         box_scene,
         {"projection.type=orthographic", "projection.far=500000000"},
         {"projection.type=orthographic", "projection.far=1000"}},
        {"depth",
         "does not resolve gaps",
         box_scene,
         {"depth.format=d16", "projection.near=0.01"},
         {"projection.near=0.01"}},
        {"depth", "red and blue lie in the same plane", coplanar_scene, {}, {}, nearly_coplanar_scene},
        {"depth", "red and blue lie in the same plane", coplanar_scene, {}, {"camera.yaw=180"}},
        {"depth", "red and blue are 0.0001 apart", nearly_coplanar_scene, {"projection.near=0.001"}, {}},
        {"depth",
         "red and blue are 0.0001 apart",
         nearly_coplanar_scene,
         {"depth.format=d16"},
         {"depth.format=d16", "depth.test=false"}},
        {"depth",
         "a side of box lies in the plane",
         box_scene,
         {"camera.position=[0,-3,8]", "camera.yaw=0", "camera.pitch=20"},
         {"camera.position=[0,3,8]", "camera.yaw=0", "camera.pitch=-20"}},
        {"depth",
         "a side of box lies in the plane",
         box_scene,
         {"cull.enabled=true", "cull.face=front"},
         {"cull.enabled=true", "cull.face=back"}},
        {"depth",
         "as with the test off, but here depth is still written",
         box_scene,
         {"depth.func=always"},
         {"depth.func=always", "depth.write=false"}},
        {"depth", "GL_ALWAYS", nothing, {"depth.func=always", wall}, {"depth.func=always"}},
        {"depth",
         "so little is gained",
         box_scene,
         {"depth.mapping=reversed", "depth.reversed_zero_to_one=false", "depth.format=d32f"},
         {"depth.mapping=reversed", "depth.reversed_zero_to_one=false", "depth.format=d24"}},
        // The image of the box is 12 away, the mirror 9.
        {"depth",
         "nothing beyond is drawn",
         box_scene,
         {"plane.equation=[0,0,1,3]", "camera.position=[0,1,6]", "camera.yaw=0", "camera.pitch=0",
          "depth.clear_value=0.962"},
         {"plane.equation=[0,0,1,3]", "camera.position=[0,1,6]", "camera.yaw=0", "camera.pitch=0",
          "depth.clear_value=0.962", "reflection.enabled=false"}},
        {"light",
         "its shadows spread",
         box_scene,
         {"light.position=[0.6,1.2,0.5,0.2]"},
         {"light.position=[0.6,1.2,0.5,0.2]", "shadow.enabled=false"}},
        {"reflection",
         "covers the part of",
         nothing,
         {"reflection.after_objects=true", wall},
         {"reflection.after_objects=true"}},
        {"depth", "glClearDepth(0) is the nearest", box_scene, {"depth.clear_value=0"}, {}},
        {"depth",
         "glClearDepth(0) is the nearest",
         box_scene,
         {"depth.clear_value=0"},
         {"depth.clear_value=0", "depth.mapping=reversed", "depth.reversed_clear=false"}},
        {"depth",
         "glClearDepth(0.94): every pixel starts with the depth of z = 6.97",
         box_scene,
         {"depth.clear_value=0.94"},
         {"depth.clear_value=0.999"}},
        {"depth",
         "the farthest surface wins",
         box_scene,
         {"depth.clear_value=0", "depth.func=greater"},
         {"depth.func=greater"}},
        {"view", "far = 8 cuts off box", box_scene, {"projection.far=8"}, {"projection.far=12"}},
        {"view", "near = 8 cuts into box", box_scene, {"projection.near=8"}, {"projection.near=2"}},
        {"view",
         "near = 8 cuts into box and the plane: the",
         box_scene,
         {"projection.near=8"},
         {"projection.near=5.5"}},
        {"depth",
         "gl_FragDepth",
         box_scene,
         {"depth.mapping=logarithmic"},
         {"depth.mapping=logarithmic", "shadow.offset=lift"}},
    };
    return all;
}

TEST(Problems, DoNotDependOnTheLanguage) {
    std::size_t count = 0, index = 0;
    for (const NamedFile& preset : presets()) {
        if (!testing::takes(index++)) continue;
        const testing::LoadedPreset loaded = testing::preset_named(preset.name);
        ASSERT_TRUE(speak(Language::en));
        const std::vector<Problem> english = testing::problems_of(loaded.params, loaded.scene);
        std::vector<std::string> said;
        for (const Problem& problem : english) said.push_back(say(problem.sentence));
        ASSERT_TRUE(speak(Language::ko));
        EXPECT_TRUE(english == testing::problems_of(loaded.params, loaded.scene)) << preset.name;
        for (std::size_t i = 0; i < said.size(); ++i) EXPECT_NE(said[i], say(english[i].sentence));
        count += said.size();
    }
    ASSERT_TRUE(speak(Language::en));
    EXPECT_GT(count, is_sanitized ? 10U : 50U);
}

TEST(Problems, SwitchIsReportedOnlyWhereItShows) {
    for (const Case& each : cases()) {
        const auto trace = [](const Settings& settings) {
            std::string text;
            for (const std::string& setting : settings) text += setting + " ";
            return text;
        };
        SCOPED_TRACE(each.words + " | " + trace(each.told) + "| " + trace(each.not_told));
        const std::vector<Problem> told = problems_with(each.told, each.scene());
        EXPECT_TRUE(says(told, each.group, each.words)) << all_of(told);
        const auto other_scene = each.scene_of_not_told ? each.scene_of_not_told : each.scene;
        const std::vector<Problem> not_told = problems_with(each.not_told, other_scene());
        EXPECT_FALSE(says(not_told, each.group, each.words)) << all_of(not_told);
    }
}

TEST(Problems, AreAbsentForTheDefaults) {
    EXPECT_EQ(all_of(problems_with({}, box_scene())), "");
    EXPECT_EQ(all_of(problems_with({"plane.equation=[0,-2,0,0]"}, box_scene())), "");
    EXPECT_EQ(all_of(problems_with({"light.position=[2.6,5.2,2.2,0]", "shadow.style=missing_light"}, box_scene())), "");
}

TEST(Problems, InvisibleEffectsAreNotExplained) {
    const Settings broken = {"shadow.stencil_once=false",      "shadow.offset=none",   "reflection.stencil=false",
                             "reflection.reflect_light=false", "reflection.clip=none", "plane.extent=1.2"};
    EXPECT_GE(problems_with(broken, crossing_scene()).size(), 5U);
    for (const char* hides : {"visibility.step=3", "view.shows=overdraw", "view.shows=fighting"}) {
        Settings hidden = broken;
        hidden.emplace_back(hides);
        EXPECT_EQ(all_of(problems_with(hidden, crossing_scene())), "") << hides;
    }
}

TEST(Problems, BrokenPictureIsReportedOnThePicture) {
    const auto breaks = [](const Settings& settings) {
        const std::vector<Problem> problems = problems_with(settings, high_scene());
        return std::ranges::count(problems, ProblemKind::wrong, &Problem::kind);
    };
    EXPECT_EQ(breaks({}), 0);  // no switch causes the problem of the tower above the light
    EXPECT_EQ(breaks({"light.position=[3,-4,2,1]"}), 0);
    EXPECT_EQ(breaks({"shadow.offset=none"}), 1);
    EXPECT_EQ(breaks({"light.position=[2,5,2,0.5]"}), 0);  // between a point light and a parallel one
    EXPECT_EQ(breaks({"light.position=[2,5,2,0.01]"}), 1);
    EXPECT_EQ(breaks({"reflection.reflect_light=false", "shadow.stencil_once=false"}), 2);
}

/// The box reaches from z = −1 to 1, the mirror is z = −3, and the eye is at z = 5, so the mirror image
/// of the box reaches from 10 to 12 in front of the eye.
TEST(Problems, FarCutsAnImageWhereItsVerticesAre) {
    const auto told = [](const std::string& far) {
        return problems_with({"plane.equation=[0,0,1,3]", "camera.position=[0,1,5]", "camera.yaw=0", "camera.pitch=0",
                              "projection.far=" + far},
                             box_scene());
    };
    for (const char* cuts : {"9", "11", "11.9"}) {
        const std::vector<Problem> problems = told(cuts);
        EXPECT_TRUE(says(problems, "view", "the mirror image of box, which reaches to eye distance 12"))
            << all_of(problems);
    }
    for (const char* keeps : {"12.1", "40", "1000"})
        EXPECT_FALSE(says(told(keeps), "view", "cuts off")) << keeps << ": " << all_of(told(keeps));
}

/// Applying the fix removes the problem and puts every vertex on the eye's side of the plane.
TEST(Problems, PlaneMovesAwayFromWhatLiesInIt) {
    for (const char* equation : {"[0,1,0,0]", "[0,-3,0,0]"}) {
        const Settings settings = {std::string("plane.equation=") + equation};
        const std::vector<Problem> problems = problems_with(settings, sheet_scene());
        const auto found = std::find_if(problems.begin(), problems.end(), [](const Problem& problem) {
            return say(problem.sentence).find("lies in the plane itself") != std::string::npos;
        });
        ASSERT_NE(found, problems.end()) << equation;
        EXPECT_EQ(all_of(problems_with({settings[0], found->fixed_by}, sheet_scene())), "") << found->fixed_by;
        const Params fixed = params_with({settings[0], found->fixed_by});
        const glm::dvec4 plane = fixed.planes[0].equation;
        EXPECT_GT(plane.w * plane.y, 0.0) << "the sheet at y = 0 is above the plane, as the eye is";
        EXPECT_LT(std::abs(plane.w / plane.y), 0.05);
    }
}

TEST(Problems, ReportWhetherAnObliqueNearPlaneIsFinerOrCoarser) {
    const auto told = [](const char* preset) {
        const Result<LoadedState> state = load_state(preset);
        EXPECT_TRUE(state) << state.error();
        const Result<Params> params =
            apply_settings(state->params, std::vector<std::string>{"reflection.clip=oblique"});
        EXPECT_TRUE(params) << params.error();
        const Result<Scene> scene = load_scene(params->scene, state->base, params->coplanar);
        EXPECT_TRUE(scene) << scene.error();
        return testing::problems_of(*params, *scene, {{800, 450}});
    };
    for (const char* preset : {"opening", "wall-mirror", "mirror-ways", "mirror-oblique-depth"}) {
        const std::vector<Problem> problems = told(preset);
        const bool is_coarser = std::string(preset) == "mirror-oblique-depth";
        EXPECT_EQ(says(problems, "reflection", " times coarser"), is_coarser) << preset;
        EXPECT_EQ(says(problems, "reflection", " times finer"), !is_coarser) << preset;
    }
}

TEST(Problems, TableCoversEverySwitch) {
    // The table above must name each switch of shadow and mirror at least once.
    std::string tried;
    for (const Case& each : cases())
        for (const std::string& setting : each.told) tried += setting + " ";
    for (const Field& field : fields()) {
        const std::string path(field.path);
        const bool is_switch = path.starts_with("shadow.") || path.starts_with("reflection.");
        const bool is_taste = path == "shadow.enabled" || path == "shadow.color" || path == "shadow.style" ||
                              path == "reflection.enabled" || path == "reflection.reflectance";
        if (!is_switch || is_taste) continue;
        EXPECT_NE(tried.find(path + "="), std::string::npos) << path;
    }
}

}  // namespace
}  // namespace viewing
