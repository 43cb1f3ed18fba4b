// Each sentence in the sources that reports a problem is shown by at least one state: a preset, or one of the states
// below. Each sentence that is shown contains its values and has an id, which is the same in every language.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>

#include "state/presets.h"
#include "unit/frame/frame_test.h"

namespace viewing {
namespace {

namespace fs = std::filesystem;
using testing::box_scene;
using testing::problems_of;

/// A sentence in the sources: a template with placeholders in braces.
struct Written {
    std::string id, english;

    /// Returns whether a sentence contains the fixed parts of this template, in order.
    bool fits(const std::string& sentence) const {
        std::size_t at = 0, from = 0;
        while (from < english.size()) {
            const std::size_t open = std::min(english.find('{', from), english.size());
            const std::string part = english.substr(from, open - from);
            const std::size_t found = sentence.find(part, at);
            if (found == std::string::npos) return false;
            at = found + part.size();
            from = open < english.size() ? english.find('}', open) + 1 : open;
        }
        return true;
    }
};

std::vector<Written> written_sentences() {
    const char* const tests = std::getenv("TEST_SOURCE_DIR");
    EXPECT_TRUE(tests) << "TEST_SOURCE_DIR";
    std::vector<Written> all;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(tests ? tests : ".") / ".." / "sandbox")) {
        const bool may_find_problems = entry.path().string().find("/numbers/") != std::string::npos ||
                                       entry.path().string().find("/frame/") != std::string::npos;
        if (!may_find_problems || entry.path().extension() != ".cpp") continue;
        std::stringstream text;
        text << std::ifstream(entry.path()).rdbuf();
        const std::string source = text.str();
        static const std::regex call("sentence\\(\\s*\"([a-z_0-9.]+)\",\\s*((?:\"(?:[^\"\\\\]|\\\\.)*\"\\s*)+)");
        static const std::regex literal("\"((?:[^\"\\\\]|\\\\.)*)\"");
        for (auto found = std::sregex_iterator(source.begin(), source.end(), call); found != std::sregex_iterator();
             ++found) {
            const std::string literals = (*found)[2];
            std::string english;
            for (auto part = std::sregex_iterator(literals.begin(), literals.end(), literal);
                 part != std::sregex_iterator(); ++part)
                english += (*part)[1];
            all.push_back({(*found)[1], english});
        }
    }
    return all;
}

const std::string back_wall = "planes=[{\"equation\":[0,0,1,3]}]";
const std::string leaning_wall = "planes=[{\"equation\":[0,1,1,3]}]";
const std::string two_walls = "planes=[{\"equation\":[0,0,1,3]},{\"equation\":[1,0,0,3]}]";
const std::string facing_mirrors =
    "planes=[{\"equation\":[0,0,1,8],\"receives_shadow\":false},{\"equation\":[0,0,-1,8],\"receives_shadow\":false}]";
/// The mirrors are nearly parallel: a line of sight goes back and forth between them, but not endlessly.
const std::string leaning_mirrors =
    "planes=[{\"equation\":[0,0.002,1,8],\"extent\":50},{\"equation\":[0,0.002,-1,8],\"extent\":50}]";
const std::string second_light = "lights=[{\"position\":[-3,5,2,1]}]";

std::string by_hand(const char* letter, const char* rows) {
    const bool is_projection = std::string(letter) == "clip";
    return std::string("overrides.") + letter + (is_projection ? "_from_view=" : "_from_world=") + rows;
}

