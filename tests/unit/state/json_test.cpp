// Reading and writing state files: defaults, order, exactness, scenes, and the `params` command.
#include "state/file/state_json.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "listed_fields.h"
#include "platform/sanitized.h"
#include "random_params.h"
#include "state/file/document.h"
#include "state/file/reader.h"
#include "trials.h"

namespace viewing {
namespace {

Params read(const std::string& json) {
    Result<Params> params = parse_state(json, "test.json");
    EXPECT_TRUE(params) << params.error();
    return params ? *params : Params{};
}

TEST(JsonTest, AMissingKeyOfAConstantTreeIsRefusedInEveryBuild) {
    const Json tree = parse_document(R"({"steps": []})", "");
    const Result<bool> read = guarded([&] { return tree["parts"].is_array(); });
    ASSERT_FALSE(read);
    EXPECT_NE(read.error().find("incomplete"), std::string::npos) << read.error();
}

TEST(State, EmptyObjectIsTheDefaults) {
    EXPECT_EQ(read("{}"), Params{});
    EXPECT_EQ(read("\xEF\xBB\xBF {}\n"), Params{}) << "a byte order mark is accepted";
}

TEST(State, ReadsEveryKindOfField) {
    const Params params = read(R"({
        "version": 1, "title": "a title", "about": "about it",
        "scene": "teapot",
        "camera": {"position": [1, 2.5, -3e2], "navigation": "walk"},
        "projection": {"type": "orthographic", "near": 0.001, "far": 1e9},
        "depth": {"test": false, "func": "notequal", "format": "d16", "offset": {"units": -2}},
        "light": {"position": [1, 2, 3, 0.5]}, "lights": [{"position": [0, 1, 0, 0]}],
        "planes": [{"equation": [0, 0, 2, 1], "mirrors": false}],
        "shadow": {"color": "#0A0b0C"}, "reflection": {"bounces": 2.0},
        "overrides": {"mirror_from_world": [[1,2,3,4],[5,6,7,8],[9,10,11,12],[13,14,15,16]]},
        "follow": {"object": "box", "vertex": 3},
        "view": {"samples": 0, "pin": {"object": "torus", "at": [0.25, 1]},
                 "layout": {"big": "lower_left", "matrices": ["display", "V"],
                            "controls": ["camera", "projection.near"], "folded": ["panel"]}}
    })");
    EXPECT_EQ(std::get<std::string>(params.scene), "teapot");
    EXPECT_EQ(params.camera.position, glm::dvec3(1, 2.5, -300));
    EXPECT_EQ(params.camera.navigation, Navigation::walk);
    EXPECT_EQ(params.camera.yaw, 30.6) << "missing fields keep their defaults";
    EXPECT_EQ(params.projection.type, ProjectionType::orthographic);
    EXPECT_EQ(params.projection.far, 1e9);
    EXPECT_FALSE(params.depth.test);
    EXPECT_EQ(params.depth.func, CompareFunc::notequal);
    EXPECT_EQ(params.depth.format, DepthFormat::d16);
    EXPECT_EQ(params.depth.offset.units, -2.0);
    ASSERT_EQ(params.lights.size(), 2U);
    EXPECT_EQ(params.lights[1].position, glm::dvec4(0, 1, 0, 0));
    ASSERT_EQ(params.planes.size(), 2U);
    EXPECT_EQ(params.planes[1].equation, glm::dvec4(0, 0, 2, 1));
    EXPECT_EQ(params.planes[1].extent, 4.0);
    EXPECT_TRUE(params.planes[1].receives_shadow);
    EXPECT_FALSE(params.planes[1].mirrors);
    EXPECT_EQ(params.shadow.color, (Color{10, 11, 12}));
    EXPECT_EQ(params.reflection.bounces, 2);
    ASSERT_TRUE(params.overrides[0].mirrored_world_from_world);
    EXPECT_EQ((*params.overrides[0].mirrored_world_from_world)[3][0], 4.0) << "rows in the file, columns in GLM";
    EXPECT_EQ((*params.overrides[0].mirrored_world_from_world)[0][3], 13.0);
    EXPECT_FALSE(params.overrides[0].shadowed_world_from_world[0]);
    EXPECT_EQ(params.follow, (Follow{"box", 3}));
    EXPECT_EQ(params.view.samples, 0);
    EXPECT_EQ(params.view.pin, (Pin{"torus", glm::dvec2(0.25, 1.0)}));
    EXPECT_EQ(params.view.layout,
              (LayoutParams{ViewName::lower_left, {"display", "V"}, {"camera", "projection.near"}, {"panel"}}));
}

/// Returns the state file that the golden list describes: a line for each field with its default, inside its groups.
std::string file_of_listed_defaults() {
    std::string text = "{";
    std::vector<std::string> open;
    const auto begin_line = [&] {
        text += (text.back() == '{' ? "\n" : ",\n") + std::string(2 + 2 * open.size(), ' ');
    };
    for (const testing::ListedField& field : testing::listed_fields()) {
        std::vector<std::string> groups;
        std::istringstream path(field.path());
        for (std::string part; std::getline(path, part, '.');) groups.push_back(part);
        const std::string name = groups.back();
        groups.pop_back();
        const auto common =
            std::mismatch(open.begin(), open.end(), groups.begin(), groups.end()).second - groups.begin();
        for (; std::ssize(open) > common; open.pop_back()) text += "\n" + std::string(2 * open.size(), ' ') + "}";
        while (open.size() < groups.size()) {
            begin_line();
            open.push_back(groups[open.size()]);
            text += "\"" + open.back() + "\": {";
        }
        begin_line();
        const std::string_view line = field.description;
        const std::string_view value = line.substr(line.find("; default ") + 10);
        text += "\"" + name + "\": " + std::string(value.substr(0, value.find("; in ")));
    }
    for (; !open.empty(); open.pop_back()) text += "\n" + std::string(2 * open.size(), ' ') + "}";
    return text + "\n}\n";
}

TEST(State, WritesTheDefaultsAsListed) {
    EXPECT_EQ(write_state(Params{}), file_of_listed_defaults());
}

TEST(State, RandomStatesRoundTripExactly) {
    constexpr unsigned first_seed = 20'200'000;
    const auto count = static_cast<unsigned>(testing::trials(is_sanitized ? 50 : 200));
    for (unsigned seed = first_seed; seed < first_seed + count; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const Params params = testing::RandomParams(seed).make();
        const std::string written = write_state(params);
        const Result<Params> back = parse_state(written, "written");
        ASSERT_TRUE(back) << back.error();
        ASSERT_EQ(*back, params) << written;
        ASSERT_EQ(write_state(*back), written);
        Params clamped = params;
        clamp_to_ranges(clamped);
        ASSERT_EQ(clamped, params) << "clamping must not change a valid state";
    }
}

// The reader must accept every state that clamp_to_ranges() produces, since the panel may write it.
TEST(State, AcceptsEveryClampedState) {
    std::mt19937 random(7);
    const double wild[] = {-1e300, -1e12, -1e6, -4000, -180, -1, -1e-12, 0, 1e-12, 1e-7, 1, 91, 3601, 1e6, 1e13, 1e300};
    const auto pick = [&] { return wild[random() % std::size(wild)]; };
    for (int round = 0; round < 200; ++round) {
        Params params;
        for (const Field& field : fields()) {
            const FieldRef ref = field.in(params);
            if (const auto* value = std::get_if<double*>(&ref)) {
                **value = pick();
            } else if (const auto* vec3 = std::get_if<glm::dvec3*>(&ref)) {
                **vec3 = {pick(), pick(), pick()};
            } else if (const auto* vec4 = std::get_if<glm::dvec4*>(&ref)) {
                **vec4 = {pick(), pick(), pick(), pick()};
            }
        }
        params.lights.resize(1 + random() % 6, {glm::dvec4(pick(), pick(), pick(), pick())});
        params.planes.resize(1 + random() % 9, {glm::dvec4(pick(), pick(), pick(), pick()), pick(), true, false, true});
        params.view.plane = static_cast<int>(random());
        params.view.light = static_cast<int>(random());
        params.overrides[random() % most_planes].shadowed_world_from_world[random() % most_lights] = glm::dmat4(pick());
        params.overrides[random() % most_planes].mirrored_world_from_world = glm::dmat4(pick());
        params.reflection.bounces = static_cast<int>(random());
        params.view.samples = static_cast<int>(random() % 9);
        clamp_to_ranges(params);
        const Result<Params> back = parse_state(write_state(params), "clamped");
        ASSERT_TRUE(back) << "round " << round << ": " << back.error();
        ASSERT_EQ(*back, params);
    }
}

TEST(Scene, RoundTrips) {
    const Result<SceneDescription> scene = parse_scene(R"({"title": "T", "objects": [
        {"name": "a", "shape": "teapot", "resolution": 3, "color": "#a0B0c0"},
        {"name": "b", "shape": "mesh", "file": "x.obj", "decal": true, "rotation": [10, 20, 30]},
        {"name": "d", "shape": "mesh", "file": "x.obj", "crease_deg": 12.5, "fit": false},
        {"name": "c", "shape": "triangle", "vertices": [[0,0,0],[1,0,0],[0,1,0]], "scale": [1, -2, 1]}]})",
                                                       "s.json");
    ASSERT_TRUE(scene) << scene.error();
    ASSERT_EQ(scene->objects.size(), 4U);
    EXPECT_EQ(scene->objects[0].resolution, 3);
    EXPECT_EQ(scene->objects[1].rotation, (Angles{10, 20, 30}));
    EXPECT_TRUE(scene->objects[1].decal);
    EXPECT_EQ(scene->objects[1].reading, (MeshReading{30.0, true})) << "by default";
    EXPECT_EQ(scene->objects[2].reading, (MeshReading{12.5, false}));
    EXPECT_EQ(scene->objects[3].scale.y, -2.0);
    const Result<SceneDescription> again = parse_scene(scene_as_json(*scene).dump(), "again");
    ASSERT_TRUE(again) << again.error();
    EXPECT_EQ(*again, *scene);
}

