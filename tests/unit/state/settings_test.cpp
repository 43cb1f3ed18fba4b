// Settings given as --set PATH=VALUE: their order, paths and values, and the errors of invalid ones.
#include <gtest/gtest.h>

#include "state/file/state_json.h"

namespace viewing {
namespace {

using Settings = std::vector<std::string>;

Params set(const Settings& settings, const Params& start = {}) {
    const Result<Params> params = apply_settings(start, settings);
    EXPECT_TRUE(params) << params.error();
    return params ? *params : Params{};
}

std::string refusal(const Settings& settings) {
    const Result<Params> params = apply_settings({}, settings);
    EXPECT_FALSE(params) << settings.back();
    return params ? "" : params.error();
}

TEST(Settings, EmptyListChangesNothing) {
    EXPECT_EQ(set({}), Params{});
}

TEST(Settings, ExamplesOfTheContract) {
    const Params params = set({"projection.near=0.01", "light.position=[2,5,1,0]", "depth.func=always"});
    EXPECT_EQ(params.projection.near, 0.01);
    EXPECT_EQ(params.lights.front().position, glm::dvec4(2, 5, 1, 0));
    EXPECT_EQ(params.depth.func, CompareFunc::always);
}

TEST(Settings, ApplyInOrder) {
    EXPECT_EQ(set({"camera.yaw=1", "camera.yaw=2"}).camera.yaw, 2.0);
    EXPECT_EQ(set({"light.position[0]=7", "light.position=[1,2,3,1]"}).lights.front().position.x, 1.0);
    EXPECT_EQ(set({"light.position=[1,2,3,1]", "light.position[0]=7"}).lights.front().position, glm::dvec4(7, 2, 3, 1));
}

TEST(Settings, GroupsChangeOnlyTheirNamedFields) {
    const Params params = set({R"(camera={"yaw": 3, "navigation": "orbit"})", R"(depth={"offset": {"units": 2}})"});
    EXPECT_EQ(params.camera.yaw, 3.0);
    EXPECT_EQ(params.camera.pitch, -16.4);
    EXPECT_EQ(params.camera.navigation, Navigation::orbit);
    EXPECT_EQ(params.depth.offset.units, 2.0);
    EXPECT_EQ(params.depth.offset.factor, 0.0);
}

TEST(Settings, ValueIsJsonOrElseText) {
    EXPECT_EQ(set({"ui.theme=light"}).ui.theme, Theme::light);
    EXPECT_EQ(set({"ui.theme=\"light\""}).ui.theme, Theme::light);
    EXPECT_EQ(std::get<std::string>(set({"scene=folder/my scene=2.json"}).scene), "folder/my scene=2.json");
    EXPECT_EQ(set({"shadow.color=#102030"}).shadow.color, (Color{16, 32, 48}));
    EXPECT_FALSE(set({"follow=null"}).follow);
}

TEST(Settings, ReachIntoValues) {
    EXPECT_EQ(set({"follow.object=box"}).follow, (Follow{"box", 0}));
    EXPECT_EQ(set({R"(follow={"object":"box"})", "follow.vertex=5"}).follow, (Follow{"box", 5}));
    EXPECT_EQ(set({"lights[0].position=[1,2,3,1]", "lights[0].position[3]=0"}).lights.at(1).position,
              glm::dvec4(1, 2, 3, 0));
    EXPECT_EQ(set({"planes[0].extent=2", "planes[1].mirrors=false"}).planes.size(), 3U);
    Params with_scene;
    with_scene.scene = *parse_scene(R"({"objects": [{"name": "a", "shape": "box"}]})", "s");
    const Params moved = set({"scene.objects[0].position[1]=2.5"}, with_scene);
    EXPECT_EQ(std::get<SceneDescription>(moved.scene).objects[0].position.y, 2.5);
    Params with_matrix;
    with_matrix.overrides[0].shadowed_world_from_world[0] = glm::dmat4(1.0);
    EXPECT_EQ(
        (*set({"overrides.shadow_from_world[0][3]=9"}, with_matrix).overrides[0].shadowed_world_from_world[0])[3][0],
        9.0);
}

TEST(Settings, RelationsBetweenFieldsAreCheckedAtTheEnd) {
    const Params params =
        set({"projection.near=50", "projection.far=100", "plane.equation[1]=0", "plane.equation[2]=1"});
    EXPECT_EQ(params.projection.near, 50.0);
    EXPECT_EQ(params.planes.front().equation, glm::dvec4(0, 0, 1, 0));
    EXPECT_EQ(refusal({"projection.near=50"}), "--set projection.near: must be less than projection.far (40), got 50");
    EXPECT_EQ(refusal({"plane.equation[1]=0"}), "--set plane.equation: the normal (a, b, c) must not be zero");
    EXPECT_NE(refusal({"light.position=[0,0,0,0]"}).find("--set light.position: must not be zero"), std::string::npos);
}

TEST(Settings, AreRefusedWithAReason) {
    const std::pair<std::string, std::string> cases[] = {
        {"projection.near", "--set projection.near: must be PATH=VALUE"},
        {"=3", "--set =3: must be PATH=VALUE"},
        {"", "--set : must be PATH=VALUE"},
        {"projection.naer=1", "--set projection.naer: no such field; did you mean projection.near?"},
        {"near=1", "--set near: no such field; did you mean projection.near?"},
        {"projection.near=abc", "--set projection.near: must be a number from -1e6 to 1e6, got the string \"abc\""},
        {"projection.near=", "--set projection.near: must be a number from -1e6 to 1e6, got the string \"\""},
        {"projection.near=NaN", "got the string \"NaN\""},
        {"projection.near=1e999", "--set projection.near: the number 1e999 is too large"},
        {"projection.near=-1", "--set projection.near: must be a number from 1e-6"},
        {"projection=3", "--set projection: must be an object, got the number 3"},
        {"camera={\"yaw\":1,\"yaw\":2}", "--set camera: yaw: appears twice"},
        {"camera={\"jaw\":1}", "--set camera.jaw: no such field; did you mean camera.yaw?"},
        {"light.position[4]=1", "--set light.position: must be four numbers"},
        {"light.position[9]=1", "--set light.position[9]: no such element: the length of the array is 4"},
        {"light.position[x]=1", "--set light.position: \"[x]\" is not an index"},
        {"light.position[=1", "is not an index"},
        {"light.position[99999999999]=1", "is not an index"},
        {"light.position[0]x=1", "must not be followed by \"x\""},
        {"light.position.x=1", "--set light.position: has no fields: it is an array of length 4"},
        {"camera.yaw[0]=1", "--set camera.yaw: has no elements: it is the number 30.6"},
        {"scene.objects[0]=1", "--set scene: has no fields: it is the string \"torus-and-boxes\""},
        {"lights[0].colour=1", "--set lights[0].colour: no such field"},
        {"lights[1].position=[0,1,0,0]", "--set lights[1]: no such element: the length of the array is 0"},
        {"version=2", "--set version: must be 1"},
        {"title=x", "--set title: no such field"},
        {"scene=\xff", "--set scene: must be valid UTF-8"},
        {"follow.=1", "--set follow"},
    };
    for (const auto& [setting, expected] : cases) {
        const std::string error = refusal({"ui.scale=2", setting});
        EXPECT_NE(error.find(expected), std::string::npos) << error << "\nfor " << setting;
        EXPECT_EQ(error.rfind("--set ", 0), 0U) << error;
    }
}

}  // namespace
}  // namespace viewing
