// Measures the speed of the hidden-surface methods on one core, in CPU time, against their targets. It only reports and
// never fails.
//
// visibility-bench              prints a table in Google Benchmark's form and takes its flags; compares ray casting
//                               with Embree's single rays through the same pixels, our hierarchy with Embree's, and
//                               the z-buffer with llvmpipe, all on one thread
// visibility-bench --curves     prints the time and dominant operation of every method on 10 … 100,000 polygons, as CSV
#include <benchmark/benchmark.h>
#include <embree3/rtcore.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <string_view>
#include <vector>

#include "geometry/camera.h"
#include "geometry/projection.h"
#include "geometry/shapes.h"
#include "gl/egl_context.h"
#include "gl/gl.h"
#include "gl/target.h"
#include "topics/hidden/methods/bsp.h"
#include "topics/hidden/methods/growth.h"
#include "topics/hidden/methods/newell.h"
#include "topics/hidden/methods/ray_cast.h"
#include "topics/hidden/methods/software_zbuffer.h"

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

/// Returns a view in which, with the default fovy, shapes of size 2 at the origin fill the picture's height.
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

void bsp_build_large(benchmark::State& state) {
    const std::vector<Polygon> polygons = small_triangles(100'000);
    for (auto _ : state) benchmark::DoNotOptimize(build_bsp(polygons));
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    state.counters["process_mb"] = static_cast<double>(usage.ru_maxrss) / 1024.0;
}
BENCHMARK(bsp_build_large)->Unit(benchmark::kMillisecond);

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

void newell_large(benchmark::State& state) {
    const std::vector<Polygon> polygons = growth_polygons({.scene = GrowthScene::large_triangles}, 100);
    for (auto _ : state) benchmark::DoNotOptimize(newell_order(polygons, viewpoint({}, 60.0), {.max_steps = 0}));
    state.counters["pairs"] = static_cast<double>(newell_order(polygons, viewpoint({}, 60.0)).counters.pairs);
}
BENCHMARK(newell_large)->Unit(benchmark::kMillisecond);

void z_buffer(benchmark::State& state, const std::vector<Polygon>& polygons) {
    const glm::dmat4 clip_from_world = viewpoint().clip_from_world();
    RasterCounters counters;
    for (auto _ : state) counters = rasterize(polygons, clip_from_world, {.width = width, .height = height}).counters;
    const auto iterations = static_cast<double>(state.iterations());
    state.counters["triangles"] = {iterations * static_cast<double>(counters.polygons), benchmark::Counter::kIsRate};
    state.counters["pixels"] = {iterations * static_cast<double>(counters.pixels_tested), benchmark::Counter::kIsRate};
    state.counters["pixels_each"] = static_cast<double>(counters.pixels_tested) / static_cast<double>(polygons.size());
}

/// Makes 100 large squares one behind the other; the nearest is drawn last.
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

Mesh torus() {
    return torus_mesh(320, 157);
}
// `whole` shows the whole torus or teapot; `near_tube` is so close to the torus's tube that every ray hits it.
const Viewpoint whole = viewpoint(), near_tube = viewpoint({0.0, 0.0, 0.9}, 6.0);

// ---- the z-buffer in llvmpipe ------------------------------------------------------------------------

/// Draws the polygons' triangles with GL's depth test. The shaders transform the triangles and write the numbers of
/// their polygons as colors. Uploads the triangles once, so only drawing is measured.
void gl_z_buffer(benchmark::State& state, const std::vector<Polygon>& polygons) {
    Result<gl::EglContext> context = gl::EglContext::make();
    if (!context) return state.SkipWithError(context.error().c_str());
    std::vector<glm::vec4> corners;  // a corner's position and its polygon's number
    for (const Polygon& polygon : polygons)
        for (std::size_t k = 1; k + 1 < polygon.vertices.size(); ++k)
            for (const std::size_t corner : {std::size_t{0}, k, k + 1})
                corners.emplace_back(glm::vec3(polygon.vertices[corner]), static_cast<float>(polygon.source));
    const gl::Program program = *gl::make_program(R"(
        layout(location = 0) in vec4 corner;
        uniform mat4 clip_from_world;
        flat out float number;
        void main() { gl_Position = clip_from_world * vec4(corner.xyz, 1.0); number = corner.w; })",
                                                  R"(
        flat in float number;
        out vec4 color;
        void main() { color = vec4(mod(number, 256.0), mod(floor(number / 256.0), 256.0), floor(number / 65536.0), 255.0) / 255.0; })");
    const gl::Target target({{width, height}});
    const gl::VertexArray array = gl::make_vertex_array();
    const gl::Buffer buffer = gl::make_buffer();
    glBindVertexArray(array.name());
    glBindBuffer(GL_ARRAY_BUFFER, buffer.name());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(corners.size() * sizeof(corners[0])), corners.data(),
                 GL_STATIC_DRAW);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, 0, nullptr);
    glUseProgram(program.name());
    const glm::mat4 clip_from_world(viewpoint().clip_from_world());
    glUniformMatrix4fv(glGetUniformLocation(program.name(), "clip_from_world"), 1, GL_FALSE, &clip_from_world[0][0]);
    glBindFramebuffer(GL_FRAMEBUFFER, target.draw_framebuffer());
    glViewport(0, 0, width, height);
    glEnable(GL_DEPTH_TEST);
    for (auto _ : state) {
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners.size()));
        glFinish();
    }
    state.counters["triangles"] = {static_cast<double>(state.iterations()) * static_cast<double>(polygons.size()),
                                   benchmark::Counter::kIsRate};
}
BENCHMARK_CAPTURE(gl_z_buffer, small_triangles, polygons_of(sphere_mesh(400, 200)))->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(gl_z_buffer, large_squares, squares())->Unit(benchmark::kMillisecond);

