#include "frame/hidden/hidden_steps.h"

#include <algorithm>

namespace viewing {
namespace {

/// How many polygons are drawn after so many rungs of the ladder.
int drawn_after(const NewellOrder& newell, int steps) {
    const auto end = newell.steps.begin() + steps;
    return static_cast<int>(std::count_if(newell.steps.begin(), end, [](const NewellStep& step) {
        return step.action == NewellAction::draws || step.action == NewellAction::forces;
    }));
}

/// How many polygons are drawn by the visits so far; `order` is the walk's without those that are culled.
int drawn_by_visits(const HiddenResult& result) {
    int passed = 0, drawn = 0;
    for (int visit = 0; visit < result.visited_nodes; ++visit) {
        const int node = result.walk->visits[static_cast<std::size_t>(visit)].node;
        passed += result.tree->nodes[static_cast<std::size_t>(node)].fragment_count;
    }
    const auto order_count = static_cast<int>(result.order.size());
    for (int place = 0; place < passed && drawn < order_count; ++place)
        if (result.order[static_cast<std::size_t>(drawn)] == result.walk->fragments[static_cast<std::size_t>(place)])
            ++drawn;
    return drawn;
}

}  // namespace

void count_to_step(HiddenResult& result) {
    HiddenCounters& counters = result.counters;
    if (result.newell) {
        const NewellOrder& newell = *result.newell;
        counters.comparisons = newell.counters.pairs;
        counters.swaps = newell.counters.swaps;
        counters.splits = newell.counters.splits;
        if (result.step < 0) return;
        const std::span<const NewellStep> done(newell.steps.data(), static_cast<std::size_t>(result.step));
        const auto count = [&](NewellAction action) {
            return std::count_if(done.begin(), done.end(),
                                 [&](const NewellStep& step) { return step.action == action; });
        };
        counters.comparisons =
            std::count_if(done.begin(), done.end(), [](const NewellStep& step) { return step.q >= 0; });
        counters.swaps = count(NewellAction::swaps);
        counters.splits = count(NewellAction::splits);
    } else if (result.tree) {
        counters.splits = 0;
        for (const BspNode& node : std::span(result.tree->nodes).first(static_cast<std::size_t>(result.built_nodes)))
            counters.splits += node.split_count;
    }
}

void find_step(HiddenResult& result) {
    const VisibilityMethod method = result.request.visibility.method;
    const int order_count = static_cast<int>(result.order.size());
    if (result.newell) result.step_count = static_cast<int>(result.newell->steps.size());
    if (!result.newell && !result.tree) result.step_count = order_count;
    if (result.tree) result.step_count = static_cast<int>(result.tree->nodes.size() + result.walk->visits.size());
    if (method == VisibilityMethod::software_depth_buffer)
        result.step_count = static_cast<int>(std::min<std::int64_t>(result.counters.pixels_tested, 1'000'000'000));
    if (method == VisibilityMethod::ray_cast) result.step_count = result.request.size_px.x * result.request.size_px.y;

    const int wanted = result.request.visibility.step;
    result.step = wanted >= result.step_count ? -1 : wanted;
    result.drawn = order_count;
    if (result.tree) {
        const int nodes = static_cast<int>(result.tree->nodes.size());
        result.built_nodes = result.step < 0 ? nodes : std::min(result.step, nodes);
        result.visited_nodes =
            result.step < 0 ? static_cast<int>(result.walk->visits.size()) : std::max(0, result.step - nodes);
        if (result.step >= 0) {
            result.drawn = drawn_by_visits(result);
        }
    } else if (result.step >= 0) {
        result.drawn = result.newell ? drawn_after(*result.newell, result.step) : std::min(result.step, order_count);
        if (draws_pixels(result.request.visibility)) result.drawn = order_count;
    }
}

}  // namespace viewing
