// Ray casting: each step casts one pixel's ray. The steps of a row of pixels are a group.
#include <algorithm>
#include <iterator>

#include "platform/stopwatch.h"
#include "text/catalogue.h"
#include "topics/hidden/numbers/method_parts.h"

namespace viewing {
namespace {

/// Makes the hierarchy for rays, unless there is one already: without culling, it does not depend on the camera.
void find_rays(HiddenData& data, HiddenResult& result, WorkProgress* progress) {
    const HiddenRequest& request = result.request;
    const bool exact = uses_exact_curves(request);
    const std::vector<CurvedShape>& shapes = data.surface->curved;
    take_polygons(data, result, progress);
    if (exact) {
        auto flat = std::make_shared<std::vector<Polygon>>();
        const auto is_flat = [&](const Polygon& polygon) {
            return std::none_of(shapes.begin(), shapes.end(),
                                [&](const CurvedShape& shape) { return shape.object == polygon.object; });
        };
        std::copy_if(result.fragments->begin(), result.fragments->end(), std::back_inserter(*flat), is_flat);
        result.counters.polygons = static_cast<std::int64_t>(flat->size() + shapes.size());
        result.fragments = std::move(flat);
    }
    const bool serves = data.rays.scene && uses_exact_curves(data.rays.made_for) == exact &&
                        !data.rays.made_for.cull.enabled && !request.cull.enabled;
    if (!serves) {
        const Stopwatch watch;
        const std::span<const CurvedShape> curved = exact ? std::span(shapes) : std::span<const CurvedShape>();
        data.rays = {std::make_shared<const RayScene>(*result.fragments, curved, progress), request, 0.0};
        data.rays.build_ms = watch.ms();
    }
    result.build_ms = data.rays.build_ms;
    const glm::ivec2 size_px = request.size_px;
    result.step_count = size_px.x * size_px.y;
    for (int row = 1; row <= size_px.y; ++row) result.group_ends.push_back(row * size_px.x);
}

/// Returns the pixel whose ray is shown: the step's pixel or, without a step, the followed pixel.
std::optional<glm::ivec2> traced_pixel(const HiddenResult& result) {
    const HiddenRequest& request = result.request;
    const int columns = request.size_px.x;
    if (result.step > 0) return glm::ivec2((result.step - 1) % columns, (result.step - 1) / columns);
    const std::optional<glm::ivec2>& pixel = request.visibility.pixel;
    return pixel && glm::all(glm::lessThan(*pixel, request.size_px)) ? pixel : std::nullopt;
}

void trace(const RayScene& scene, HiddenResult& result, glm::ivec2 pixel) {
    const HiddenRequest& request = result.request;
    const auto [ray, max_t] =
        PixelRays(request.viewpoint.clip_from_world(), request.size_px.x, request.size_px.y).through(pixel.x, pixel.y);
    RayCounters uncounted;
    result.traced = TracedRay{pixel, ray, scene.all(ray, max_t, uncounted)};
}

void cast(HiddenData& data, HiddenResult& result, WorkProgress* progress) {
    const HiddenRequest& request = result.request;
    const Stopwatch watch;
    RayCastResult cast = cast_rays(*data.rays.scene, request.viewpoint.clip_from_world(),
                                   {request.size_px.x, request.size_px.y, result.step}, progress);
    result.time_ms = watch.ms();
    if (const std::optional<glm::ivec2> pixel = traced_pixel(result)) trace(*data.rays.scene, result, *pixel);
    HiddenCounters& counters = result.counters;
    counters.rays = cast.counters.rays;
    counters.intersection_tests = cast.counters.box_tests + cast.counters.triangle_tests + cast.counters.curved_tests;
    for (const int id : cast.image.ids) result.written_per_pixel.push_back(id != IdImage::background ? 1U : 0U);
    counters.pixels_tested = counters.pixels_written = counters.pixels_covered =
        std::count(result.written_per_pixel.begin(), result.written_per_pixel.end(), 1U);
    result.image = std::move(cast.image);
    if (is_canceled(progress)) {
        result.problem = message("Ray casting was canceled: the rest of the picture is empty.");
        data.rays = {};
    }
}

}  // namespace

const HiddenMethod hidden_methods::ray_cast{
    .name = marked("ray casting"),
    .find = find_rays,
    .draw = cast,
    .words = {marked("row"), marked("ray"), marked("Goes to the end of this row of rays."),
              marked("Goes back to the start of this row."),
              [](int) { return marked("row {group} of {groups}, ray {within} of {size}"); }},
    .computes_pixels = true,
    .casts_rays = true,
};

}  // namespace viewing
