// Invalid states and scenes: each is refused in one sentence with the source, the field's path, the fault and the
// allowed values.
#include <gtest/gtest.h>

#include "state/file/state_json.h"

namespace viewing {
namespace {

struct Bad {
    std::string json;
    std::string path;      ///< the message begins with "state.json: " and this
    std::string fragment;  ///< the message contains this
};

std::string box(const std::string& members) {
    return R"({"scene": {"objects": [{"name": "a", "shape": "box"}, {"name": "b", )" + members + "}]}}";
}

std::string repeated(const std::string& text, int count) {
    std::string all;
    for (int i = 0; i < count; ++i) {
        all += text;
    }
    return all;
}

void expect_refused(const Bad& bad, const std::string& error, const std::string& source) {
    SCOPED_TRACE(bad.json.substr(0, 200));
    const std::string opening = source + ": " + (bad.path.empty() ? "" : bad.path + ": ");
    EXPECT_EQ(error.substr(0, opening.size()), opening) << error;
    EXPECT_NE(error.find(bad.fragment), std::string::npos) << error << "\nlacks: " << bad.fragment;
    EXPECT_EQ(error.find('\n'), std::string::npos) << "more than one line: " << error;
}

void expect_all_refused(const std::vector<Bad>& all) {
    for (const Bad& bad : all) {
        const Result<Params> params = parse_state(bad.json, "state.json");
        ASSERT_FALSE(params) << bad.json.substr(0, 200);
        expect_refused(bad, params.error(), "state.json");
    }
}

TEST(BadStates, NotJson) {
    expect_all_refused({
        {"", "line 1, column 1", "ends too early"},
        {"  \n ", "line 2, column 2", "ends too early"},
        {"{", "line 1, column 2", "ends too early"},
        {std::string("{}\0 garbage {{{", 15), "not JSON", "unexpected text after the end of the document: a NUL"},
        {R"({"version": 1)", "line 1, column 14", "ends too early"},
        {"{\n  \"version\": 1,\n}", "line 3, column 1", "unexpected"},
        {"{\n  // a comment\n}", "line 2, column 3", "comments are not allowed"},
        {R"({"camera": {"yaw": NaN}})", "line 1, column 20", "NaN and infinity are not allowed"},
        {R"({"camera": {"yaw": nan}})", "line 1, column 21", "NaN and infinity are not allowed"},
        {R"({"camera": {"yaw": Infinity}})", "line 1, column 20", "NaN and infinity are not allowed"},
        {R"({"camera": {"yaw": -Infinity}})", "line 1, column 21", "NaN and infinity are not allowed"},
        {"{} {}", "line 1, column 4", "unexpected text after the end"},
        {"{'version': 1}", "line 1, column 2", "unexpected"},
        {"{\"scene\": \"open", "line 1, column 16", "no closing quote"},
        {"{\"scene\": \"a\xff\"}", "line 1, column 13", "not valid UTF-8"},
        {"{\"scene\": \"a\nb\"}", "line 1, column 13", "control character"},
        {std::string("\x89PNG\r\n\x1a\n\0\0", 10), "line 1, column 1", "unexpected"},
    });
}

TEST(BadStates, AbsurdDocuments) {
    expect_all_refused({
        {repeated("[", 100'000), "", "nested deeper than 64"},
        {R"({"camera": )" + repeated("{\"a\":", 70) + "1" + repeated("}", 71), "", "nested deeper than 64"},
        {std::string((16U << 20U) + 1, ' '), "", "longer than 16 MiB"},
        {"[" + repeated("0,", 1'000'001) + "0]", "", "more than a million values"},
        {R"({"camera": {"yaw": 1, "yaw": 2}})", "camera.yaw", "appears twice"},
        {R"({"ui": {}, "ui": {}})", "ui", "appears twice"},
        {R"({"scene": {"objects": [{"name": "a", "name": "b"}]}})", "scene.objects[0].name", "appears twice"},
        {"[]", "", "must be an object, got an array"},
        {"3", "", "must be an object, got the number 3"},
        {"null", "", "must be an object, got null"},
        {"\"text\"", "", "must be an object, got the string"},
    });
    std::string keys = "{";
    for (int i = 0; i < 1001; ++i) {
        keys += (i == 0 ? "" : ",") + ("\"k" + std::to_string(i) + "\":0");
    }
    expect_all_refused({{keys + "}", "", "more than 1000 fields in one object"}});
}

TEST(BadStates, UnknownNames) {
    expect_all_refused({
        {R"({"projection": {"naer": 1}})", "projection.naer", "no such field; did you mean projection.near?"},
        {R"({"objects": []})", "objects", "no such field; this is a scene: use --set scene=state.json"},
        {R"({"near": 1})", "near", "no such field; did you mean projection.near?"},
        {R"({"projektion": {}})", "projektion", "no such field; did you mean projection?"},
        {R"({"camera": {"zoom": 1}})", "camera.zoom", "no such field"},
        {R"({"camera": {"elevator": 1}})", "camera.elevator", "camera has position, yaw, pitch"},
        {R"({"quaternions": 1})", "quaternions", "the fields are version, scene, camera"},
        {R"({"camera.yaw": 1})", "camera.yaw", "no such field"},
        {R"({"": 1})", "", "no such field"},
        {R"({"shadow": {"colour": "#000000"}})", "shadow.colour", "did you mean shadow.color?"},
        {R"({"depth": {"offset": {"unit": 1}}})", "depth.offset.unit", "did you mean depth.offset.units?"},
        {R"({"depth": {"func": "les"}})", "depth.func",
         "must be one of never, less, equal, lequal, greater, notequal, gequal, always, got the string \"les\"; did "
         "you mean less?"},
        {R"({"depth": {"func": "LESS"}})", "depth.func", "must be one of never, less"},
        {R"({"depth": {"format": "d13"}})", "depth.format", "did you mean d10?"},
        {R"({"camera": {"navigation": "swim"}})", "camera.navigation", "must be one of fly, walk, orbit"},
        {R"({"camera": {"navigation": 1}})", "camera.navigation", "got the number 1"},
        {R"({"ui": {"theme": "projektor"}})", "ui.theme", "did you mean projector?"},
        {R"({"lights": [{"positoin": [0,1,0,0]}]})", "lights[0].positoin", "did you mean position?"},
        {R"({"planes": [{"normal": [0,1,0]}]})", "planes[0].normal",
         "allowed here: equation, extent, receives_shadow, mirrors"},
        {R"({"follow": {"object": "a", "index": 1}})", "follow.index", "allowed here: object, vertex, point"},
    });
}

TEST(BadStates, WrongTypes) {
    expect_all_refused({
        {R"({"version": "1"})", "version", "must be 1"},
        {R"({"version": 2})", "version", "must be 1, the only version that this program reads, got the number 2"},
        {R"({"title": 3})", "title", "must be a string"},
        {R"({"about": []})", "about", "must be a string"},
        {R"({"scene": 3})", "scene", "must be a scene's name"},
        {R"({"scene": ""})", "scene", "must not be empty"},
        {R"({"scene": "a\u0000b"})", "scene", "control characters"},
        {R"({"scene": ")" + repeated("a", 2000) + R"("})", "scene", "longer than 1024 bytes"},
        {R"({"camera": []})", "camera", "must be an object, got an array"},
        {R"({"camera": {"yaw": "30"}})", "camera.yaw", "must be a number from -3600 to 3600, got the string \"30\""},
        {R"({"camera": {"yaw": null}})", "camera.yaw", "got null"},
        {R"({"camera": {"position": [1, 2]}})", "camera.position", "three numbers"},
        {R"({"camera": {"position": [1, 2, 3, 4]}})", "camera.position", "got an array of length 4"},
        {R"({"camera": {"position": [1, true, 3]}})", "camera.position[1]", "must be a number"},
        {R"({"camera": {"position": {"x": 1}}})", "camera.position", "got an object"},
        {R"({"depth": {"test": 1}})", "depth.test", "must be true or false, got the number 1"},
        {R"({"depth": {"test": "true"}})", "depth.test", "must be true or false"},
        {R"({"light": {"position": [1, 2, 3]}})", "light.position", "four numbers [x, y, z, w]"},
        {R"({"lights": {}})", "lights", "an array of at most 3 lights"},
        {R"({"lights": [3]})", "lights[0]", "must be a light"},
        {R"({"planes": [[0, 1, 0, 0]]})", "planes[0]", "must be a plane"},
        {R"({"shadow": {"color": "red"}})", "shadow.color", "must be a color \"#rrggbb\""},
        {R"({"shadow": {"color": "#12345"}})", "shadow.color", "#rrggbb"},
        {R"({"shadow": {"color": "#1234567"}})", "shadow.color", "#rrggbb"},
        {R"({"shadow": {"color": "#12345g"}})", "shadow.color", "#rrggbb"},
        {R"({"shadow": {"color": "#-12345"}})", "shadow.color", "#rrggbb"},
        {R"({"reflection": {"bounces": 1.5}})", "reflection.bounces", "must be a whole number from 0 to 16"},
        {R"({"overrides": {"view_from_world": [[1,0,0,0]]}})", "overrides.view_from_world", "4 rows of 4 numbers"},
        {R"({"overrides": {"clip_from_view": 1}})", "overrides.clip_from_view", "4 rows of 4 numbers"},
        {R"({"overrides": {"shadow_from_world": []}})", "overrides.shadow_from_world", "4 rows of 4 numbers"},
        {R"({"overrides": {"shadow_from_world": [[1,0,0,0],[0,1,0],[0,0,1,0],[0,0,0,1]]}})",
         "overrides.shadow_from_world[1]", "a row of 4 numbers"},
        {R"({"overrides": {"mirror_from_world": [[1,0,0,0],[0,1,0,"x"],[0,0,1,0],[0,0,0,1]]}})",
         "overrides.mirror_from_world[1][3]", "must be a number"},
        {R"({"overrides": {"further": {}}})", "overrides.further", "an array of"},
        {R"({"overrides": {"further": [{"plane": 0}]}})", "overrides.further[0].plane", "a whole number from 1 to 8"},
        {R"({"overrides": {"further": [{"light": 5}]}})", "overrides.further[0].light", "a whole number from 1 to 4"},
        {R"({"overrides": {"further": [{"plan": 2}]}})", "overrides.further[0].plan", "did you mean plane?"},
        {R"({"overrides": {"further": [{"mirror_from_world": [[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]}]}})",
         "overrides.further[0].mirror_from_world", "for the first one, use overrides.mirror_from_world"},
        {R"({"planes": [{}], "overrides": {"further": [
            {"plane": 2, "mirror_from_world": [[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]},
            {"plane": 2, "mirror_from_world": [[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]}]}})",
         "overrides.further[1].mirror_from_world", "is given twice"},
        {R"({"planes": [{}], "overrides": {"further": [
            {"plane": 3, "mirror_from_world": [[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]}]}})",
         "overrides.further", "there is no plane 3"},
        {R"({"overrides": {"further": [
            {"light": 2, "shadow_from_world": [[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]}]}})",
         "overrides.further", "there is no light 2"},
        {R"({"view": {"plane": 2}})", "view.plane", "must be 1: the state has only 1, got 2"},
        {R"({"lights": [{}], "view": {"light": 3}})", "view.light", "must be from 1 to 2: the state has only 2, got 3"},
        {R"({"follow": "box"})", "follow", "must be null, {\"object\": name"},
        {R"({"follow": {}})", "follow.object", "is missing"},
        {R"({"follow": {"object": "box", "point": [1, 2, 3]}})", "follow", "give either point or object and vertex"},
        {R"({"follow": {"point": [1, 2]}})", "follow.point", "three numbers"},
        {R"({"follow": {"point": [1, 2, 1e13]}})", "follow.point[2]", "from -1e6 to 1e6"},
        {R"({"reflection": {"fovy": 0.5}})", "reflection.fovy", "0 or a number from 1 to 179"},
        {R"({"follow": {"object": "box", "vertex": -1}})", "follow.vertex", "whole number from 0"},
        {R"({"follow": {"object": "box", "vertex": 0.5}})", "follow.vertex", "whole number"},
        {R"({"view": {"pin": {}}})", "view.pin", "must be null, {\"object\": name"},
        {R"({"view": {"pin": [1, 2]}})", "view.pin", "must be null, {\"object\": name"},
        {R"({"view": {"pin": {"object": ""}}})", "view.pin.object", "must not be empty"},
        {R"({"view": {"pin": {"place": "box"}}})", "view.pin.place", "allowed here: object, at"},
        {R"({"view": {"pin": {"at": [0.5]}}})", "view.pin.at", "two numbers [u, v], each from 0 to 1"},
        {R"({"view": {"pin": {"at": [0.5, 1.5]}}})", "view.pin.at[1]", "a number from 0 to 1"},
        {R"({"view": {"layout": {"matrices": "V"}}})", "view.layout.matrices",
         "an array of different names, each one of"},
        {R"({"view": {"layout": {"matrices": ["V", "W"]}}})", "view.layout.matrices[1]",
         "must be one of S, R, follow, V, C, P, display, got the string \"W\""},
        {R"({"view": {"layout": {"matrices": ["V", "V"]}}})", "view.layout.matrices[1]", "appears twice in the list"},
        {R"({"view": {"layout": {"matrices": [4]}}})", "view.layout.matrices[0]", "must be a string"},
        {R"({"view": {"layout": {"controls": ["projection.naer"]}}})", "view.layout.controls[0]",
         "must be the path of a field or group, got the string \"projection.naer\"; did you mean projection.near?"},
        {R"({"view": {"layout": {"folded": ["camera"]}}})", "view.layout.folded[0]", "must be one of panel, matrices"},
        {R"({"view": {"layout": {"big": "lower"}}})", "view.layout.big", "must be one of none, camera, lower_left"},
        {R"({"projection": {"aspect": 0.05}})", "projection.aspect", "must be 0 or a number from 0.1 to 10"},
        {R"({"projection": {"aspect": 11}})", "projection.aspect", "must be a number from 0 to 10"},
    });
}

TEST(BadStates, OutOfRange) {
    expect_all_refused({
        {R"({"projection": {"near": 0}})", "projection.near", "must be a number from 1e-6 to 1e6, got the number 0"},
        {R"({"projection": {"near": -1}})", "projection.near", "from 1e-6 to 1e6"},
        {R"({"projection": {"type": "orthographic", "near": -1}, "depth": {"mapping": "logarithmic"}})",
         "projection.near", "from 1e-6 to 1e6"},
        {R"({"projection": {"type": "orthographic", "near": -2e6}})", "projection.near", "from -1e6 to 1e6"},
        {R"({"projection": {"near": 40}})", "projection.near", "must be less than projection.far (40), got 40"},
        {R"({"projection": {"far": 0.25}})", "projection.near", "must be less than projection.far (0.25), got 0.5"},
        {R"({"projection": {"far": "infinit"}})", "projection.far", "from 1e-5 to 1e9, or \"infinite\""},
        {R"({"projection": {"near": "infinite"}})", "projection.near", "got the string \"infinite\""},
        {R"({"projection": {"far": "infinite", "type": "orthographic"}})", "projection.far",
         "only in a perspective or a frustum without logarithmic depth"},
        {R"({"projection": {"far": "infinite"}, "depth": {"mapping": "logarithmic"}})", "projection.far",
         "only in a perspective or a frustum without logarithmic depth"},
        {R"({"projection": {"type": "frustum", "left": 1}})", "projection.left",
         "must be less than projection.right (0.32), got 1"},
        {R"({"projection": {"type": "orthographic_window", "bottom": 2, "top": 2}})", "projection.bottom",
         "must be less than projection.top (2), got 2"},
        {R"({"projection": {"type": "frustum", "top": 2e6}})", "projection.top", "from -1e6 to 1e6"},
        {R"({"projection": {"type": "frustum", "near": 0}})", "projection.near", "from 1e-6 to 1e6"},
        {R"({"projection": {"fovy": 180}})", "projection.fovy", "from 1 to 179"},
        {R"({"projection": {"far": 1e13}})", "projection.far", "got the number 1e13"},
        {R"({"projection": {"far": 1e999}})", "projection.far", "the number 1e999 is too large"},
        {R"({"camera": {"position": [1, 2, 1e400]}})", "camera.position[2]", "too large"},
        {R"({"camera": {"position": [1, 2e6, 3]}})", "camera.position[1]", "from -1e6 to 1e6"},
        {R"({"camera": {"yaw": 123456789012345678901234567890}})", "camera.yaw", "got the number 1.2345"},
        {R"({"shadow": {"opacity": 1.01}})", "shadow.opacity", "from 0 to 1"},
        {R"({"reflection": {"bounces": 17}})", "reflection.bounces", "from 0 to 16"},
        {R"({"visibility": {"step": -2}})", "visibility.step", "from -1"},
        {R"({"view": {"samples": 2}})", "view.samples", "must be 0 or 4, got the number 2"},
        {R"({"view": {"samples": 8}})", "view.samples", "must be 0 or 4, got the number 8"},
        {R"({"ui": {"scale": 0}})", "ui.scale", "from 0.5 to 4"},
        {R"({"observer": {"distance": 0}})", "observer.distance", "from 0.001"},
        {R"({"light": {"position": [0, 0, 0, 0]}})", "light.position", "must not be zero"},
        {R"({"light": {"position": [1, 2, 3, 2]}})", "light.position[3]", "from 0 to 1"},
        {R"({"lights": [{"position": [0, 1, 0, 1]}, {"position": [0, 0, 0, 0]}]})", "lights[1].position", "zero"},
        {R"({"lights": [{}, {}, {}, {}]})", "lights", "at most 3"},
        {R"({"plane": {"equation": [0, 0, 0, 1]}})", "plane.equation", "normal (a, b, c) must not be zero"},
        {R"({"plane": {"equation": [1e-200, 0, 0, 1]}})", "plane.equation", "must not be zero"},
        {R"({"plane": {"extent": -4}})", "plane.extent", "from 0.001 to 10000"},
        {R"({"planes": [{}, {"equation": [0, 0, 0, 0]}]})", "planes[1].equation", "must not be zero"},
        {R"({"planes": [{}, {}, {}, {}, {}, {}, {}, {}]})", "planes", "at most 7"},
        {R"({"planes": [{"extent": 0}]})", "planes[0].extent", "from 0.001"},
        {R"({"overrides": {"shadow_from_world": [[1e13,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]}})",
         "overrides.shadow_from_world[0][0]", "from -1e12 to 1e12"},
    });
}

TEST(BadStates, Objects) {
    expect_all_refused({
        {R"({"scene": {}})", "scene.objects", "is missing"},
        {R"({"scene": {"objects": {}}})", "scene.objects", "an array of at most 10000 objects"},
        {R"({"scene": {"objects": [], "title": "t"}})", "scene.title", "no such field"},
        {R"({"scene": {"objects": ["box"]}})", "scene.objects[0]", "must be an object"},
        {R"({"scene": {"objects": [{"shape": "box"}]}})", "scene.objects[0].name", "is missing"},
        {R"({"scene": {"objects": [{"name": "", "shape": "box"}]}})", "scene.objects[0].name", "must not be empty"},
        {R"({"scene": {"objects": [{"name": "a"}]}})", "scene.objects[0].shape", "one of box, sphere"},
        {R"({"scene": {"objects": [{"name": "a", "shape": "box"}, {"name": "a", "shape": "box"}]}})",
         "scene.objects[1].name", "already called \"a\""},
        {box(R"("shape": "cube")"), "scene.objects[1].shape", "must be one of box, sphere, torus"},
        {box(R"("shape": "spere")"), "scene.objects[1].shape", "did you mean sphere?"},
        {box(R"("shape": "box", "colour": "#ffffff")"), "scene.objects[1].colour", "did you mean color?"},
        {box(R"("shape": "box", "scale": [1, 0, 1])"), "scene.objects[1].scale[1]", "must be nonzero"},
        {box(R"("shape": "box", "scale": 2)"), "scene.objects[1].scale", "three factors"},
        {box(R"("shape": "box", "scale": [1, 1e-300, 1])"), "scene.objects[1].scale[1]", "at least 1e-6"},
        {box(R"("shape": "box", "scale": [1, 1e7, 1])"), "scene.objects[1].scale[1]", "from -1e6 to 1e6"},
        {box(R"("shape": "box", "position": [1, 2])"), "scene.objects[1].position", "three numbers"},
        {box(R"("shape": "box", "rotation": [0, 0, 4000])"), "scene.objects[1].rotation[2]", "from -3600 to 3600"},
        {box(R"("shape": "box", "color": 7)"), "scene.objects[1].color", "#rrggbb"},
        {box(R"("shape": "box", "file": "a.obj")"), "scene.objects[1].file", "belongs to the shape mesh"},
        {box(R"("shape": "box", "crease_deg": 4)"), "scene.objects[1].crease_deg", "belongs to the shape mesh"},
        {box(R"("shape": "box", "fit": true)"), "scene.objects[1].fit", "belongs to the shape mesh"},
        {box(R"("shape": "mesh", "file": "a.obj", "crease_deg": 181)"), "scene.objects[1].crease_deg", "180"},
        {box(R"("shape": "mesh", "file": "a.obj", "crease_deg": -1)"), "scene.objects[1].crease_deg", "0"},
        {box(R"("shape": "mesh", "file": "a.obj", "fit": 1)"), "scene.objects[1].fit", "true or false"},
        {box(R"("shape": "box", "vertices": [[0,0,0],[1,0,0],[0,1,0]])"), "scene.objects[1].vertices",
         "belongs to the shape triangle"},
        {box(R"("shape": "box", "resolution": 4)"), "scene.objects[1].resolution", "belongs to the shape teapot"},
        {box(R"("shape": "teapot", "resolution": 0)"), "scene.objects[1].resolution", "from 1 to 64"},
        {box(R"("shape": "mesh")"), "scene.objects[1].file", "is missing"},
        {box(R"("shape": "mesh", "file": "")"), "scene.objects[1].file", "must not be empty"},
        {box(R"("shape": "triangle")"), "scene.objects[1].vertices", "is missing"},
        {box(R"("shape": "triangle", "vertices": [[0,0,0],[1,0,0]])"), "scene.objects[1].vertices", "three vertices"},
        {box(R"("shape": "triangle", "vertices": [[0,0,0],[1,0,0],[2,0]])"), "scene.objects[1].vertices[2]",
         "a vertex [x, y, z]"},
        {box(R"("shape": "triangle", "vertices": [[0,0,0],[1,1,1],[2,2,2]])"), "scene.objects[1].vertices", "no area"},
        {box(R"("shape": "triangle", "vertices": [[5,5,5],[5,5,5],[5,5,5]])"), "scene.objects[1].vertices", "no area"},
        {box(R"("shape": "triangle", "vertices": [[1e6,0,0],[999999.999,0,0],[1e6,0.5,0]])"),
         "scene.objects[1].vertices", "no area"},
        {R"({"scene": {"made_by": "coplaner"}})", "scene.made_by", "must be one of coplanar"},
        {R"({"scene": {"made_by": "coplaner"}})", "scene.made_by", "did you mean coplanar?"},
        {R"({"scene": {"made_by": 3}})", "scene.made_by", "must be one of coplanar"},
        {R"({"scene": {"made_by": "coplanar", "objects": []}})", "scene.made_by", "the scene also lists objects"},
        {R"({"scene": {"made_bye": "coplanar"}})", "scene.made_bye", "did you mean made_by?"},
        {R"({"scene": {}})", "scene.objects", "is missing"},
    });
}

TEST(BadScenes, NameTheirFile) {
    for (const Bad& bad : std::vector<Bad>{
             {R"({"objects": [{"name": "a", "shape": "box", "scale": [1, 1, 0]}]})", "objects[0].scale[2]",
              "must be nonzero"},
             {R"({"object": []})", "object", "did you mean objects?"},
             {R"({"title": 1, "objects": []})", "title", "must be a string"},
             {"[]", "", "must be an object"},
         }) {
        const Result<SceneDescription> scene = parse_scene(bad.json, "room.json");
        ASSERT_FALSE(scene);
        expect_refused(bad, scene.error(), "room.json");
    }
    std::string many = R"({"objects": [{"name": "0", "shape": "box"})";
    for (int i = 1; i <= 10'000; ++i) {
        many += R"(,{"name": ")" + std::to_string(i) + R"(", "shape": "box"})";
    }
    const Result<SceneDescription> scene = parse_scene(many + "]}", "room.json");
    ASSERT_FALSE(scene);
    EXPECT_EQ(scene.error(),
              "room.json: objects: must be an array of at most 10000 objects, got an array of length 10001");
}

TEST(BadStates, MessagesStayShort) {
    const std::string long_key = repeated("ключ\\n", 5000);
    const Result<Params> params = parse_state("{\"" + long_key + "\": 1}", "state.json");
    ASSERT_FALSE(params);
    EXPECT_LT(params.error().size(), 600U);
    EXPECT_EQ(params.error().find('\n'), std::string::npos);
    const Result<Params> value = parse_state(R"({"ui": {"theme": ")" + repeated("x", 100'000) + R"("}})", "state.json");
    ASSERT_FALSE(value);
    EXPECT_LT(value.error().size(), 300U);
}

}  // namespace
}  // namespace viewing