/// Settings that, with the box on the floor, show sentences that no preset shows.
const std::vector<std::vector<std::string>>& box_states() {
    static const std::vector<std::vector<std::string>> all = {
        {"cull.enabled=true", "cull.face=front_and_back"},
        {"depth.func=notequal"},
        {"depth.func=always", "depth.write=false"},
        {"depth.func=never"},
        {"depth.func=greater"},
        {"depth.func=equal"},
        {"depth.func=greater", "depth.clear_value=0"},
        {"depth.clear_value=0"},
        {"depth.clear_value=0.94"},
        {"depth.mapping=logarithmic"},
        {"depth.mapping=logarithmic", "depth.logarithm_per_vertex=true", "reflection.clip=oblique", leaning_wall},
        {"depth.func=gequal"},
        {"depth.mapping=reversed", "depth.reversed_offset=false", "shadow.offset_factor=0.5"},
        {"shadow.offset_factor=0"},
        {"view.call=1"},
        {"depth.format=d16", "view.samples=4"},
        // S and R by hand. The right ones are [[5.2,-2.6,0,0],[0,0,0,0],[0,-2.2,5.2,0],[0,-1,0,5.2]] and y → −y.
        {by_hand("shadow", "[[1,0,0,0],[0,-1,0,1],[0,0,1,0],[0,0,0,1]]")},
        {by_hand("mirror", "[[5.2,-2.6,0,0],[0,0,0,0],[0,-2.2,5.2,0],[0,-1,0,5.2]]")},
        {by_hand("shadow", "[[5.2,0,0,0],[-2.6,0,-2.2,-1],[0,0,5.2,0],[0,0,0,5.2]]")},
        {by_hand("shadow", "[[5,-1,0,0],[0,0,0,0],[0,-2,5,0],[0,-1,0,5]]")},
        {by_hand("shadow", "[[1,0,0,0],[0,0,0,0.5],[0,0,1,0],[0,0,0,1]]")},
        {by_hand("shadow", "[[4.7,-2.6,0,1.3],[0,-0.5,0,2.6],[0,-2.2,4.7,1.1],[0,-1,0,5.2]]")},
        {by_hand("shadow", "[[1,0,0,0],[0,0.5,0,0],[0,0,1,0],[0,0,0,1]]")},
        {by_hand("shadow", "[[-5.2,2.6,0,0],[0,0,0,0],[0,2.2,-5.2,0],[0,1,0,-5.2]]")},
        {by_hand("shadow", "[[1,0,0,0],[0,0,0,0],[0,0,1,0],[0,0,0,1]]"), "plane.equation=[0,-1,0,0]"},
        {by_hand("shadow", "[[5.2,-2.6,0,1],[0,0,0,0],[0,-2.2,5.2,0],[0,-1,0,5.2]]")},
        {by_hand("shadow", "[[5.7,-2.6,0,-1.3],[0,0,0,0],[0,-2.2,5.2,0],[0,-1,0,5.2]]")},
        {by_hand("mirror", "[[-1,0,0,0],[0,1,0,0],[0,0,-1,0],[0,0,0,-1]]")},
        {by_hand("mirror", "[[1,0,0,0],[0,-1,0,0],[0,0,1,0],[0,-1,0,1]]"), "plane.equation=[0,1,0,0.5]"},
        {by_hand("mirror", "[[1,0,0,0],[0,-1,0,0],[0,0,1,0],[0,1,0,1]]")},
        {by_hand("mirror", "[[1,0,0,0],[0,-1,0,1],[0,0,1,0],[0,0,0,1]]")},
        {by_hand("mirror", "[[1,0,0,0],[0,-7,0,0],[0,0,1,0],[0,0,0,1]]"), "plane.equation=[0,2,0,0]"},
        {by_hand("mirror", "[[0.28,-0.96,0,0],[0.96,-0.28,0,0],[0,0,1,0],[0,0,0,1]]"), "plane.equation=[0.6,0.8,0,0]"},
        {by_hand("mirror", "[[1,0,0,0],[0.3,-1,0,1],[0,0,1,0],[0,0,0,1]]")},
        {by_hand("mirror", "[[1,0.2,0,0],[0,-1,0,0],[0,0,1,0],[0,0,0,1]]")},
        {by_hand("view", "[[1,0,0,0],[0,1,0,-1],[0,0,1,-8],[0,0,0,1]]")},
        {by_hand("view", "[[1,0,0,0],[0,1,0,-1],[0,0,1,-8],[0,0,0,2]]")},
        {by_hand("view", "[[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,-1,-8,1]]")},
        {by_hand("view", "[[1,0.4,0,0],[0,1,0,-1],[0.1,0,0.3,-8],[0,0,0,1]]")},
        {by_hand("view", "[[1,0.4,0,0],[0,1,0,-1],[0.1,0,0.3,-8],[0,0.1,0,1]]")},
        {by_hand("view", "[[2,0,0,0],[0,2,0,-1],[0,0,2,-8],[0,0,0,1]]")},
        {by_hand("view", "[[1.5,0,0,0],[0,2.7,0,0],[0,0,-1.025,-1.0127],[0,0,-1,0]]")},
        {by_hand("clip", "[[1,0,0,0],[0,0,0,0],[0,0,-1,-1],[0,0,-1,0]]")},
        {by_hand("clip", "[[1,0,0,0],[0,1.8,0,0],[0,0,-1.02,-0.5],[0,0,-1,0]]")},
        {by_hand("clip", "[[0.2,0,0,0],[0,0.4,0,0],[0,0,-0.05,-1.01],[0,0,0,1]]")},
        {by_hand("clip", "[[1,0,0.3,0],[0,1.8,0,0],[0.2,0,-1.02,-0.5],[0.1,0,-1,0]]")},
        {"light.position=[3,0,-2,0]"},
        {"light.position=[3,0,-2,1]"},
        {"light.position=[1,-2,0.5,0]"},
        {"lights=[{\"position\":[-3,-5,2,1]}]"},
        {"lights=[{\"position\":[1,5,-2,0.5]}]"},
        {"light.position=[1,5,-2,0.5]", "shadow.enabled=false"},
        {"projection.type=orthographic", "camera.pitch=0"},
        {"camera.position=[0,-3,8]", "camera.yaw=0", "camera.pitch=20"},
        {"camera.position=[0,0,8]"},
        {back_wall, "visibility.method=bsp"},
        {"projection={\"type\":\"frustum\",\"left\":-1,\"right\":1,\"bottom\":-1,\"top\":1}"},
        {"slips.degrees_as_radians=true", "projection.fovy=45"},
        {"slips.degrees_as_radians=true", "projection.fovy=10"},
        {"projection.aspect=0.5"},
        {"slips.creeping_roll=true", "camera.navigation=walk"},
        {"slips.pole_flip=true", "camera.navigation=orbit"},
        {"follow={\"object\":\"nobody\",\"vertex\":0}"},
        {facing_mirrors, "reflection.bounces=6", "reflection.stencil=false"},
        {facing_mirrors, "reflection.bounces=16"},
        {back_wall},
        {two_walls, "reflection.bounces=2"},
        {leaning_mirrors},
        {leaning_mirrors, "reflection.bounces=2"},
        {"shadow.sign=none", "planes=[{\"equation\":[0,0,-1,-3]}]"},
        {"shadow.clip_at_light=false", "light.position=[2.6,1,2.2,1]"},
        {"shadow.offset_factor=1", "shadow.offset_units=1"},
        {"slips.shadow_by_rows=true"},
        {"slips.shadow_by_rows=true", "light.position=[0,4,0,1]", "plane.equation=[0,0,1,3]"},
        {"shadow.own_stencil=false", back_wall, second_light, "depth.test=false"},
        {"reflection.clip=oblique"},
        {"reflection.clip=oblique", "projection.near=1", "projection.far=15", "depth.format=d32f",
         "plane.equation=[0.3,0,0.5,0]"},
        {"reflection.fovy=20"},
        {"reflection.clip=none", leaning_wall},
        {"reflection.after_objects=true", "reflection.stencil=false", "plane.equation=[0,0,1,-2]"},
        {"reflection.clip=oblique", "reflection.side_of_eye=false", "plane.equation=[0,-1,0,0]"},
        {"reflection.clip=none", "reflection.stencil=false", "plane.equation=[0,1,0,-1]"},
        {"reflection.stencil=false", back_wall},
        {"reflection.stencil=false", "reflection.clip=oblique"},
        {"reflection.stencil=false", "depth.format=d10"},
        {"shadow.own_stencil=false", back_wall},
        {"reflection.clip=oblique", "slips.oblique_in_world=true"},
        {"reflection.flip_winding=false", "view.shows=facing"},
        {"camera.yaw=-149.4"},
        {"camera.yaw=100"},
        {"camera.yaw=-40"},
        {"camera.pitch=60"},
        {"camera.pitch=-80"},
        {"camera.yaw=-60", "camera.pitch=60"},
        {"projection.near=8"},
        {"camera.position=[0,2,0]", "camera.yaw=0", "camera.pitch=0"},
        {"projection.far=8"},
        {"projection.far=12", "plane.equation=[0,0,1,3]", "camera.position=[0,1,6]", "camera.yaw=0", "camera.pitch=0"},
        {"projection.near=30"},
        {"projection.far=2"},
    };
    return all;
}

