// Scenes with their meshes, the shipped scenes and presets, and how a STATE argument is found.
#include "state/scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

#include "platform/text_file.h"
#include "scratch_folder.h"
#include "state/fields.h"
#include "state/file/state_json.h"
#include "state/presets.h"

namespace viewing {
namespace {

using SceneFiles = testing::ScratchFolder;

constexpr const char* triangle_obj = "v 0 0 0\nv 2 0 0\nv 0 1 0\nf 1 2 3\n";

SceneDescription one_object(ShapeKind shape) {
    ObjectDescription object;
    object.name = "thing";
    object.shape = shape;
    object.vertices = {glm::dvec3(0, 0, 0), glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0)};
    return {{object}};
}

TEST(Scenes, AssetsAreFound) {
    ASSERT_FALSE(assets_directory().empty()) << "set VIEWING_SANDBOX_ASSETS";
}

TEST(Scenes, EveryShapeLoadsWithItsSize) {
    const std::pair<ShapeKind, glm::dvec3> sizes[] = {
        {ShapeKind::box, {2, 2, 2}},      {ShapeKind::sphere, {2, 2, 2}}, {ShapeKind::torus, {2.48, 0.68, 2.48}},
        {ShapeKind::cylinder, {2, 2, 2}}, {ShapeKind::cone, {2, 2, 2}},   {ShapeKind::quad, {2, 0, 2}},
        {ShapeKind::triangle, {1, 1, 0}},
    };
    for (const auto& [shape, size] : sizes) {
        const Result<Scene> scene = load_scene(one_object(shape), "");
        ASSERT_TRUE(scene) << scene.error();
        EXPECT_LT(glm::length(scene->bounds_world.size() - size), 0.02) << name_of(shape);
        EXPECT_NE(scene->find("thing"), nullptr);
        EXPECT_EQ(scene->find("nothing"), nullptr);
    }
}

TEST(Scenes, PoseIsTRS) {
    SceneDescription description = one_object(ShapeKind::box);
    description.objects[0].position = {10, 0, 0};
    description.objects[0].scale = {1, 2, 3};
    description.objects[0].rotation = {90, 0, 0};  // x becomes −z
    const Result<Scene> scene = load_scene(description, "");
    ASSERT_TRUE(scene);
    EXPECT_LT(glm::length(scene->bounds_world.min - glm::dvec3(7, -2, -1)), 1e-9);
    EXPECT_LT(glm::length(scene->bounds_world.max - glm::dvec3(13, 2, 1)), 1e-9);
}

TEST(Scenes, ShareTheirMeshes) {
    const Result<Scene> first = load_scene(one_object(ShapeKind::teapot), "");
    const Result<Scene> second = load_scene(one_object(ShapeKind::teapot), "");
    ASSERT_TRUE(first && second);
    EXPECT_EQ(first->objects[0].mesh, second->objects[0].mesh);
    SceneDescription finer = one_object(ShapeKind::teapot);
    finer.objects[0].resolution = 3;
    EXPECT_NE(load_scene(finer, "")->objects[0].mesh, first->objects[0].mesh);
}

TEST(Scenes, LoadFromSeveralThreads) {
    std::vector<std::thread> threads;
    std::atomic<int> loaded{0};
    threads.reserve(4);
    for (int i = 0; i < 4; ++i) {
        threads.emplace_back([&loaded] {
            for (int round = 0; round < 5; ++round) {
                loaded += load_scene(std::string("torus-and-boxes"), "") ? 1 : 0;
            }
        });
    }
    for (std::thread& thread : threads) {
        thread.join();
    }
    EXPECT_EQ(loaded, 20);
}

TEST(Scenes, ShippedOnesExistAndLoad) {
    std::vector<std::string> names;
    for (const NamedFile& file : scenes()) {
        names.push_back(file.name);
        EXPECT_NE(file.title, file.name) << "has its own title";
        EXPECT_TRUE(file.about.ends_with(".")) << file.name;
        const Result<Scene> scene = load_scene(file.name, "");
        ASSERT_TRUE(scene) << scene.error();
        EXPECT_FALSE(scene->objects.empty());
        EXPECT_GT(scene->bounds_world.min.y, -1e-3) << file.name << " stands on the plane y = 0";
    }
    EXPECT_EQ(names, (std::vector<std::string>{"coplanar", "curved", "cyclic-overlap", "decals", "few-triangles",
                                               "interpenetrating", "letters", "many-splits", "sort-key-centroid",
                                               "sort-key-farthest", "sort-key-nearest", "t-junctions", "teapot",
                                               "torus-and-boxes", "triangle-cycle", "walkthrough"}));
}

TEST(Scenes, OpeningSceneHasItsComposition) {
    const Result<Scene> scene = load_scene(Params{}.scene, "");
    ASSERT_TRUE(scene);
    for (const char* name : {"torus", "box", "small box"}) {
        ASSERT_NE(scene->find(name), nullptr) << name;
    }
    EXPECT_NEAR(scene->bounds_world.min.y, 0.0, 1e-6);
    EXPECT_LT(scene->bounds_world.size().x / 2.0, 4.0);
}

TEST(Scenes, WalkthroughKeepsItsDoorwaysOpen) {
    const Result<Scene> scene = load_scene(std::string("walkthrough"), "");
    ASSERT_TRUE(scene);
    EXPECT_GE(scene->objects.size(), 40U);
    EXPECT_LE(scene->objects.size(), 80U);
    // A walk at eye height: from the entrance down the corridor and out at the end, and into three rooms.
    const glm::dvec3 route[] = {{0, 1.7, 11}, {0, 1.7, -11}, {0, 1.7, 5},   {-5, 1.7, 5}, {0, 1.7, 5},
                                {0, 1.7, 6},  {3.5, 1.7, 6}, {0, 1.7, 6},   {0, 1.7, -6}, {-5, 1.7, -6},
                                {0, 1.7, -6}, {0, 1.7, -5},  {4.0, 1.7, -5}};
    for (std::size_t leg = 0; leg + 1 < std::size(route); ++leg) {
        for (int step = 0; step <= 100; ++step) {
            const glm::dvec3 eye = glm::mix(route[leg], route[leg + 1], step / 100.0);
            for (const SceneObject& object : scene->objects) {
                const glm::dvec4 local = glm::inverse(object.world_from_model) * glm::dvec4(eye, 1.0);
                const bool inside = std::abs(local.x) < 1.0 && std::abs(local.y) < 1.0 && std::abs(local.z) < 1.0;
                ASSERT_FALSE(inside) << "leg " << leg << " runs into " << object.description.name;
            }
        }
    }
}

TEST_F(SceneFiles, MeshPathsAreRelativeToTheSceneFile) {
    std::filesystem::create_directories(folder_ / "meshes");
    write("meshes/t.obj", triangle_obj);
    write("room.json", R"({"objects": [{"name": "t", "shape": "mesh", "file": "meshes/t.obj"}]})");
    const Result<Scene> by_path = load_scene((folder_ / "room.json").string(), "");
    ASSERT_TRUE(by_path) << by_path.error();
    EXPECT_EQ(by_path->objects[0].mesh->triangle_count(), 1U);
    const Result<Scene> by_base = load_scene(std::string("room.json"), folder_);
    ASSERT_TRUE(by_base) << by_base.error();
    EXPECT_EQ(by_base->objects[0].mesh, by_path->objects[0].mesh) << "one file is read once";
}

TEST_F(SceneFiles, ChangedMeshIsReadAgain) {
    SceneDescription scene = one_object(ShapeKind::mesh);
    scene.objects[0].file = write("t.obj", triangle_obj).string();
    EXPECT_EQ(load_scene(scene, "")->objects[0].mesh->triangle_count(), 1U);
    write("t.obj", std::string(triangle_obj) + "f 3 2 1\n");
    EXPECT_EQ(load_scene(scene, "")->objects[0].mesh->triangle_count(), 2U);
}

TEST_F(SceneFiles, BadOnesAreRefusedWithNameAndField) {
    const auto error = [this](const char* content) {
        write("room.json", content);
        const Result<Scene> scene = load_scene(std::string("room.json"), folder_);
        return scene ? std::string("loaded") : scene.error();
    };
    write("broken.obj", "not a mesh\n");
    EXPECT_EQ(error(R"({"objects": [{"name": "t", "shape": "mesh", "file": "none.obj"}]})"),
              "room.json: objects[0].file: " + (folder_ / "none.obj").string() + ": no such file");
    EXPECT_EQ(error(R"({"objects": [{"name": "t", "shape": "mesh", "file": "broken.obj"}]})"),
              "room.json: objects[0].file: " + (folder_ / "broken.obj").string() +
                  ": not an OBJ file, or an empty one: it has no vertices and no faces");
    EXPECT_EQ(error(R"({"objects": [{"name": "t", "shape": "box", "scale": [0, 1, 1]}]})"),
              "room.json: objects[0].scale[0]: must be nonzero: 0 would flatten the object, got the number 0");
    EXPECT_EQ(load_scene(std::string("missing.json"), folder_).error(),
              "scene: " + (folder_ / "missing.json").string() + ": no such file");
    const std::string unknown = load_scene(std::string("teapod"), folder_).error();
    EXPECT_NE(
        unknown.find(
            "scene: teapod is neither a file nor a scene (viewing-sandbox presets lists them); did you mean teapot?"),
        std::string::npos)
        << unknown;
    EXPECT_NE(load_scene(folder_.string(), "").error().find("is a directory"), std::string::npos);
}

/// Such a name may come from a file dropped on the window.
TEST_F(SceneFiles, NameThatIsNotUtf8IsRefused) {
    const std::filesystem::path mesh = write("caf\xe9.obj", triangle_obj);
    const Result<Scene> scene = load_scene(mesh.string(), "");
    ASSERT_FALSE(scene);
    EXPECT_NE(scene.error().find("caf\\xe9.obj: the file name is not UTF-8"), std::string::npos) << scene.error();
}

TEST_F(SceneFiles, MeshIsPlacedOnTheFloor) {
    const std::filesystem::path file = write("t.obj", triangle_obj);
    const SceneDescription description = scene_of_mesh(file);
    ASSERT_EQ(description.objects.size(), 1U);
    EXPECT_EQ(description.objects[0].name, "t");
    const Result<Scene> scene = load_scene(description, "/nowhere");
    ASSERT_TRUE(scene) << scene.error();
    EXPECT_NEAR(scene->bounds_world.min.y, 0.0, 1e-6);
    EXPECT_NEAR(scene->bounds_world.size().x, 2.0, 1e-6);
    const Result<Scene> by_name = load_scene(file.string(), "");
    ASSERT_TRUE(by_name) << "an OBJ path is a scene too";
    EXPECT_EQ(by_name->objects[0].mesh, scene->objects[0].mesh);
    Params params;
    params.scene = description;
    EXPECT_TRUE(parse_state(write_state(params), "s"));

    const SceneDescription missing = scene_of_mesh(folder_ / "none.obj");
    const std::string path = (folder_ / "none.obj").string();
    EXPECT_EQ(load_scene(missing, "").error(), "scene.objects[0].file: " + path + ": no such file");
    EXPECT_EQ(load_scene(missing, "", {}, {.origin = "mine.json: scene"}).error(),
              "mine.json: scene.objects[0].file: " + path + ": no such file");
    EXPECT_EQ(load_scene(path, "", {}, {.origin = "--mesh"}).error(), "--mesh: " + path + ": no such file");
}

/// Returns all corners of an object in world space.
std::vector<glm::dvec3> corners_world(const Scene& scene, std::size_t object) {
    std::vector<glm::dvec3> corners;
    for (const glm::vec3& position : scene.objects[object].mesh->positions)
        corners.emplace_back(scene.objects[object].world_from_model * glm::dvec4(position, 1.0));
    return corners;
}

// A shed with the measurements from an exercise sheet, and a copy at map coordinates.
TEST_F(SceneFiles, UnfittedMeshKeepsItsFileCoordinates) {
    write("shed.obj", "v 10 0 -6\nv 16 0 -6\nv 16 4 -2\nv 10 4 -2\nf 1 2 3 4\n");
    write("map.obj",
          "v 413210.25 6204800 -6\nv 413216.25 6204800 -6\nv 413216.25 6204804 -2\nv 413210.25 6204804 -2\n"
          "f 1 2 3 4\n");
    const Result<SceneDescription> description = parse_scene(R"({"objects": [
        {"name": "own", "shape": "mesh", "file": "shed.obj", "fit": false},
        {"name": "turned", "shape": "mesh", "file": "shed.obj", "fit": false, "rotation": [90, 0, 0],
         "scale": [1, 2, 1], "position": [1, 0, 0]},
        {"name": "fitted", "shape": "mesh", "file": "shed.obj"},
        {"name": "map", "shape": "mesh", "file": "map.obj", "fit": false}]})",
                                                             "s.json");
    ASSERT_TRUE(description) << description.error();
    const Result<Scene> scene = load_scene(*description, folder_);
    ASSERT_TRUE(scene) << scene.error();
    EXPECT_EQ(corners_world(*scene, 0), (std::vector<glm::dvec3>{{10, 0, -6}, {16, 0, -6}, {16, 4, -2}, {10, 4, -2}}));
    // The product T R S about the origin of the file: (x, y, z) becomes (1 + z, 2 y, −x).
    const std::vector<glm::dvec3> turned = corners_world(*scene, 1);
    EXPECT_LT(glm::length(turned[0] - glm::dvec3(-5, 0, -10)), 1e-9);
    EXPECT_LT(glm::length(turned[2] - glm::dvec3(-1, 8, -16)), 1e-9);
    EXPECT_LT(glm::length(corners_world(*scene, 2)[2] - glm::dvec3(1, 2.0 / 3.0, 2.0 / 3.0)), 1e-6);
    EXPECT_EQ(corners_world(*scene, 3)[2], glm::dvec3(413216.25, 6204804, -2)) << "no digit is lost at a distance";
    EXPECT_EQ(scene->bounds_world.max.y, 6204804.0);
    EXPECT_NE(scene->objects[0].mesh, scene->objects[2].mesh);
    EXPECT_EQ(scene->objects[0].mesh, scene->objects[1].mesh);
}

