// The hidden-surface methods: each of the speeds that they are to have, on one core and by CPU time, beside what is
// wanted. Reports, never fails.
//
//     visibility-bench              a table, in Google Benchmark's form and with its flags
//     visibility-bench --curves     time and dominant operation of every method on 10 … 100,000 polygons, as CSV
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <string_view>
#include <vector>

#include "geometry/camera.h"
#include "geometry/projection.h"
#include "geometry/shapes.h"
#include "visibility/bsp.h"
#include "visibility/growth.h"
#include "visibility/newell.h"
#include "visibility/ray_cast.h"
#include "visibility/software_zbuffer.h"

namespace viewing {
namespace {

constexpr int width = 1280, height = 720;

std::vector<Polygon> small_triangles(int count) {
    return growth_polygons({.scene = GrowthScene::small_triangles}, count);
}

std::vector<Polygon> polygons_of(const Mesh& mesh) {
    const MeshInstance instance{&mesh, glm::dmat4(1.0)};
    return viewing::polygons_of(std::span(&instance, 1)).polygons;
}

/// At fovy 40° the shapes, of size 2 about the origin, fill the picture's height.
Viewpoint viewpoint(const glm::dvec3& target = glm::dvec3(0.0), double fovy_deg = 40.0) {
    const glm::dvec3 eye(1.0, 1.4, 3.0);
    return {view_from_world(world_from_view(eye, angles_looking_at(eye, target))),
            clip_from_view({.fovy_deg = fovy_deg, .near = 0.5, .far = 10.0}, static_cast<double>(width) / height)};
}

void bsp_build(benchmark::State& state) {
    const std::vector<Polygon> polygons = small_triangles(10'000);
    for (auto _ : state) benchmark::DoNotOptimize(build_bsp(polygons));
    const BspTree tree = build_bsp(polygons);
    state.counters["fragments"] = static_cast<double>(tree.fragments.size());
    state.counters["depth"] = tree.counters.depth;
}
BENCHMARK(bsp_build)->Unit(benchmark::kMillisecond);

void bsp_walk(benchmark::State& state) {
    const BspTree tree = build_bsp(small_triangles(10'000));
    const glm::dvec4 eye = viewpoint().eye_world();
    for (auto _ : state) benchmark::DoNotOptimize(walk_bsp(tree, eye, BspOrder::back_to_front));
}
BENCHMARK(bsp_walk)->Unit(benchmark::kMillisecond);

void newell_teapot(benchmark::State& state) {
    const std::vector<Polygon> polygons = polygons_of(teapot_mesh(4));
    for (auto _ : state) benchmark::DoNotOptimize(newell_order(polygons, viewpoint()));
    state.counters["triangles"] = static_cast<double>(polygons.size());
    state.counters["pairs"] = static_cast<double>(newell_order(polygons, viewpoint()).counters.pairs);
}
BENCHMARK(newell_teapot)->Unit(benchmark::kMillisecond);

void z_buffer(benchmark::State& state, const std::vector<Polygon>& polygons) {
    const glm::dmat4 clip_from_world = viewpoint().clip_from_world();
    RasterCounters counters;
    for (auto _ : state) counters = rasterise(polygons, clip_from_world, {.width = width, .height = height}).counters;
    const auto iterations = static_cast<double>(state.iterations());
    state.counters["triangles"] = {iterations * static_cast<double>(counters.polygons), benchmark::Counter::kIsRate};
    state.counters["pixels"] = {iterations * static_cast<double>(counters.pixels_tested), benchmark::Counter::kIsRate};
    state.counters["pixels_each"] = static_cast<double>(counters.pixels_tested) / static_cast<double>(polygons.size());
}

/// 100 large squares one before the other, the nearest drawn last.
std::vector<Polygon> squares() {
    std::vector<Polygon> polygons;
    for (int i = 0; i < 100; ++i) {
        const double z = -1.0 + 0.02 * i;
        polygons.push_back(*make_polygon({{-1, -1, z}, {1, -1, z}, {1, 1, z}, {-1, 1, z}}, i, i));
    }
    return polygons;
}
BENCHMARK_CAPTURE(z_buffer, small_triangles, polygons_of(sphere_mesh(400, 200)))->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(z_buffer, large_squares, squares())->Unit(benchmark::kMillisecond);

void ray_casting(benchmark::State& state, const Mesh& mesh, const Viewpoint& seen_from) {
    const std::vector<Polygon> polygons = polygons_of(mesh);
    const RayScene scene(polygons);
    const glm::dmat4 clip_from_world = seen_from.clip_from_world();
    RayCastResult result;
    for (auto _ : state) result = cast_rays(scene, clip_from_world, {.width = width, .height = height});
    const RayCounters& counters = result.counters;
    const auto misses = std::count(result.image.ids.begin(), result.image.ids.end(), IdImage::background);
    const auto iterations = static_cast<double>(state.iterations());
    const auto rays = static_cast<double>(counters.rays);
    state.counters["triangles"] = static_cast<double>(polygons.size());
    state.counters["hits"] = 1.0 - static_cast<double>(misses) / rays;
    state.counters["rays"] = {iterations * rays, benchmark::Counter::kIsRate};
    state.counters["boxes_a_ray"] = static_cast<double>(counters.box_tests) / rays;
    state.counters["tests_a_ray"] = static_cast<double>(counters.triangle_tests) / rays;
}
// The whole torus, its tube so near that every ray hits it, and the teapot.
BENCHMARK_CAPTURE(ray_casting, torus, torus_mesh(320, 157), viewpoint())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(ray_casting, torus_near, torus_mesh(320, 157), viewpoint({0.0, 0.0, 0.9}, 6.0))
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(ray_casting, teapot, teapot_mesh(40), viewpoint())->Unit(benchmark::kMillisecond);

void hierarchy_build(benchmark::State& state) {
    const std::vector<Polygon> polygons = polygons_of(torus_mesh(320, 157));
    for (auto _ : state) benchmark::DoNotOptimize(RayScene(polygons));
}
BENCHMARK(hierarchy_build)->Unit(benchmark::kMillisecond);

// ---- beside what is wanted ---------------------------------------------------------------------------

using Run = benchmark::BenchmarkReporter::Run;

struct Wanted {
    std::string_view name;
    const char* text;
    bool (*is_met)(const Run&);
};

double per_second(const Run& run, const char* counter) {
    return run.counters.at(counter).value;
}

constexpr Wanted wanted[] = {
    {"bsp_build", "<= 1 s", [](const Run& run) { return run.GetAdjustedCPUTime() <= 1000.0; }},
    {"bsp_walk", "<= 5 ms", [](const Run& run) { return run.GetAdjustedCPUTime() <= 5.0; }},
    {"newell_teapot", "<= 50 ms", [](const Run& run) { return run.GetAdjustedCPUTime() <= 50.0; }},
    {"z_buffer/small_triangles", ">= 5 M triangles/s",
     [](const Run& run) { return per_second(run, "triangles") >= 5e6; }},
    {"z_buffer/large_squares", ">= 100 M pixels/s", [](const Run& run) { return per_second(run, "pixels") >= 100e6; }},
    {"ray_casting/torus", ">= 3 M rays/s", [](const Run& run) { return per_second(run, "rays") >= 3e6; }},
    {"ray_casting/torus_near", ">= 3 M rays/s", [](const Run& run) { return per_second(run, "rays") >= 3e6; }},
    {"ray_casting/teapot", ">= 3 M rays/s", [](const Run& run) { return per_second(run, "rays") >= 3e6; }}};

/// Google Benchmark's table with a verdict at the end of the lines that have a bound.
class Verdicts : public benchmark::ConsoleReporter {
public:
    Verdicts() : ConsoleReporter(OO_Tabular) {}

    void ReportRuns(const std::vector<Run>& runs) override {
        std::vector<Run> labelled = runs;
        for (Run& run : labelled) {
            const auto* bound = std::find_if(std::begin(wanted), std::end(wanted),
                                             [&](const Wanted& entry) { return run.benchmark_name() == entry.name; });
            if (bound == std::end(wanted) || run.error_occurred) continue;
            run.report_label = std::string(bound->text) + (bound->is_met(run) ? " met" : " MISSED");
        }
        ConsoleReporter::ReportRuns(labelled);
    }
};

void print_curves(GrowthScene scene, const char* title) {
    const std::vector<GrowthRow> rows = measure_growth({.scene = scene});
    std::printf("%s\n%s%s\n", title, growth_csv(rows).c_str(),
                (growth_summary(rows) + " " + growth_times(rows)).c_str());
}

}  // namespace
}  // namespace viewing

int main(int argc, char** argv) {
    using namespace viewing;
    if (argc == 2 && std::string_view(argv[1]) == "--curves") {
        print_curves(GrowthScene::small_triangles, "Small triangles");
        print_curves(GrowthScene::large_triangles, "Large triangles");
        return 0;
    }
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    Verdicts verdicts;
    benchmark::RunSpecifiedBenchmarks(&verdicts);
    return 0;
}