/// Returns a scene with a mesh, as if from a file: a thin sliver, or vertices at one point and one stray vertex.
Scene mesh_state(bool is_thin) {
    Mesh mesh;
    for (int i = 0; i < 300; ++i)
        mesh.positions.emplace_back(is_thin ? static_cast<float>(i) / 150.0F - 1.0F : 0.0F,
                                    is_thin ? 1.0F + 1e-5F * static_cast<float>(i % 3) : 1.0F, 0.0F);
    if (!is_thin) mesh.positions.back().x = 1.0F;
    mesh.normals.assign(mesh.positions.size(), {0, 0, 1});
    for (std::uint32_t i = 0; i < mesh.positions.size(); ++i) mesh.indices.push_back(i);
    SceneObject made = testing::object("scan", std::move(mesh), {0, 0, 0});
    made.description.shape = ShapeKind::mesh;
    return testing::scene_of({made});
}

/// Adds the problems of states that need another scene or another driver.
void add_others(std::vector<Problem>& shown) {
    const auto add = [&](const std::vector<std::string>& settings, const Scene& scene, const Viewport& viewport) {
        for (Problem& problem : problems_of(testing::params_with(settings), scene, viewport))
            shown.push_back(std::move(problem));
    };
    const Viewport usual{{480, 270}};
    Viewport without = usual;
    without.clip_control = false;
    add({"depth.mapping=reversed", "depth.format=d32f"}, box_scene(), without);
    add({"reflection.after_objects=true", back_wall}, testing::scene_of({}), usual);
    for (const DepthPrecision& stored : {DepthPrecision{32, true}, DepthPrecision{16, false}}) {
        Viewport other = usual;
        other.stored_depth = StoredDepth{stored, std::nullopt};
        add({}, box_scene(), other);
    }
    add({"cull.enabled=true"}, testing::scene_of({testing::object("twin", box_mesh(), {0, 1, 0}, {-1, 1, 1})}), usual);
    for (const double gap : {0.0, 1e-7})
        add({},
            testing::scene_of({testing::object("red", quad_mesh(), {0, 1, 0}),
                               testing::object("blue", quad_mesh(), {0, 1 + gap, 0})}),
            usual);
    add({}, testing::scene_of({testing::object("sheet", box_mesh(), {0, 0, 0}, {1, 0, 1})}), usual);
    Viewport measured = usual;
    measured.stored_depth = StoredDepth{DepthPrecision{24, false}, 2.0};
    SceneObject poster = testing::object("poster", quad_mesh(), {0, 1, 0});
    poster.description.decal = true;
    add({"depth.offset.units=-0.25"}, testing::scene_of({testing::object("wall", quad_mesh(), {0, 1, 0}), poster}),
        measured);
    SceneObject decal = testing::object("decal", quad_mesh(), {0, 1, 0});
    decal.description.decal = true;
    add({"depth.decals=stencil"}, testing::scene_of({decal}), usual);
    add({"camera.yaw=0", "camera.pitch=0", "camera.position=[0,1,0]"},
        testing::scene_of(
            {testing::object("left", box_mesh(), {-9, 1, -3}), testing::object("right", box_mesh(), {9, 1, -3})}),
        usual);
    add({}, mesh_state(true), usual);
    add({}, mesh_state(false), usual);
    add({"projection.near=7", "projection.far=8"},
        testing::scene_of({testing::object("a", box_mesh(), {3.4, 2.6, 5.4}, glm::dvec3(0.1)),
                           testing::object("b", box_mesh(), {0, 0.8, -1}, glm::dvec3(0.1))}),
        usual);
}

TEST(ProblemSentences, EachIsShownBySomeState) {
    const std::vector<Written> written = written_sentences();
    ASSERT_GT(written.size(), 100U);
    std::vector<Problem> shown;
    const auto add = [&](const Params& params, const Scene& scene) {
        for (Problem& problem : problems_of(params, scene, {{480, 270}})) shown.push_back(std::move(problem));
    };
    for (const NamedFile& preset : presets()) {
        const auto [params, scene] = testing::preset_named(preset.name);
        add(params, scene);
    }
    for (const std::vector<std::string>& settings : box_states()) add(testing::params_with(settings), box_scene());
    add_others(shown);
    for (const Written& each : written)
        EXPECT_TRUE(std::any_of(
            shown.begin(), shown.end(),
            [&](const Problem& problem) { return problem.id == each.id && each.fits(say(problem.sentence)); }))
            << each.id << ": " << each.english;
    for (const Problem& problem : shown) {
        EXPECT_FALSE(problem.id.empty()) << say(problem.sentence);
        for (const auto& [name, text] : problem.sentence.said_values())
            EXPECT_NE(say(problem.sentence).find(text), std::string::npos)
                << problem.id << " " << name << " = " << text;
    }
}

}  // namespace
}  // namespace viewing
