#include "topics/hidden/numbers/method_parts.h"

#include <algorithm>
#include <numeric>

#include "platform/stopwatch.h"

namespace viewing {

FrontFace winding_for(const HiddenRequest& request) {
    const bool mirrors = glm::determinant(glm::dmat3(request.viewpoint.view_from_world)) < 0.0;
    const FrontFace turned = request.cull.front_face == FrontFace::cw ? FrontFace::ccw : FrontFace::cw;
    return mirrors ? turned : request.cull.front_face;
}

bool is_front_to_back(const VisibilityParams& visibility) {
    return hidden_method(visibility.method).has_tree && visibility.walk == BspOrder::front_to_back;
}

void take_polygons(const HiddenData& data, HiddenResult& result, const WorkProgress* progress) {
    const HiddenRequest& request = result.request;
    const std::vector<Polygon>& all = data.surface->polygons;
    if (is_canceled(progress)) {
        result.fragments = std::make_shared<const std::vector<Polygon>>();
    } else if (!request.cull.enabled) {
        result.fragments = {data.surface, &all};  // no copy: there may be a million polygons
    } else {
        result.fragments = std::make_shared<const std::vector<Polygon>>(
            culled(all, request.viewpoint, request.cull.face, winding_for(request), progress));
        if (!is_canceled(progress))  // if canceled, some polygons were never tested
            result.counters.culled = static_cast<std::int64_t>(all.size() - result.fragments->size());
    }
    result.counters.polygons = static_cast<std::int64_t>(result.fragments->size());
}

void find_scene_order(HiddenData& data, HiddenResult& result, WorkProgress* progress) {
    take_polygons(data, result, progress);
    result.order.resize(result.fragments->size());
    std::iota(result.order.begin(), result.order.end(), 0);
    result.order_steps.resize(result.order.size());
    std::iota(result.order_steps.begin(), result.order_steps.end(), 1);
    result.step_count = static_cast<int>(result.order.size());
}

RasterResult painted(const HiddenResult& result, int polygons, PaintRule rule, WorkProgress* progress,
                     std::int64_t stop_after) {
    const HiddenRequest& request = result.request;
    return rasterize(*result.fragments, std::span(result.order).first(static_cast<std::size_t>(polygons)),
                     request.viewpoint.clip_from_world(),
                     {.rule = rule,
                      .width = request.size_px.x,
                      .height = request.size_px.y,
                      .stop_after = stop_after,
                      .count_per_pixel = true,
                      .watched = request.visibility.pixel},
                     progress);
}

void take_picture(HiddenResult& result, RasterResult raster) {
    result.counters.pixels_tested = raster.counters.pixels_tested;
    result.counters.pixels_written = raster.counters.pixels_written;
    result.counters.pixels_covered = raster.counters.pixels_covered;
    result.image = std::move(raster.image);
    result.written_per_pixel = std::move(raster.written_per_pixel);
}

void paint_in_order(HiddenData&, HiddenResult& result, WorkProgress* progress) {
    const PaintRule rule = is_front_to_back(result.request.visibility) ? PaintRule::keep_first : PaintRule::overwrite;
    const Stopwatch watch;
    take_picture(result, painted(result, result.drawn, rule, progress));
    result.painting_ms = watch.ms();
    if (!result.request.visibility.pixel) return;
    const RasterResult whole = painted(result, static_cast<int>(result.order.size()), rule, progress);
    for (const RasterTouch& touch : whole.touches)
        result.touches.push_back({result.order_steps[touch.place], touch.fragment});
}

}  // namespace viewing
