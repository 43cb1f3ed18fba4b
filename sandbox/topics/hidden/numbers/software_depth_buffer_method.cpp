// The depth buffer in software: each step compares one fragment. The steps of a polygon are a group.
#include <algorithm>

#include "platform/stopwatch.h"
#include "text/catalogue.h"
#include "topics/hidden/numbers/method_parts.h"

namespace viewing {
namespace {

int as_step(std::int64_t number) {
    constexpr std::int64_t most_steps = 1'000'000'000;
    return static_cast<int>(std::min(number, most_steps));
}

RasterResult compared(const HiddenResult& result, std::int64_t steps, WorkProgress* progress) {
    return painted(result, static_cast<int>(result.order.size()), PaintRule::depth_test, progress, steps);
}

void take_comparison(HiddenResult& result, RasterResult raster) {
    result.compare = raster.last;
    take_picture(result, std::move(raster));
}

void find_fragments(HiddenData& data, HiddenResult& result, WorkProgress* progress) {
    const Stopwatch watch;
    find_scene_order(data, result, progress);
    RasterResult raster = compared(result, -1, progress);
    result.time_ms = watch.ms();
    result.step_count = as_step(raster.counters.pixels_tested);
    for (const std::int64_t tested : raster.tested_after) result.group_ends.push_back(as_step(tested));
    result.order_steps = result.group_ends;
    result.order_steps.resize(result.order.size(), result.step_count);  // if canceled, some polygons were never drawn
    for (const RasterTouch& touch : raster.touches) result.touches.push_back({as_step(touch.number), touch.fragment});
    take_comparison(result, std::move(raster));
}

}  // namespace

const HiddenMethod hidden_methods::software_depth_buffer{
    .name = marked("soft. z-buffer"),
    .find = find_fragments,
    .draw =
        [](HiddenData&, HiddenResult& result, WorkProgress* progress) {
            result.drawn = static_cast<int>(result.order.size());
            if (result.step >= 0) take_comparison(result, compared(result, result.step, progress));
        },
    .words = {marked("triangle"), marked("fragment"),
              marked("Runs to the end of this triangle or, if already there, of the next one."),
              marked("Goes back to the start of this triangle or, if already there, of the previous one."),
              [](int) { return marked("triangle {group} of {groups}, fragment {within} of {size}"); }},
    .computes_pixels = true,
};

}  // namespace viewing