TEST_F(SceneFiles, CreaseAngleBelongsToTheObject) {
    write("fold.obj", "v -1 0 0\nv 0 0 0\nv 0 0 1\nv -1 0 1\nv 0 1 0\nv 0 1 1\nf 1 4 3 2\nf 2 3 6 5\n");
    SceneDescription description = one_object(ShapeKind::mesh);
    description.objects[0].file = "fold.obj";
    description.objects.push_back(description.objects[0]);
    description.objects[1].name = "smooth";
    description.objects[1].reading.crease_deg = 90.0;
    const Result<Scene> scene = load_scene(description, folder_);
    ASSERT_TRUE(scene) << scene.error();
    EXPECT_EQ(scene->objects[0].mesh->positions.size(), 8U);
    EXPECT_EQ(scene->objects[1].mesh->positions.size(), 6U);
}

TEST_F(SceneFiles, OmissionsOfAMeshAreReportedEachTime) {
    const std::filesystem::path file = write("t.obj", std::string(triangle_obj) + "face 1 2 3\n");
    const std::string note = file.string() + ": line 5: not understood: face 1 2 3";
    for (int i = 0; i < 2; ++i) {
        const Result<Scene> alone = load_scene(file.string(), "", {}, {.origin = "STATE"});
        ASSERT_TRUE(alone) << alone.error();
        EXPECT_EQ(alone->notes, std::vector<std::string>{"STATE: " + note}) << "also for a cached mesh";
    }
    write("room.json",
          R"({"objects": [{"name": "b", "shape": "box"}, {"name": "t", "shape": "mesh", "file": "t.obj"}]})");
    const Result<Scene> room = load_scene((folder_ / "room.json").string(), "");
    ASSERT_TRUE(room) << room.error();
    ASSERT_EQ(room->notes.size(), 1U);
    EXPECT_EQ(room->notes[0], (folder_ / "room.json").string() + ": objects[1].file: " + note);
}