TEST(Scene, MadeByAFormulaRoundTripsAsItsParameters) {
    const Result<SceneDescription> scene = parse_scene(R"({"title": "T", "made_by": "coplanar"})", "s.json");
    ASSERT_TRUE(scene) << scene.error();
    EXPECT_EQ(scene->made_by, SceneFormula::coplanar);
    EXPECT_TRUE(scene->objects.empty());
    const std::string written = scene_as_json(*scene).dump();
    EXPECT_EQ(written.find("objects"), std::string::npos);
    EXPECT_EQ(*parse_scene(written, "again"), *scene);
}

TEST(Scene, IsWrittenInTheFormItWasGiven) {
    EXPECT_NE(write_state(read(R"({"scene": "my/room.json"})")).find(R"("scene": "my/room.json")"), std::string::npos);
    const std::string inline_scene = write_state(read(R"({"scene": {"objects": [{"name": "b", "shape": "box"}]}})"));
    EXPECT_NE(inline_scene.find(R"("name": "b")"), std::string::npos);
    EXPECT_NE(inline_scene.find(R"("scale": [1, 1, 1])"), std::string::npos);
}

TEST(ParamsCommand, ListsEveryField) {
    const nlohmann::json list = nlohmann::json::parse(params_as_json());
    ASSERT_EQ(list.size(), fields().size());
    const std::string text = params_as_text();
    for (std::size_t i = 0; i < list.size(); ++i) {
        EXPECT_EQ(list[i]["path"], fields()[i].path);
        for (const char* key : {"type", "unit", "default", "allowed", "help", "label"}) {
            EXPECT_TRUE(list[i].contains(key)) << fields()[i].path << " " << key;
        }
        EXPECT_NE(text.find("\n" + std::string(fields()[i].path) + " "), i == 0 ? 0 : std::string::npos);
    }
    const auto near = std::ranges::find_if(list, [](const auto& entry) { return entry["path"] == "projection.near"; });
    EXPECT_EQ((*near)["type"], "number");
    EXPECT_EQ((*near)["min"], -1e6);
    EXPECT_EQ((*near)["default"], 0.5);
    EXPECT_EQ((*near)["unit"], "world units");
    const auto func = std::ranges::find_if(list, [](const auto& entry) { return entry["path"] == "depth.func"; });
    EXPECT_EQ((*func)["values"].size(), 8U);
    EXPECT_FALSE(func->contains("min"));
}

}  // namespace
}  // namespace viewing
