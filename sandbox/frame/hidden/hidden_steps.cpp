#include "frame/hidden/hidden_steps.h"

#include <algorithm>

#include "frame/hidden/step_groups.h"

namespace viewing {
namespace {

bool draws(const NewellStep& step) {
    return step.action == NewellAction::draws || step.action == NewellAction::forces;
}

/// Returns how many polygons the first `steps` of Newell's steps draw.
int drawn_after(const NewellOrder& newell, int steps) {
    return static_cast<int>(std::count_if(newell.steps.begin(), newell.steps.begin() + steps, draws));
}

/// Returns how many polygons the visits to tree nodes draw up to the step. `result.order` is the traversal's order
/// without culled polygons.
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

constexpr std::int64_t most_steps = 1'000'000'000;

int as_step(std::int64_t number) {
    return static_cast<int>(std::min(number, most_steps));
}

/// Groups the steps: for Newell's algorithm, by the polygon that each group draws; for a tree, into building and
/// traversal; for rays, by row. The groups of the software depth buffer are known already.
void find_groups(HiddenResult& result) {
    std::vector<int>& ends = result.group_ends;
    if (result.request.visibility.method == VisibilityMethod::software_depth_buffer) return;
    ends.clear();
    if (result.newell) {
        for (std::size_t step = 0; step < result.newell->steps.size(); ++step)
            if (draws(result.newell->steps[step])) ends.push_back(static_cast<int>(step) + 1);
        // If the record of steps is full, it may end in the middle of a polygon.
        if (result.step_count > 0 && (ends.empty() || ends.back() < result.step_count))
            ends.push_back(result.step_count);
    } else if (result.tree) {
        ends = {static_cast<int>(result.tree->nodes.size()), result.step_count};
    } else if (result.request.visibility.method == VisibilityMethod::ray_cast) {
        for (int row = 1; row <= result.request.size_px.y; ++row) ends.push_back(row * result.request.size_px.x);
    }
}

}  // namespace

void find_fragment_steps(HiddenResult& result, const RasterResult& all) {
    result.group_ends.clear();
    for (const std::int64_t tested : all.tested_after) result.group_ends.push_back(as_step(tested));
    for (const RasterTouch& touch : all.touches) result.touches.push_back({as_step(touch.number), touch.fragment});
}

void find_polygon_steps(HiddenResult& result, const RasterResult& all) {
    const std::vector<int> steps = steps_of_order(result);
    for (const RasterTouch& touch : all.touches)
        result.touches.push_back({steps[static_cast<std::size_t>(touch.place)], touch.fragment});
}

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
    if (method == VisibilityMethod::software_depth_buffer) result.step_count = as_step(result.counters.pixels_tested);
    if (method == VisibilityMethod::ray_cast) result.step_count = result.request.size_px.x * result.request.size_px.y;

    find_groups(result);

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
        if (method == VisibilityMethod::software_depth_buffer) result.drawn = order_count;
    }
}

}  // namespace viewing