TEST_F(SceneFiles, LoadingCanBeCanceled) {
    SceneDescription scene = one_object(ShapeKind::mesh);
    scene.objects[0].file = write("t.obj", triangle_obj).string();
    WorkProgress progress;
    progress.canceled = true;
    EXPECT_NE(load_scene(scene, "", {}, {.progress = &progress}).error().find("canceled"), std::string::npos);
}

TEST(Presets, AllLoadWithTheirScenes) {
    const std::vector<NamedFile> all = presets();
    ASSERT_GE(all.size(), 27U);
    EXPECT_EQ(all.front().name, "opening");
    EXPECT_EQ(all.front().group, "");
    std::size_t grouped = 0;
    for (const NamedFile& preset : all) {
        SCOPED_TRACE(preset.name);
        EXPECT_NE(preset.title, preset.name);
        EXPECT_TRUE(preset.about.ends_with("."));
        grouped += preset.group.empty() ? 0U : 1U;
        const Result<LoadedState> state = load_state(preset.name);
        ASSERT_TRUE(state) << state.error();
        const Result<Scene> scene = load_scene(state->params.scene, state->base, state->params.coplanar);
        ASSERT_TRUE(scene) << scene.error();
        EXPECT_TRUE(preset.name == "opening" || state->params != Params{}) << "must differ from the opening state";
        Params clamped = state->params;
        clamp_to_ranges(clamped);
        EXPECT_EQ(clamped, state->params);
    }
    EXPECT_GT(grouped, all.size() - 10);
}

