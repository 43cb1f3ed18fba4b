// Tests values of STATE and --set, and the commands that print them without GL: state, params, presets and matrices.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "cli/program.h"

namespace cli_tests {
namespace {

using Json = nlohmann::json;

class State : public Program {};
class Matrices : public Program {};

TEST_F(State, AnOmittedStateEqualsAnEmptyObject) {
    const std::string state = expect(0, {"state"}).out;
    EXPECT_EQ(expect(0, {"state", "-"}, {.input = "{}"}).out, state);
    const Json json = Json::parse(state);
    Json opening = expect(0, {"state", "opening"}).json();
    for (const char* title : {"title", "about"}) EXPECT_EQ(opening.erase(title), 1U) << title;
    EXPECT_EQ(opening, json);
    EXPECT_EQ(json["version"], 1);
    EXPECT_EQ(json["projection"]["near"], 0.5);
    EXPECT_EQ(json["light"]["position"], Json::parse("[2.6, 5.2, 2.2, 1]"));
}

TEST_F(State, SettingsComeInOrderAfterTheFile) {
    write("mine.json", R"({"projection": {"near": 0.25, "far": 80}})");
    const Json json = expect(0, {"state", "mine.json", "--set", "projection.far=60", "--set", "projection.far=70",
                                 "--set=depth.func=always"})
                          .json();
    EXPECT_EQ(json["projection"]["near"], 0.25);
    EXPECT_EQ(json["projection"]["far"], 70);
    EXPECT_EQ(json["depth"]["func"], "always");
}

TEST_F(State, SettingsMayPrecedeTheState) {
    write("mine.json", R"({"projection": {"near": 0.25}})");
    EXPECT_EQ(expect(0, {"state", "--set", "camera.yaw=-12.5", "mine.json"}).out,
              expect(0, {"state", "mine.json", "--set", "camera.yaw=-12.5"}).out);
}

TEST_F(State, ItsOutputReadsBackExactly) {
    const std::string state = expect(0, {"state", "--set", "camera.position=[0.1,0.2,0.30000000000000004]", "--set",
                                         "light.position=[2,5,1,0]"})
                                  .out;
    EXPECT_EQ(state.substr(state.size() - 3), "\n}\n");
    EXPECT_EQ(expect(0, {"state", "-"}, {.input = state}).out, state);
    write("again.json", state);
    EXPECT_EQ(expect(0, {"state", "again.json"}).out, state);
}

TEST_F(State, BadInputNamesFileFieldAndNearest) {
    write("state.json", R"({"projection": {"naer": 0.1}})");
    refused({"state", "state.json"}, {"state.json: projection.naer", "did you mean projection.near?"});
    refused({"state", "missing.json"}, {"missing.json"});
    refused({"state", "openning"}, {"openning", "opening"});
    refused({"state", "-"}, {"standard input"}, {.input = "{"});
    refused({"state", "--set", "projection.near=-1"}, {"projection.near"});
    refused({"state", "--set", "projection.near=50"}, {"projection.near"});
    refused({"state", "--set", "plane.equation=[0,0,0,1]"}, {"plane.equation"});
    refused({"state", "--set", "depth.func=lss"}, {"depth.func", "less"});
    refused({"state", "--set", "scene=tea-pot"}, {"teapot"});
    refused({"state", "--set", "nonsense"}, {"nonsense", "PATH=VALUE"});
}

TEST_F(State, EveryCommandRefusesTheSameBadState) {
    const std::string bad = "projection.near=-1";
    refused({"open", "--set", bad}, {"projection.near"});
    refused({"--set", bad}, {"projection.near"});
    refused({"snapshot", "-o", "x.png", "--set", bad}, {"projection.near"});
    refused({"matrices", "--set", bad}, {"projection.near"});
    refused({"inspect", "--pixel", "1,1", "--set", bad}, {"projection.near"});
    refused({"measure", "--what", "fighting", "--set", bad}, {"projection.near"});
}

TEST_F(State, ACustomMeshReplacesTheScene) {
    write("mine.obj", tetrahedron);
    const Json by_state = expect(0, {"state", "mine.obj"}).json();
    EXPECT_EQ(by_state, expect(0, {"state", "--mesh", "mine.obj"}).json());
    EXPECT_NE(by_state.dump().find("mine.obj"), std::string::npos);
    expect(0, {"snapshot", "mine.obj", "--view", "camera", "--size", "64x64", "-o", "mesh.png"});
    expect(0, {"snapshot", "--view", "camera", "--size", "64x64", "-o", "opening.png"});
    EXPECT_NE(read("mesh.png"), read("opening.png"));
}

TEST_F(State, ABadMeshIsRefused) {
    refused({"state", "missing.obj"}, {"missing.obj"});
    write("broken.obj", "f 1 2 3\n");
    refused({"snapshot", "broken.obj", "-o", "x.png"}, {"broken.obj"});
    refused({"open", "broken.obj"}, {"broken.obj"});
    write("mine.obj", tetrahedron);
    refused({"state", "mine.obj", "--mesh", "mine.obj"}, {"--mesh"});
    refused({"state", "--mesh", "mine.stl"}, {"--mesh", "mine.stl", ".obj"});
}

TEST_F(State, SettingsAreRelativeToTheWorkingDirectoryAndStatesToTheirFile) {
    std::filesystem::create_directories(folder() / "sub");
    write("sub/t.obj", tetrahedron);
    write("sub/scene.json", R"({"objects": [{"name": "t", "shape": "mesh", "file": "t.obj"}]})");
    write("sub/named.json", R"({"scene": "scene.json"})");
    write("sub/inline.json", R"({"scene": {"objects": [{"name": "t", "shape": "mesh", "file": "t.obj"}]}})");
    const auto scene_after = [this](const std::vector<std::string>& arguments) {
        std::vector<std::string> all{"state"};
        all.insert(all.end(), arguments.begin(), arguments.end());
        return expect(0, all).json()["scene"];
    };
    EXPECT_EQ(scene_after({"--set", "scene=sub/scene.json"}), "sub/scene.json");
    EXPECT_EQ(scene_after({"sub/named.json"}), "scene.json");
    EXPECT_EQ(scene_after({"sub/named.json", "--set", "camera.yaw=1"}), "scene.json");
    EXPECT_EQ(scene_after({"sub/named.json", "--set", "scene=sub/scene.json"}), "sub/scene.json");
    EXPECT_EQ(scene_after({"teapot", "--set", "scene=letters"}), "letters");
    const Json given = scene_after({"--set", R"(scene={"objects":[{"name":"t","shape":"mesh","file":"sub/t.obj"}]})"});
    EXPECT_EQ(given["objects"][0]["file"], "sub/t.obj");
    EXPECT_EQ(scene_after({"sub/inline.json"})["objects"][0]["file"], "t.obj");
    // Only one of the two objects comes from --set; both files are found.
    const Json mixed =
        scene_after({"sub/inline.json", "--set", R"(scene.objects[1]={"name":"u","shape":"mesh","file":"sub/t.obj"})"});
    EXPECT_EQ(mixed["objects"][0]["file"], "sub/t.obj");
    EXPECT_EQ(mixed["objects"][1]["file"], "sub/t.obj");
    refused({"state", "sub/named.json", "--set", "scene=./scene.json"}, {"--set scene: ./scene.json: no such file"});
}

TEST_F(State, SceneErrorsNameTheSource) {
    write("bad.obj", "f 1 2 3\n");
    write("s.json", R"({"scene": "torus"})");
    write("i.json", R"({"scene": {"objects": [{"name": "t", "shape": "mesh", "file": "bad.obj"}]}})");
    const auto error = [this](const std::vector<std::string>& arguments) { return expect(2, arguments).err; };
    EXPECT_EQ(error({"state", "--set", "scene=torus"}).find("--set scene: torus is neither"), 0U);
    EXPECT_EQ(error({"state", "s.json"}).find("s.json: scene: torus is neither"), 0U);
    EXPECT_EQ(error({"state", "i.json"}).find("i.json: scene.objects[0].file: bad.obj"), 0U);
    EXPECT_EQ(error({"state", "--mesh", "bad.obj"}).find("--mesh: " + (folder() / "bad.obj").string()), 0U);
    EXPECT_EQ(error({"state", "bad.obj"}).find("STATE: " + (folder() / "bad.obj").string()), 0U);
}

TEST_F(State, ASceneFileIsNotAStateAndSaysHowToUseIt) {
    write("scene.json", R"({"title": "A scene", "objects": []})");
    refused({"state", "scene.json"}, {"scene.json: objects", "this is a scene: use --set scene=scene.json"});
    refused({"state", "-"}, {"use --set scene=FILE.json"}, {.input = R"({"objects": []})"});
}

TEST_F(State, AMisspelledPresetSuggestsTheNearest) {
    const std::string error = expect(2, {"state", "teapto"}).err;
    EXPECT_NE(error.find("teapto: neither a file nor a preset (viewing-sandbox presets lists them); did you mean "
                         "teapot?"),
              std::string::npos)
        << error;
    EXPECT_EQ(error.find("walkthrough"), std::string::npos) << error;
}

TEST_F(State, RangesAreWrittenInOneNotation) {
    const std::string text = expect(0, {"params", "--format", "text"}).out;
    EXPECT_EQ(text.find("0.00001"), std::string::npos);
    EXPECT_NE(text.find("1e-5 to 1e9"), std::string::npos);
    EXPECT_NE(text.find("-1e6 to 1e6"), std::string::npos);
}

TEST_F(State, ParamsListEveryFieldOfAState) {
    const Json listed = expect(0, {"params", "--format", "json"}).json();
    ASSERT_TRUE(listed.is_array());
    const Json state = expect(0, {"state"}).json();
    for (const Json& field : listed) {
        std::string pointer = "/" + field.at("path").get<std::string>();
        std::ranges::replace(pointer, '.', '/');
        EXPECT_TRUE(state.contains(Json::json_pointer(pointer))) << pointer;
        EXPECT_TRUE(field.contains("type") && field.contains("default")) << field;
    }
    EXPECT_GT(listed.size(), 60U);
    const std::string text = expect(0, {"params", "--format", "text"}).out;
    EXPECT_NE(text.find("projection.near"), std::string::npos);
}

TEST_F(State, PresetsAreListedOnePerLine) {
    const std::string lines = expect(0, {"presets"}).out;
    EXPECT_EQ(lines.find("opening — "), 0U) << lines;
    EXPECT_NE(lines.find("\nteapot (scene) — "), std::string::npos) << lines;
    const Json listed = expect(0, {"presets", "--json"}).json();
    std::string again;
    for (const Json& file : listed) {
        EXPECT_TRUE(file["kind"] == "preset" || file["kind"] == "scene") << file;
        again += file["name"].get<std::string>() + (file["kind"] == "scene" ? " (scene)" : "") + " — " +
                 file["title"].get<std::string>();
        const std::string about = file["about"];
        again += (about.empty() ? "" : ": " + about) + "\n";
        EXPECT_TRUE(file["group"].is_string()) << file;
    }
    EXPECT_EQ(again, lines);
    refused({"presets"}, {"assets", "VIEWING_SANDBOX_ASSETS"},
            {.environment = {{"VIEWING_SANDBOX_ASSETS", "/nowhere"}}});
}

/// Multiplies a matrix, given by its rows, by a column vector.
std::vector<double> times(const Json& rows, const std::vector<double>& column) {
    std::vector<double> result;
    for (const Json& row : rows) {
        double sum = 0.0;
        for (std::size_t i = 0; i < 4; ++i) sum += row[i].get<double>() * column[i];
        result.push_back(sum);
    }
    return result;
}

void expect_point(const Json& rows, const std::vector<double>& from, const std::vector<double>& to) {
    std::vector<double> found = times(rows, from);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(found[i] / found[3], to[i], 1e-6) << rows;
}

TEST_F(Matrices, HaveTheDocumentedFields) {
    const Json json = expect(0, {"matrices"}).json();
    for (const char* name : {"world_from_view", "view_from_world", "clip_from_view", "clip_from_world",
                             "shadow_from_world", "mirror_from_world"}) {
        ASSERT_EQ(json.at(name).size(), 4U) << name;
        for (const Json& row : json.at(name)) EXPECT_EQ(row.size(), 4U) << name;
    }
    EXPECT_EQ(json.at("shadow_sign"), 1);
    EXPECT_NEAR(json.at("facts").at("plane_dot_light").get<double>(), 5.2, 1e-12);
    EXPECT_NEAR(json.at("facts").at("det_mirror").get<double>(), -1.0, 1e-12);
    EXPECT_EQ(json.at("facts").at("rank_shadow"), 3);
    // Δz = z² (f−n) / (f n (2²⁴ − 1)) at the eye depth z of the target.
    const double z = -times(json.at("view_from_world"), {0.0, 0.75, 0.0, 1.0})[2];
    const double step = z * z * (40.0 - 0.5) / (40.0 * 0.5 * 16777215.0);
    EXPECT_NEAR(json.at("facts").at("depth_step_at_target").get<double>() / step, 1.0, 1e-9);
    EXPECT_EQ(json.at("problems"), Json::array());
    EXPECT_EQ(json.at("problem_details"), Json::array());
}

TEST_F(Matrices, ProblemsHaveIdsAndValues) {
    const Json json = expect(0, {"matrices", "--set", "light.position=[4,9,2,-0.0]", "--set", "projection.near=30",
                                 "--set", "projection.aspect=0.5", "--set", "slips.camera_as_view=true"})
                          .json();
    std::set<std::string> ids;
    ASSERT_EQ(json["problem_details"].size(), json["problems"].size());
    for (std::size_t i = 0; i < json["problems"].size(); ++i) {
        const Json& one = json["problem_details"][i];
        EXPECT_EQ(one["say"], json["problems"][i]);
        EXPECT_TRUE(std::set<std::string>({"wrong", "note", "window"}).contains(one["kind"])) << one;
        ids.insert(one["id"]);
        if (one["id"] == "projection.other_aspect") {
            EXPECT_EQ(one["kind"], "wrong");
            EXPECT_EQ(one["values"]["aspect"], 0.5);
            EXPECT_EQ(one["fix"], "projection.aspect=0.0");
        }
        if (one["id"] == "camera.camera_as_view") {
            EXPECT_TRUE(one["values"].empty()) << one;
            EXPECT_EQ(one["fix"], "slips.camera_as_view=false");
        }
    }
    EXPECT_TRUE(ids.contains("projection.other_aspect")) << json["problem_details"];
    EXPECT_TRUE(ids.contains("camera.camera_as_view"));
}

TEST_F(Matrices, AreRowsOfTheMathematicalMatrix) {
    const Json json = expect(0, {"matrices"}).json();
    const std::vector<double> eye{3.9, 3.0, 6.6, 1.0};
    for (std::size_t row = 0; row < 3; ++row)
        EXPECT_NEAR(json["world_from_view"][row][3].get<double>(), eye[row], 1e-12);
    const std::vector<double> origin = times(json["view_from_world"], eye);
    for (std::size_t row = 0; row < 3; ++row) EXPECT_NEAR(origin[row], 0.0, 1e-12);
    EXPECT_EQ(json["clip_from_view"][3], Json::parse("[0.0, 0.0, -1.0, 0.0]"));
}

TEST_F(Matrices, HaveTheAspectOfTheSize) {
    const Json wide = expect(0, {"matrices", "--size", "400x200"}).json()["clip_from_view"];
    EXPECT_NEAR(wide[1][1].get<double>() / wide[0][0].get<double>(), 2.0, 1e-12);
}

TEST_F(Matrices, MatchWorkedShadowExamples) {
    expect_point(expect(0, {"matrices", "--set", "light.position=[12,20,0,0]"}).json()["shadow_from_world"],
                 {0, 10, 0, 1}, {-6, 0, 0});
    expect_point(expect(0, {"matrices", "--set", "light.position=[12,20,0,1]"}).json()["shadow_from_world"],
                 {0, 10, 0, 1}, {-12, 0, 0});
    // The plane with unit normal (1,1,1)/√3 and d = −2. It is written with a normal of length √3, so d becomes −2√3.
    const std::vector<std::string> tilted{"matrices", "--set", "plane.equation=[1,1,1,-3.4641016151377544]", "--set",
                                          "light.position=[5,9,7,1]"};
    expect_point(expect(0, tilted).json()["shadow_from_world"], {1, 2, 3, 1}, {0.323760, 0.816581, 2.323760});
    expect_point(expect(0, tilted).json()["mirror_from_world"], {1, 2, 3, 1}, {-0.690599, 0.309401, 1.309401});
}

// S p = (Π·L) p − (Π·p) L with Π = (0, 1, 0, 0), before the division by w.
TEST_F(Matrices, IncludeTheFollowedPointBeforeAndAfterTheDivision) {
    const Json followed =
        expect(0, {"matrices", "--set", "light.position=[2,5,1,1]", "--set", R"(follow={"object":"box","vertex":0})"})
            .json()
            .at("followed");
    const auto p = followed.at("point").get<std::vector<double>>();
    const auto before = followed.at("shadow_homogeneous").get<std::vector<double>>();
    const std::vector<double> light{2, 5, 1, 1};
    ASSERT_EQ(before.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(before[i], 5.0 * (i < 3 ? p[i] : 1.0) - p[1] * light[i], 1e-9);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(followed.at("shadow")[i].get<double>(), before[i] / before[3], 1e-9);
}

TEST_F(Matrices, AFlippedPlaneHasTheOtherSign) {
    const Json json = expect(0, {"matrices", "--set", "plane.equation=[0,-1,0,0]"}).json();
    EXPECT_EQ(json["shadow_sign"], -1);
    EXPECT_NEAR(json["facts"]["plane_dot_light"].get<double>(), -5.2, 1e-12);
}

TEST_F(Matrices, CoverEveryPlaneAndLight) {
    const Json json = expect(0, {"matrices", "--set", "planes=[{\"equation\":[0,0,2,6]}]", "--set",
                                 "lights=[{\"position\":[1,4,2,1]}]"})
                          .json();
    ASSERT_EQ(json.at("planes").size(), 2U);
    EXPECT_EQ(json["planes"][0]["mirror_from_world"], json["mirror_from_world"]);
    EXPECT_EQ(json["planes"][0]["shadows"][0]["shadow_from_world"], json["shadow_from_world"]);
    const Json& wall = json["planes"][1];  // z + 3 = 0
    expect_point(wall["mirror_from_world"], {1, 2, 3, 1}, {1, 2, -9, 1});
    ASSERT_EQ(wall["shadows"].size(), 2U);
    // The ray from (1, 4, 2) through (1, 3, 1) meets z = −3 four units farther in z.
    expect_point(wall["shadows"][1]["shadow_from_world"], {1, 3, 1, 1}, {1, -1, -3});
    EXPECT_EQ(wall["shadows"][1]["shadow_sign"], 1);
}

TEST_F(Matrices, ALightInThePlaneIsAProblemNotAnError) {
    const Json json = expect(0, {"matrices", "--set", "light.position=[3,0,1,1]"}).json();
    ASSERT_FALSE(json["problems"].empty());
    EXPECT_TRUE(json["problems"][0].is_string());
    EXPECT_EQ(json["facts"]["rank_shadow"], 1);
}

TEST_F(Matrices, EveryFormatHasEveryMatrix) {
    const std::map<std::string, std::string> signs{{"text", "shadow_from_world =\n"},
                                                   {"latex", "\\begin{bmatrix}"},
                                                   {"glm", "const glm::dmat4 shadow_from_world("},
                                                   {"glsl", "const mat4 shadow_from_world = mat4("},
                                                   {"numpy", "shadow_from_world = np.array([["},
                                                   {"matlab", "shadow_from_world = ["}};
    for (const auto& [format, sign] : signs) {
        const std::string text = expect(0, {"matrices", "--format", format}).out;
        EXPECT_NE(text.find(sign), std::string::npos) << text;
        EXPECT_NE(text.find("mirror"), std::string::npos) << text;
    }
}

TEST_F(Matrices, NeedNoGl) {
    expect(0, {"matrices"}, {.environment = {{"__EGL_VENDOR_LIBRARY_FILENAMES", "/nowhere.json"}}});
}

TEST_F(Matrices, ContainNoNegativeZero) {
    EXPECT_EQ(expect(0, {"matrices"}).out.find("-0.0,"), std::string::npos);
    EXPECT_EQ(expect(0, {"matrices"}).out.find("-0,"), std::string::npos);
}

TEST_F(State, ALinkWorksWhereverAStateWorks) {
    std::string link = expect(0, {"state", "room", "--set", "shadow.opacity=0.125", "--link"}).out;
    ASSERT_TRUE(link.starts_with("viewing-sandbox.html#1")) << link;
    ASSERT_TRUE(link.ends_with("\n"));
    link.pop_back();
    nlohmann::json whole = expect(0, {"state", "room", "--set", "shadow.opacity=0.125"}).json();
    for (const char* title : {"title", "about", "group", "slides"}) whole.erase(title);
    EXPECT_EQ(expect(0, {"state", link}).json(), whole);
    const std::string bare = link.substr(link.find('#'));
    expect(0, {"snapshot", bare, "--view", "camera", "--size", "64x36", "-o", "a.png"});
    expect(0,
           {"snapshot", "room", "--set", "shadow.opacity=0.125", "--view", "camera", "--size", "64x36", "-o", "b.png"});
    EXPECT_EQ(read("a.png"), read("b.png"));
    EXPECT_EQ(expect(0, {"state", "room", "--set", "shadow.opacity=0.125", "--link", "--base", "https://a.b/c"}).out,
              "https://a.b/c" + bare + "\n");
    Surroundings elsewhere;
    elsewhere.environment["VIEWING_SANDBOX_LINK_BASE"] = "https://d.e/";
    EXPECT_EQ(expect(0, {"state", bare, "--link"}, elsewhere).out, "https://d.e/" + bare + "\n");
    refused({"state", "--base", "x"}, {"--base", "--link"});
    refused({"state", "--link", "--base", "a#b"}, {"--base", "#"});
    refused({"state", "--link", "--bundle", "folder"}, {"--bundle", "--link"});
    refused({"snapshot", bare.substr(0, 40), "-o", "c.png"}, {"link", "cut off"});
}

TEST_F(State, ALinkMayComeThroughStandardInput) {
    Surroundings piped;
    piped.input = "viewing-sandbox.html#preset=room\n";
    nlohmann::json room = expect(0, {"state", "room"}).json(), read_back = expect(0, {"state", "-"}, piped).json();
    EXPECT_EQ(read_back, room);
    piped.input = "#lesson=depth-fighting&step=2\n";
    EXPECT_EQ(expect(0, {"state", "-"}, piped).out,
              expect(0, {"state", "--lesson", "depth-fighting", "--step", "2"}).out);
    piped.input = "#preset=roon";
    EXPECT_NE(run({"state", "-"}, piped).err.find("no such preset"), std::string::npos);
}

TEST_F(State, ALessonLinkOpensItsStepWhereverAStateWorks) {
    const std::string link = "https://a.b/c#lesson=depth-fighting&step=2";
    EXPECT_EQ(
        expect(0, {"state", "--lesson", "depth-fighting", "--step", "2", "--link", "--base", "https://a.b/c"}).out,
        link + "\n");
    for (const auto& how : {std::vector<std::string>{}, {"--present"}, {"--revealed", "--set", "ui.theme=light"}}) {
        std::vector<std::string> linked{"snapshot", link, "--size", "640x360", "-o", "a.png"},
            named{"snapshot", "--lesson", "depth-fighting", "--step", "2", "--size", "640x360", "-o", "b.png"};
        linked.insert(linked.end(), how.begin(), how.end());
        named.insert(named.end(), how.begin(), how.end());
        expect(0, linked);
        expect(0, named);
        EXPECT_EQ(read("a.png"), read("b.png"));
    }
    EXPECT_NE(expect(0, {"state", link}).out, expect(0, {"state", "#lesson=depth-fighting"}).out);
    EXPECT_EQ(expect(0, {"state", link, "--set", "shadow.opacity=0.125"}).json()["shadow"]["opacity"], 0.125);
    refused({"snapshot", link, "--step", "3", "-o", "c.png"}, {"already links to a lesson's step"});
    refused({"snapshot", link, "--set", "projection.near=1", "-o", "c.png"}, {"a step has its own state"});
    refused({"open", link, "--set", "projection.near=1"}, {"a lesson's step has its own state"});
    refused({"state", "#lesson=depth-fighting&step=99"}, {"link: step 99", "1 to"});
    refused({"state", "room", "--lesson", "depth-fighting"},
            {"--lesson", "STATE, --set, --mesh and --at are not allowed"});
    refused({"state", "--step", "2"}, {"--step needs --lesson"});
    write("own.json", expect(0, {"state"}).out);
    refused({"state", "--lesson", "own.json", "--link"}, {"own.json"});
}

TEST_F(State, NotesOnTheMeshAppearOnceAndNotWithARefusal) {
    const std::string corners = "v 0 0 0\nv 1 1 0\nv 0 1 0\nv 1 0 0\n", crossed = "f 1 2 3 4\n";
    write("crossed.obj", corners + crossed);
    const Ended sweep = run({"sweep", "crossed.obj", "--vary", "coplanar.gap=0.01:0.03:3", "-o", "frames", "--view",
                             "camera", "--size", "64x36"});
    EXPECT_EQ(sweep.status, 0) << sweep.told();
    const std::size_t first = sweep.err.find("crosses itself");
    EXPECT_NE(first, std::string::npos) << sweep.err;
    EXPECT_EQ(sweep.err.find("crosses itself", first + 1), std::string::npos) << sweep.err;
    std::string many = corners + crossed;
    for (int i = 0; i < 100'001; ++i) many += "f 1 2 3\n";
    write("many.obj", many);
    const Ended refused = run({"measure", "many.obj", "--what", "visibility", "--size", "64x36"});
    EXPECT_EQ(refused.status, 2);
    EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
    EXPECT_EQ(refused.err.find("crosses itself"), std::string::npos) << refused.err;
}

TEST_F(State, ALinkSaysThatItContainsNoFiles) {
    write("one.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const Ended ended = run({"state", "one.obj", "--link"});
    EXPECT_EQ(ended.status, 0) << ended.told();
    EXPECT_NE(ended.err.find("does not contain"), std::string::npos) << ended.err;
    std::string link = ended.out;
    link.pop_back();
    refused({"snapshot", link, "-o", "a.png"}, {"--allow-outside"});
    expect(0, {"snapshot", link, "--allow-outside", "--view", "camera", "--size", "64x36", "-o", "a.png"});
}

}  // namespace
}  // namespace cli_tests
