// The BSP tree: its steps add the nodes one by one, and then visit them in the order of the walk.
#include <algorithm>

#include "platform/stopwatch.h"
#include "text/catalogue.h"
#include "topics/hidden/numbers/method_parts.h"

namespace viewing {
namespace {

/// Builds the tree, unless there is one already.
void find_tree(HiddenData& data, HiddenResult& result, WorkProgress* progress) {
    const VisibilityParams& visibility = result.request.visibility;
    if (!data.tree.tree || data.tree.splitter != visibility.splitter || data.tree.epsilon != visibility.epsilon) {
        const Stopwatch watch;
        const std::vector<Polygon>& polygons = data.surface->polygons;
        const BspOptions options{.splitter = visibility.splitter,
                                 .epsilon = visibility.epsilon * data.surface->diagonal,
                                 .max_fragments = 1'000'000 + 2 * static_cast<int>(polygons.size())};
        auto tree = std::make_shared<const BspTree>(build_bsp(polygons, options, progress));
        data.tree = {tree, visibility.splitter, visibility.epsilon, watch.ms()};
    }
    result.tree = data.tree.tree;
    result.build_ms = data.tree.build_ms;
    result.problem = result.tree->problem;
    if (is_canceled(progress)) data.tree = {};  // a canceled tree is incomplete
}

/// Leaves culled polygons out of the walk's order.
void cull(HiddenResult& result) {
    const std::vector<Facing> facing =
        facing_by_plane(*result.fragments, result.request.viewpoint, winding_for(result.request));
    const CullFace faces = result.request.cull.face;
    result.counters.culled = static_cast<std::int64_t>(std::erase_if(result.order, [&](int fragment) {
        const Facing side = facing[fragment];
        return faces == CullFace::front_and_back || side == (faces == CullFace::front ? Facing::towards : Facing::away);
    }));
}

void find_steps(HiddenResult& result) {
    const auto nodes = static_cast<int>(result.tree->nodes.size());
    std::vector<int>& steps = result.order_steps;
    result.step_count = nodes;
    std::size_t passed = 0;
    for (const BspVisit& visit : result.walk->visits) {
        ++result.step_count;
        const BspNode& node = result.tree->nodes[visit.node];
        const std::size_t end = passed + static_cast<std::size_t>(node.fragment_count);
        for (; passed < end; ++passed)
            if (steps.size() < result.order.size() && result.order[steps.size()] == result.walk->fragments[passed])
                steps.push_back(result.step_count);
    }
    result.group_ends = {nodes, result.step_count};
}

void find_bsp(HiddenData& data, HiddenResult& result, WorkProgress* progress) {
    find_tree(data, result, progress);
    result.fragments = {result.tree, &result.tree->fragments};
    const Stopwatch watch;
    const HiddenRequest& request = result.request;
    result.walk =
        std::make_shared<const BspWalk>(walk_bsp(*result.tree, request.viewpoint.eye_world(), request.visibility.walk));
    result.time_ms = watch.ms();
    result.order = result.walk->fragments;
    if (request.cull.enabled) cull(result);
    find_steps(result);
    HiddenCounters& counters = result.counters;
    counters.polygons = static_cast<std::int64_t>(data.surface->polygons.size());
    counters.comparisons = result.tree->counters.plane_tests;
    counters.fragments = static_cast<std::int64_t>(result.tree->fragments.size());
    counters.tree_depth = result.tree->counters.depth;
}

/// Counts the nodes that the step has reached, and the splits for those that are built.
void count_nodes(HiddenResult& result) {
    const auto nodes = static_cast<int>(result.tree->nodes.size());
    const int reached = result.step < 0 ? result.step_count : result.step;
    result.built_nodes = std::min(reached, nodes);
    result.visited_nodes = std::max(0, reached - nodes);
    result.counters.splits = 0;
    for (const BspNode& node : std::span(result.tree->nodes).first(static_cast<std::size_t>(result.built_nodes)))
        result.counters.splits += node.split_count;
}

}  // namespace

const HiddenMethod hidden_methods::bsp{
    .name = marked("BSP tree"),
    .find = find_bsp,
    .count = count_nodes,
    .draw = paint_in_order,
    .words = {marked("part"), marked("node"), marked("Goes to the end of this part (building the tree or walking it)."),
              marked("Goes back to the start of this part."),
              [](int group) {
                  return group == 1 ? marked("building the tree: node {node} of {count}")
                                    : marked("walking the tree: node {node} of {count}");
              }},
    .splits = true,
    .has_tree = true,
};

}  // namespace viewing