TEST(Presets, FollowTheLectureSlideBySlide) {
    const std::vector<NamedFile> all = presets();
    int slide = 0;
    for (const NamedFile& preset : all) {
        const int own = preset.slides.empty() ? 0 : preset.slides.front();
        EXPECT_GE(own, slide) << preset.name;
        slide = own;
    }
    EXPECT_EQ(slide, 24);
    // lecture.json must name each preset once and nothing else. A preset missing there would come after the last topic.
    const std::string order = *read_text_file(assets_directory() / "lecture.json");
    std::size_t at = 0;
    for (const NamedFile& preset : all) {
        const std::size_t next = order.find('"' + preset.name + '"');
        ASSERT_NE(next, std::string::npos) << preset.name << " is missing from lecture.json";
        EXPECT_GT(next, at) << preset.name;
        at = next;
    }
    EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(order, ',')) + 1, all.size());
}

TEST(Presets, StateKnowsItsPreset) {
    const Result<LoadedState> walk = load_state("walk"), opening = load_state("");
    ASSERT_TRUE(walk && walk->preset);
    EXPECT_EQ(walk->preset->name, "walk");
    EXPECT_EQ(walk->preset->params, walk->params);
    ASSERT_TRUE(opening && opening->preset);
    EXPECT_EQ(opening->preset->name, "opening");
    const Result<LoadedState> file = load_state((assets_directory() / "presets" / "walk.json").string());
    ASSERT_TRUE(file);
    EXPECT_FALSE(file->preset) << "a custom file has no sentence";
}

