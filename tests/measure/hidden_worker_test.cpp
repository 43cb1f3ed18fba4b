// Methods computed in the background: the final answer is correct, canceled work is reported, and no request stays
// pending.
#include "topics/hidden/measured/hidden_worker.h"

#include <gtest/gtest.h>

#include <chrono>
#include <limits>
#include <thread>

#include "state/file/state_json.h"
#include "topics/hidden/numbers/scene_surface.h"

namespace viewing {
namespace {

constexpr glm::ivec2 worked_px(160, 90);

Params params_with(const std::vector<std::string>& settings) {
    const Result<Params> params = apply_settings(Params{}, settings);
    EXPECT_TRUE(params) << params.error();
    return *params;
}

HiddenQuestion question_for(const Params& params, const Scene& scene) {
    const std::optional<HiddenQuestion> question =
        hidden_question(params, derive(params, scene, {worked_px, true}), worked_px);
    EXPECT_TRUE(question);
    return *question;
}

Scene scene_of(const std::string& name) {
    const Result<Scene> scene = load_scene(name, "");
    EXPECT_TRUE(scene) << scene.error();
    return *scene;
}

/// Returns a scene that is slow on purpose: it has many large intersecting triangles, which a BSP tree splits into
/// millions.
Scene slow_scene() {
    Scene scene = scene_of("interpenetrating");
    auto mesh = std::make_shared<Mesh>();
    unsigned state = 7;
    const auto random = [&state] {
        state = state * 1664525U + 1013904223U;
        return static_cast<float>(state >> 8U) / 16777216.0F * 2.0F - 1.0F;
    };
    for (std::uint32_t corner = 0; corner < 3 * 3000; ++corner) {
        mesh->positions.push_back({random(), random(), random()});
        mesh->normals.push_back({0.0F, 1.0F, 0.0F});
        mesh->indices.push_back(corner);
    }
    scene.objects.resize(1);
    scene.objects.front().mesh = mesh;
    return scene;
}

TEST(HiddenWorker, EqualsTheSynchronousAnswer) {
    const Scene scene = scene_of("cyclic-overlap");
    for (const char* const method : {"painter", "newell", "bsp", "software_depth_buffer", "ray_cast"}) {
        const HiddenQuestion question =
            question_for(params_with({std::string("visibility.method=") + method, "scene=cyclic-overlap"}), scene);
        HiddenWorker worker;
        worker.ask(question, scene, 1);
        worker.wait(-1.0);
        const auto answer = worker.answer(1);
        ASSERT_TRUE(answer) << method;
        HiddenSurfaceSolver solver(scene);
        const HiddenAnswer at_once = answer_hidden_question(solver, question);
        EXPECT_EQ(answer->camera->image.ids, at_once.camera->image.ids) << method;
        EXPECT_EQ(answer->camera->order, at_once.camera->order) << method;
        EXPECT_FALSE(worker.fraction()) << method;
        EXPECT_FALSE(worker.answer(2)) << "another scene has no answer yet";

        worker.ask(question, scene, 1);
        EXPECT_FALSE(worker.fraction()) << "an answered request is not computed again";
        EXPECT_EQ(worker.answer(1), answer);
    }
}

TEST(HiddenWorker, AnswersTheLastRequestOfAMovingCamera) {
    const Scene scene = scene_of("torus-and-boxes");
    Params params = params_with({"visibility.method=bsp"});
    HiddenWorker worker;
    HiddenQuestion question = question_for(params, scene);
    for (int frame = 0; frame < 60; ++frame) {
        params.camera.yaw += 1.0;
        question = question_for(params, scene);
        worker.ask(question, scene, 1);
        worker.wait(0.002);
    }
    worker.wait(-1.0);
    ASSERT_TRUE(worker.answer(1));
    EXPECT_EQ(worker.answer(1)->question, question);
}

TEST(HiddenWorker, CanceledWorkIsReportedAndNotRestarted) {
    const Scene scene = slow_scene();
    const HiddenQuestion question = question_for(params_with({"visibility.method=bsp"}), scene);
    HiddenWorker worker;
    worker.ask(question, scene, 1);
    while (!worker.fraction() || *worker.fraction() <= 0.0F) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    worker.cancel();
    worker.wait(-1.0);
    ASSERT_TRUE(worker.answer(1));
    EXPECT_FALSE(worker.answer(1)->problem().empty());
    worker.ask(question, scene, 1);
    EXPECT_FALSE(worker.fraction());
}

/// A canceled solver may lack part of the scene, so the next request must get a complete solver.
TEST(HiddenWorker, ARequestAfterACancelGetsTheWholeScene) {
    const Scene scene = slow_scene();
    const HiddenQuestion painter = question_for(params_with({"visibility.method=painter"}), scene);
    for (int run = 0; run < 20; ++run) {
        HiddenWorker worker;
        worker.ask(question_for(params_with({"visibility.method=bsp"}), scene), scene, 1);
        std::this_thread::sleep_for(std::chrono::microseconds(50 * run));
        worker.cancel();
        worker.ask(painter, scene, 1);
        worker.wait(-1.0);
        ASSERT_TRUE(worker.answer(1));
        EXPECT_EQ(worker.answer(1)->camera->surface->polygons.size(), surface_of(scene).polygons.size());
    }
}

TEST(HiddenWorker, AnotherMethodDoesNotWaitForASlowOne) {
    const Scene scene = slow_scene();
    HiddenWorker worker;
    worker.ask(question_for(params_with({"visibility.method=bsp"}), scene), scene, 1);
    while (!worker.fraction() || *worker.fraction() <= 0.0F) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    const HiddenQuestion other = question_for(params_with({"visibility.method=painter"}), scene);
    worker.ask(other, scene, 1);
    worker.wait(-1.0);
    ASSERT_TRUE(worker.answer(1));
    EXPECT_EQ(worker.answer(1)->question, other);
    EXPECT_TRUE(worker.answer(1)->problem().empty()) << say(worker.answer(1)->problem());
}

TEST(HiddenWorker, FailedWorkIsReportedOnceAndNotRestarted) {
    const Scene scene = scene_of("cyclic-overlap");
    const HiddenQuestion small = question_for(params_with({"visibility.method=software_depth_buffer"}), scene);
    HiddenQuestion huge = small;
    huge.camera.size_px = glm::ivec2(std::numeric_limits<int>::max());  // no memory can hold so large a picture
    HiddenWorker worker;
    worker.ask(huge, scene, 1);
    worker.wait(-1.0);
    EXPECT_FALSE(worker.answer(1));
    EXPECT_TRUE(worker.has_failed(huge, 1));
    EXPECT_FALSE(worker.has_failed(huge, 2)) << "another scene may succeed";
    const std::optional<std::string> why = worker.take_failure();
    ASSERT_TRUE(why);
    EXPECT_NE(why->find("stopped"), std::string::npos) << *why;
    EXPECT_FALSE(worker.take_failure());
    worker.ask(huge, scene, 1);
    EXPECT_FALSE(worker.fraction()) << "restarted";

    worker.ask(small, scene, 1);
    worker.wait(-1.0);
    EXPECT_FALSE(worker.has_failed(huge, 1));
    ASSERT_TRUE(worker.answer(1));
    HiddenSurfaceSolver solver(scene);
    EXPECT_EQ(worker.answer(1)->camera->image.ids, answer_hidden_question(solver, small).camera->image.ids);
}

TEST(HiddenWorker, CanBeDestroyedWhileWorking) {
    const Scene scene = slow_scene();
    HiddenWorker worker;
    worker.ask(question_for(params_with({"visibility.method=newell"}), scene), scene, 1);
    while (worker.fraction() && *worker.fraction() <= 0.0F) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

}  // namespace
}  // namespace viewing