void count_rays(benchmark::State& state, const IdImage& image) {
    const auto misses = static_cast<double>(std::count(image.ids.begin(), image.ids.end(), IdImage::background));
    const auto rays = static_cast<double>(image.ids.size());
    state.counters["hits"] = 1.0 - misses / rays;
    state.counters["rays"] = {static_cast<double>(state.iterations()) * rays, benchmark::Counter::kIsRate};
}

void ray_casting(benchmark::State& state, const Mesh& mesh, const Viewpoint& seen_from) {
    const std::vector<Polygon> polygons = polygons_of(mesh);
    const RayScene scene(polygons);
    const glm::dmat4 clip_from_world = seen_from.clip_from_world();
    RayCastResult result;
    for (auto _ : state) result = cast_rays(scene, clip_from_world, {.width = width, .height = height});
    const RayCounters& counters = result.counters;
    count_rays(state, result.image);
    state.counters["triangles"] = static_cast<double>(polygons.size());
    state.counters["boxes_a_ray"] = static_cast<double>(counters.box_tests) / static_cast<double>(counters.rays);
    state.counters["tests_a_ray"] = static_cast<double>(counters.triangle_tests) / static_cast<double>(counters.rays);
}
BENCHMARK_CAPTURE(ray_casting, torus, torus(), whole)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(ray_casting, torus_near, torus(), near_tube)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(ray_casting, teapot, teapot_mesh(40), whole)->Unit(benchmark::kMillisecond);

void hierarchy_build(benchmark::State& state) {
    const std::vector<Polygon> polygons = polygons_of(torus());
    for (auto _ : state) benchmark::DoNotOptimize(RayScene(polygons));
}
BENCHMARK(hierarchy_build)->Unit(benchmark::kMillisecond);

// ---- ray casting in Embree ---------------------------------------------------------------------------