/// As the first slides say, moving the camera and moving the world are equivalent.
TEST(Presets, MovingTheWorldByMinusTenMovesTheCameraByTen) {
    const Params camera = load_state("camera-plus-ten")->params, world = load_state("world-minus-ten")->params;
    const glm::dvec3 step(0.0, 0.0, 10.0);
    EXPECT_EQ(camera.camera.position - world.camera.position, step);
    EXPECT_EQ(glm::dvec3(camera.lights.front().position - world.lights.front().position), step);
    const auto& here = std::get<SceneDescription>(camera.scene).objects;
    const auto& there = std::get<SceneDescription>(world.scene).objects;
    ASSERT_EQ(here.size(), there.size());
    for (std::size_t i = 0; i < here.size(); ++i)
        EXPECT_LT(glm::distance(here[i].position - there[i].position, step), 1e-12) << here[i].name;
    EXPECT_EQ(camera.planes.front().equation + glm::dvec4(0.0, 0.0, 0.0, 10.0), world.planes.front().equation);
}

TEST(Presets, IncludeThoseOfTheLecture) {
    std::vector<std::string> names;
    for (const NamedFile& preset : presets()) {
        names.push_back(preset.name);
    }
    for (const char* name : {"teapot",
                             "interpenetrating",
                             "cyclic-overlap",
                             "coplanar",
                             "walkthrough",
                             "letters",
                             "curved",
                             "depth-test-off",
                             "back-faces-culled",
                             "front-faces-culled",
                             "inside-out",
                             "parallel-light",
                             "wall-mirror",
                             "tilted-plane",
                             "depth-fighting",
                             "walk",
                             "orbit",
                             "orthographic",
                             "shadow-double-blend",
                             "shadow-off-the-edge",
                             "shadow-fights",
                             "mirror-off-the-edge",
                             "mirror-unclipped",
                             "mirror-inside-out",
                             "projector",
                             "light-theme"}) {
        EXPECT_NE(std::ranges::find(names, name), names.end()) << name;
    }
}

