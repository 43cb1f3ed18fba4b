// The painter's algorithm: each step draws the farthest of the polygons that are left.
#include "platform/stopwatch.h"
#include "text/catalogue.h"
#include "topics/hidden/numbers/method_parts.h"

namespace viewing {

const HiddenMethod hidden_methods::painter{
    .name = marked("painter"),
    .find =
        [](HiddenData& data, HiddenResult& result, WorkProgress* progress) {
            find_scene_order(data, result, progress);
            const HiddenRequest& request = result.request;
            const Stopwatch watch;
            result.painter = std::make_shared<const PainterOrder>(
                painter_order(*result.fragments, request.viewpoint, request.visibility.sort_key, progress));
            result.order = result.painter->order;
            result.time_ms = watch.ms();
            result.counters.comparisons = result.painter->comparisons;
            result.counters.swaps = result.painter->swaps;
        },
    .draw = paint_in_order,
    .sorts_by_key = true,
};

}  // namespace viewing