/// An Embree device with one mesh. It works only on the calling thread.
class Embree {
public:
    explicit Embree(const Mesh& mesh)
        : device_(rtcNewDevice("threads=1,set_affinity=0")), scene_(rtcNewScene(device_)) {
        const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        const auto put = [&](RTCBufferType type, RTCFormat format, std::size_t stride, const auto& values) {
            void* buffer =
                rtcSetNewGeometryBuffer(geometry, type, 0, format, stride, values.size() * sizeof(values[0]) / stride);
            std::memcpy(buffer, values.data(), values.size() * sizeof(values[0]));
        };
        put(RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), mesh.positions);
        put(RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), mesh.indices);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene_);
    }
    ~Embree() {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }
    Embree(const Embree&) = delete;
    Embree& operator=(const Embree&) = delete;

    /// Returns the number of the nearest triangle, or IdImage::background if the ray hits none.
    int nearest(const Ray& ray, double max_t) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
        const glm::vec3 origin(ray.origin), direction(ray.direction);
        RTCRayHit hit{};
        hit.ray = {
            origin.x, origin.y, origin.z, 0.0F, direction.x, direction.y, direction.z, 0.0F, static_cast<float>(max_t),
            ~0U,      0,        0};
        hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(scene_, &context, &hit);
        return hit.hit.geomID == RTC_INVALID_GEOMETRY_ID ? IdImage::background : static_cast<int>(hit.hit.primID);
    }

private:
    RTCDevice device_;
    RTCScene scene_;
};

void embree_rays(benchmark::State& state, const Mesh& mesh, const Viewpoint& seen_from) {
    const Embree embree(mesh);
    IdImage image(width, height);
    for (auto _ : state) {
        const PixelRays rays(seen_from.clip_from_world(), width, height);
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const auto [ray, max_t] = rays.through(x, y);
                image.ids[image.index(x, y)] = embree.nearest(ray, max_t);
            }
        }
    }
    count_rays(state, image);
}
BENCHMARK_CAPTURE(embree_rays, torus, torus(), whole)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(embree_rays, torus_near, torus(), near_tube)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(embree_rays, teapot, teapot_mesh(40), whole)->Unit(benchmark::kMillisecond);

void embree_build(benchmark::State& state) {
    const Mesh mesh = torus();
    for (auto _ : state) benchmark::DoNotOptimize(Embree(mesh).nearest({{0.0, 0.0, 9.0}, {0.0, 0.0, -1.0}}, 1.0));
}
BENCHMARK(embree_build)->Unit(benchmark::kMillisecond);

// ---- against the targets -----------------------------------------------------------------------------

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
    {"bsp_build_large", "<= 1 s, 300 MB",
     [](const Run& run) { return run.GetAdjustedCPUTime() <= 1000.0 && run.counters.at("process_mb") <= 300.0; }},
    {"bsp_walk", "<= 5 ms", [](const Run& run) { return run.GetAdjustedCPUTime() <= 5.0; }},
    {"newell_teapot", "<= 50 ms", [](const Run& run) { return run.GetAdjustedCPUTime() <= 50.0; }},
    {"z_buffer/small_triangles", ">= 5 M triangles/s",
     [](const Run& run) { return per_second(run, "triangles") >= 5e6; }},
    {"z_buffer/large_squares", ">= 100 M pixels/s", [](const Run& run) { return per_second(run, "pixels") >= 100e6; }},
    {"ray_casting/torus", ">= 3 M rays/s", [](const Run& run) { return per_second(run, "rays") >= 3e6; }},
    {"ray_casting/torus_near", ">= 3 M rays/s", [](const Run& run) { return per_second(run, "rays") >= 3e6; }},
    {"ray_casting/teapot", ">= 3 M rays/s", [](const Run& run) { return per_second(run, "rays") >= 3e6; }}};

/// Google Benchmark's table with a verdict at the end of each line that has a bound.
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
                (say(growth_summary(rows)) + " " + say(growth_times(rows))).c_str());
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
    setenv("LP_NUM_THREADS", "0", 1);  // llvmpipe draws on the calling thread
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    Verdicts verdicts;
    benchmark::RunSpecifiedBenchmarks(&verdicts);
    return 0;
}