TEST(Presets, OpeningIsTheDefaults) {
    const Result<LoadedState> left_out = load_state("");
    const Result<LoadedState> named = load_state("opening");
    ASSERT_TRUE(left_out && named);
    EXPECT_EQ(left_out->params, Params{});
    EXPECT_EQ(named->params, Params{});
    EXPECT_EQ(left_out->base, named->base);
}

TEST(Presets, UnknownNameSuggestsTheNearest) {
    const Result<LoadedState> state = load_state("orthografic");
    ASSERT_FALSE(state);
    EXPECT_NE(state.error().find("orthografic: neither a file nor a preset (viewing-sandbox presets lists them); did "
                                 "you mean orthographic?"),
              std::string::npos)
        << state.error();
}

TEST_F(SceneFiles, StatesAreFoundByPath) {
    const std::filesystem::path file = write("s.json", R"({"camera": {"yaw": 5}, "scene": "room.json"})");
    write("room.json", R"({"objects": []})");
    const Result<LoadedState> state = load_state(file.string());
    ASSERT_TRUE(state) << state.error();
    EXPECT_EQ(state->params.camera.yaw, 5.0);
    EXPECT_EQ(state->base, folder_);
    EXPECT_TRUE(load_scene(state->params.scene, state->base, state->params.coplanar));

    EXPECT_EQ(load_state((folder_ / "no.json").string()).error(), (folder_ / "no.json").string() + ": no such file");
    EXPECT_NE(load_state(folder_.string()).error().find("is a directory"), std::string::npos);
    const std::string bad = write("bad.json", R"({"projection": {"naer": 1}})").string();
    EXPECT_EQ(load_state(bad).error(), bad + ": projection.naer: no such field; did you mean projection.near?");
}

TEST_F(SceneFiles, StatesAreReadFromNamedText) {
    const Result<LoadedState> state = state_in_text(R"({"camera": {"yaw": 6}})", "standard input");
    ASSERT_TRUE(state) << state.error();
    EXPECT_EQ(state->params.camera.yaw, 6.0);
    const Result<LoadedState> refused = state_in_text("{", "standard input");
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().rfind("standard input: line 1", 0), 0U) << refused.error();
}

}  // namespace
}  // namespace viewing
