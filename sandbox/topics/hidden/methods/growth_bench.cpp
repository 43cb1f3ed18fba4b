// Runs each method as a caller would, and times it. Read growth_report.cpp next.
#include "topics/hidden/methods/growth_bench.h"

#include <algorithm>
#include <cmath>

#include "geometry/camera.h"
#include "geometry/projection.h"
#include "platform/stopwatch.h"
#include "text/per_enum.h"
#include "topics/hidden/methods/newell.h"
#include "topics/hidden/methods/painter.h"
#include "topics/hidden/methods/ray_cast.h"

namespace viewing {
namespace {

/// Returns a view from outside and slightly above, in which the sphere around the bounds touches the nearer edges of
/// the picture.
Viewpoint viewpoint_of_all(std::span<const Polygon> polygons, double aspect) {
    const Bounds bounds = bounds_of(polygons);
    const double radius = bounds.empty() ? 1.0 : std::max(0.5 * glm::length(bounds.size()), 1e-6);
    const glm::dvec3 center = bounds.empty() ? glm::dvec3(0.0) : bounds.center();
    Lens lens;
    const double narrow = std::atan(std::tan(0.5 * glm::radians(lens.fovy_deg)) * std::min(aspect, 1.0));
    const double distance = radius / std::sin(narrow);
    lens.near = 0.9 * (distance - radius);
    lens.far = 1.1 * (distance + radius);
    const glm::dvec3 eye = center + distance * glm::normalize(glm::dvec3(0.3, 0.4, 1.0));
    return {view_from_world(world_from_view(eye, angles_looking_at(eye, center))), clip_from_view(lens, aspect)};
}

}  // namespace

GrowthBench::GrowthBench(const GrowthRequest& request, int count)
    : request_(request),
      width_(std::max(request.width, 1)),
      height_(std::max(request.height, 1)),
      polygons_(growth_polygons(request, count)),
      viewpoint_(request.viewpoint ? *request.viewpoint
                                   : viewpoint_of_all(polygons_, static_cast<double>(width_) / height_)) {}

GrowthRow GrowthBench::run(GrowthMethod method, WorkProgress* progress) {
    GrowthRow row{.method = method,
                  .polygons = static_cast<int>(polygons_.size()),
                  .operation_name = growth_operation_name(method)};
    // In the order of GrowthMethod.
    static constexpr PerEnum<GrowthMethod, decltype(&GrowthBench::run_painter), growth_method_count> runs{
        &GrowthBench::run_painter,  &GrowthBench::run_newell,   &GrowthBench::run_bsp_build,
        &GrowthBench::run_bsp_walk, &GrowthBench::run_z_buffer, &GrowthBench::run_ray_casting};
    const Stopwatch whole;
    (this->*runs[method])(row, progress);
    row.time_ms = whole.ms();
    return row;
}

void GrowthBench::run_painter(GrowthRow& row, WorkProgress* progress) {
    const PainterOrder sorted = painter_order(polygons_, viewpoint_, PainterKey::farthest);
    row.operations = sorted.comparisons;
    paint(polygons_, sorted.order, row, progress);
}

void GrowthBench::run_newell(GrowthRow& row, WorkProgress* progress) {
    const NewellOptions options{
        .max_fragments = request_.max_fragments, .max_pairs = request_.max_pairs, .max_steps = 0};
    const NewellOrder sorted = newell_order(polygons_, viewpoint_, options, progress);
    row.operations = sorted.counters.pairs;
    row.problem = sorted.problem;
    paint(sorted.fragments, sorted.order, row, progress);
}

void GrowthBench::run_bsp_build(GrowthRow& row, WorkProgress* progress) {
    tree_ = build_bsp(polygons_, {.max_fragments = request_.max_fragments}, progress);
    row.operations = tree_.counters.plane_tests;
    row.problem = tree_.problem;
}

void GrowthBench::run_bsp_walk(GrowthRow& row, WorkProgress* progress) {
    const BspWalk walk = walk_bsp(tree_, viewpoint_.eye_world(), BspOrder::back_to_front);
    row.operations = static_cast<std::int64_t>(walk.visits.size());
    paint(tree_.fragments, walk.fragments, row, progress);
}

void GrowthBench::run_z_buffer(GrowthRow& row, WorkProgress* progress) {
    const RasterResult result =
        rasterize(polygons_, viewpoint_.clip_from_world(), {.width = width_, .height = height_}, progress);
    row.operations = result.counters.pixels_tested;
}

void GrowthBench::run_ray_casting(GrowthRow& row, WorkProgress* progress) {
    const Stopwatch building;
    const RayScene scene(polygons_, {}, progress);
    row.build_ms = building.ms();
    const RayCastResult result =
        cast_rays(scene, viewpoint_.clip_from_world(), {.width = width_, .height = height_}, progress);
    row.operations = result.counters.box_tests + result.counters.triangle_tests;
}

void GrowthBench::paint(std::span<const Polygon> drawn, std::span<const int> order, GrowthRow& row,
                        WorkProgress* progress) const {
    const Stopwatch painting;
    const RasterResult painted =
        rasterize(drawn, order, viewpoint_.clip_from_world(),
                  {.rule = PaintRule::overwrite, .width = width_, .height = height_}, progress);
    row.pixels_painted = painted.counters.pixels_written;
    row.painting_ms = painting.ms();
}

}  // namespace viewing
