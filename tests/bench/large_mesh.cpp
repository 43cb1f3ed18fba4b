// Measures how much a million-triangle mesh adds to a frame's cost in our own code, compared with an empty scene. While
// the camera or the light moves, each frame recomputes the derived values, the plan, the problems and whatever the
// lower views request. This program only reports; it never fails.
#include <benchmark/benchmark.h>

#include "frame/problems.h"
#include "geometry/shapes.h"
#include "state/file/state_json.h"
#include "topics/depth/numbers/near_advice.h"

namespace viewing {
namespace {

enum class Moving { camera, light };

constexpr int around_a_million = 1000, up_a_million = 501;  ///< segments of a ball
constexpr Viewport viewport{{1280, 720}, true};

/// Makes a ball so close to a sloping plane that the scene's bounding box does not tell which side the ball is on.
Scene scene_of(int around, int up) {
    Scene scene;
    if (around == 0) return scene;
    ObjectDescription description;
    description.name = "ball";
    description.position = {0.0, 1.0, 0.0};
    SceneObject ball{std::move(description), std::make_shared<const Mesh>(sphere_mesh(around, up)),
                     world_from_model({0.0, 1.0, 0.0}, {}, glm::dvec3(1.0))};
    for (const glm::vec3& position : ball.mesh->positions)
        scene.bounds_world.add(glm::dvec3(ball.world_from_model * glm::dvec4(position, 1.0)));
    scene.objects.push_back(std::move(ball));
    return scene;
}

/// Enables every switch whose message depends on the positions of objects.
Params busy_params() {
    const std::vector<std::string> settings{
        "plane.equation=[1,1,1,0.866]", "light.position=[1.1,2.6,0.9,1]", "shadow.clip_casters=false",
        "reflection.clip=none",         "shadow.clip_to_receiver=false",  "reflection.stencil=false",
        "shadow.clip_at_light=false",   "reflection.after_objects=true",  "plane.extent=6",
    };
    return *apply_settings(Params{}, settings);
}

void step(Params& params, Moving moving, int at) {
    const double by = at % 2 == 0 ? 0.02 : -0.02;
    if (moving == Moving::camera)
        params.camera.position.x += by;
    else
        params.lights.front().position.x += by;
}

void think(const Params& params, const Scene& scene) {
    const Derived derived = derive(params, scene, viewport);
    const FramePlan made = plan(params, derived);
    benchmark::DoNotOptimize(contrast_range(params, derived, scene));
    benchmark::DoNotOptimize(find_problems(params, derived, scene, made));
}

/// Computes what the precision view requests.
void advise(const Params& params, const Scene& scene) {
    benchmark::DoNotOptimize(near_advice(params, derive(params, scene, viewport), scene));
}

/// Measures all frames but the first one, which fills the scene's caches.
void frame(benchmark::State& state, void (*ask)(const Params&, const Scene&), Moving moving, int around, int up) {
    const Scene scene = scene_of(around, up);
    Params params = busy_params();
    ask(params, scene);
    int at = 0;
    for (auto _ : state) {
        step(params, moving, at++);
        ask(params, scene);
    }
}

void first_frame(benchmark::State& state, void (*ask)(const Params&, const Scene&)) {
    const Params params = busy_params();
    for (auto _ : state) {
        state.PauseTiming();
        const Scene scene = scene_of(around_a_million, up_a_million);
        state.ResumeTiming();
        ask(params, scene);
    }
}

#define FOR_BOTH(ask, moving)                                                                                 \
    BENCHMARK_CAPTURE(frame, ask##_empty_##moving, ask, Moving::moving, 0, 0)->Unit(benchmark::kMicrosecond); \
    BENCHMARK_CAPTURE(frame, ask##_million_##moving, ask, Moving::moving, around_a_million, up_a_million)     \
        ->Unit(benchmark::kMicrosecond)
FOR_BOTH(think, camera);
FOR_BOTH(think, light);
FOR_BOTH(advise, camera);
FOR_BOTH(advise, light);
BENCHMARK_CAPTURE(first_frame, think, think)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(first_frame, advise, advise)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace viewing

BENCHMARK_MAIN();
