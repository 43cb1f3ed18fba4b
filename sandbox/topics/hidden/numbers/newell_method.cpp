// Newell's algorithm: each step compares a pair of polygons or draws one. A group of steps ends when a polygon is
// drawn.
#include <algorithm>

#include "platform/stopwatch.h"
#include "text/catalogue.h"
#include "topics/hidden/numbers/method_parts.h"

namespace viewing {
namespace {

bool draws(const NewellStep& step) {
    return step.action == NewellAction::draws || step.action == NewellAction::forces;
}

void find_newell(HiddenData& data, HiddenResult& result, WorkProgress* progress) {
    take_polygons(data, result, progress);
    const HiddenRequest& request = result.request;
    const Stopwatch watch;
    const auto newell = std::make_shared<const NewellOrder>(
        newell_order(*result.fragments, request.viewpoint,
                     {.epsilon = request.visibility.epsilon * data.surface->diagonal}, progress));
    result.newell = newell;
    result.order = newell->order;
    result.fragments = {newell, &newell->fragments};
    result.problem = newell->problem;
    result.time_ms = watch.ms();
    result.counters.fragments = static_cast<std::int64_t>(newell->order.size());

    result.step_count = static_cast<int>(newell->steps.size());
    std::vector<int>& ends = result.group_ends;
    for (int step = 0; step < result.step_count; ++step)
        if (draws(newell->steps[step])) ends.push_back(step + 1);
    result.order_steps = ends;
    result.order_steps.resize(result.order.size(), result.step_count);  // the recorded steps may not reach all polygons
    // If the record of steps is full, it may end in the middle of a polygon.
    if (result.step_count > 0 && (ends.empty() || ends.back() < result.step_count)) ends.push_back(result.step_count);
}

/// Counts the operations of the tests up to the step.
void count_newell(HiddenResult& result) {
    HiddenCounters& counters = result.counters;
    const NewellOrder& newell = *result.newell;
    counters.comparisons = newell.counters.pairs;
    counters.swaps = newell.counters.swaps;
    counters.splits = newell.counters.splits;
    if (result.step < 0) return;
    const auto done = std::span(newell.steps).first(static_cast<std::size_t>(result.step));
    const auto count = [&](NewellAction action) {
        return std::count_if(done.begin(), done.end(), [&](const NewellStep& step) { return step.action == action; });
    };
    counters.comparisons = std::count_if(done.begin(), done.end(), [](const NewellStep& step) { return step.q >= 0; });
    counters.swaps = count(NewellAction::swaps);
    counters.splits = count(NewellAction::splits);
}

}  // namespace

const HiddenMethod hidden_methods::newell{
    .name = marked("Newell"),
    .find = find_newell,
    .count = count_newell,
    .draw = paint_in_order,
    .words = {marked("polygon"), marked("step"), marked("Runs until the next polygon is drawn."),
              marked("Goes back to the start of this polygon or, if already there, of the previous one."),
              [](int) { return marked("polygon {group} of {groups}, step {within} of {size}"); }},
    .splits = true,
};

}  // namespace viewing
