// Every switch that breaks shadow or mirror changes the picture of a state where its artefact can be seen, and every
// switch is drawn without a GL error on a busy state. The reasons are told by frame/planes/shadow_problems.cpp and
// frame/planes/mirror_problems.cpp; planes_edges_test.cpp has the degenerate states.
#include "gl_test.h"

namespace viewing {
namespace {

using testing::object;
using testing::params_with;
using testing::pixels_beyond;
using testing::scene_named;
using testing::scene_of;

constexpr glm::ivec2 size_px(160, 90);

struct Artefact {
    const char* name;
    std::vector<std::string> state;
    const char* broken;  ///< the switch
};

const char* const wall = R"(planes=[{"equation":[0,0,1,2.5],"extent":3}])";
const char* const two_lights = R"(lights=[{"position":[1.6,5.4,3,1]}])";

std::vector<Artefact> artefacts() {
    return {
        {"blended twice", {}, "shadow.stencil_once=false"},
        {"beyond the receiver", {"plane.extent=1.5", "reflection.enabled=false"}, "shadow.clip_to_receiver=false"},
        {"fights with the floor", {"reflection.enabled=false"}, "shadow.offset=none"},
        {"lifted",
         {"camera.position=[0,0.6,7]", "camera.yaw=0", "camera.pitch=-3", "shadow.lift=0.2"},
         "shadow.offset=lift"},
        {"offset to the wrong side", {"reflection.enabled=false", "shadow.offset_factor=0"}, "shadow.offset_units=4"},
        {"offset disturbs depth", {"shadow.offset_units=-20000", "shadow.offset_factor=-8"}, "shadow.write_depth=true"},
        {"black paint", {}, "shadow.opacity=1"},
        {"false shadow", {"plane.equation=[0,1,0,-1]", "reflection.enabled=false"}, "shadow.clip_casters=false"},
        {"anti-shadow", {"light.position=[0,0.8,0.4,1]", "shadow.clip_at_light=false"}, "shadow.sign=forced"},
        {"stretches to infinity", {"light.position=[0,0.8,0.4,1]", "shadow.sign=forced"}, "shadow.clip_at_light=false"},
        {"vanishes with the normal", {"plane.equation=[0,-1,0,0]"}, "shadow.sign=none"},
        {"parallel light faked", {"light.position=[4,2,3,0]"}, "light.position=[4,2,3,0.25]"},
        {"shared by planes",
         {wall, "shadow.offset=no_depth_test", "reflection.enabled=false"},
         "shadow.own_stencil=false"},
        {"shared by lights", {two_lights, "reflection.enabled=false"}, "shadow.own_stencil=false"},
        {"shared by lights as missing light",
         {two_lights, "shadow.style=missing_light", "reflection.enabled=false"},
         "shadow.own_stencil=false"},
        {"outside the mirror", {"plane.extent=1.5"}, "reflection.stencil=false"},
        {"behind the mirror", {"plane.equation=[0,1,0,-1]"}, "reflection.clip=none"},
        {"inside out", {"cull.enabled=true"}, "reflection.flip_winding=false"},
        {"light not mirrored", {}, "reflection.reflect_light=false"},
        {"light not mirrored, camera mirrored", {"reflection.mirrored=camera"}, "reflection.reflect_light=false"},
        {"hidden by its own depth", {}, "reflection.mask_writes_depth=true"},
        {"painted over objects", {}, "reflection.after_objects=true"},
        {"seen from behind", {"plane.equation=[0,-1,0,1]"}, "reflection.side_of_eye=false"},
        {"another projection", {"reflection.mirrored=camera"}, "reflection.same_projection=false"},
        {"printed by rows", {"plane.equation=[0,1,0,0.4]"}, "reflection.printed_by_rows=true"},
        {"no shadow in the mirror",
         {wall, "plane.mirrors=false", "reflection.reflectance=0.8"},
         "reflection.shadows=false"},
        {"mirrors facing each other",
         {R"(planes=[{"equation":[0,0,1,3],"extent":3},{"equation":[0,0,-1,4],"extent":3}])", "plane.mirrors=false",
          "reflection.reflectance=0.9", "reflection.bounces=4", "camera.position=[1.5,1.8,3.6]"},
         "reflection.bounces=1"},
    };
}

/// Opposite of what the switch is by default, or another of its values.
constexpr const char* switches[] = {"shadow.enabled=false",
                                    "shadow.stencil_once=false",
                                    "shadow.clip_to_receiver=false",
                                    "shadow.clip_casters=false",
                                    "shadow.clip_at_light=false",
                                    "shadow.sign=none",
                                    "shadow.sign=forced",
                                    "shadow.offset=none",
                                    "shadow.offset=lift",
                                    "shadow.offset=no_depth_test",
                                    "shadow.style=missing_light",
                                    "shadow.write_depth=true",
                                    "shadow.own_stencil=false",
                                    "reflection.enabled=false",
                                    "reflection.stencil=false",
                                    "reflection.clip=none",
                                    "reflection.clip=oblique",
                                    "reflection.flip_winding=false",
                                    "reflection.reflect_light=false",
                                    "reflection.mirrored=camera",
                                    "reflection.same_projection=false",
                                    "reflection.printed_by_rows=true",
                                    "reflection.mask_writes_depth=true",
                                    "reflection.after_objects=true",
                                    "reflection.side_of_eye=false",
                                    "reflection.shadows=false",
                                    "reflection.reflectance=0",
                                    "reflection.reflectance=1"};

class Switches : public testing::GlTest {};

TEST_F(Switches, ChangeThePictureThatTheyBreak) {
    const Scene scene = scene_named("torus-and-boxes");
    for (const Artefact& artefact : artefacts()) {
        std::vector<std::string> settings{"view.samples=0"};
        settings.insert(settings.end(), artefact.state.begin(), artefact.state.end());
        const Image mended = draw(params_with(settings), scene, size_px);
        settings.emplace_back(artefact.broken);
        const Image broken = draw(params_with(settings), scene, size_px);
        EXPECT_GT(pixels_beyond(broken, mended, 8), 40) << artefact.name << ": " << artefact.broken;
    }
}

TEST_F(Switches, AreToldWhereTheyBreakThePicture) {
    const Scene scene = scene_named("torus-and-boxes");
    for (const Artefact& artefact : artefacts()) {
        std::vector<std::string> settings = artefact.state;
        const std::vector<Problem> without = problems_of(params_with(settings), scene, size_px);
        settings.emplace_back(artefact.broken);
        const std::vector<Problem> with = problems_of(params_with(settings), scene, size_px);
        EXPECT_TRUE(std::ranges::any_of(with, [&](const Problem& told) {
            return told.breaks_picture &&
                   std::ranges::find(without, told.sentence, &Problem::sentence) == without.end();
        })) << artefact.name;
    }
}

TEST_F(Switches, OfABusyStateAreDrawnWithoutAnError) {
    const Scene scene = scene_of({object("one", box_mesh(), {-1.0, 0.5, 0.5}), object("two", box_mesh(), {1, 1, -1})});
    for (const char* const buffers : {"view.samples=0", "depth.format=d16"}) {
        for (const char* const changed : switches) {
            const Params params = params_with(
                {buffers, changed, "reflection.bounces=2", "cull.enabled=true", R"(lights=[{"position":[1,2,1,0.4]}])",
                 R"(planes=[{"equation":[0,0,1,2.5],"extent":3},{"equation":[1,0,0.2,3],"extent":3,"gloss":true}])"});
            draw(params, scene, {48, 27});
        }
    }
}

}  // namespace
}  // namespace viewing
