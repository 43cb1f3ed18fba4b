#include "topics/hidden/shown/tree_index.h"

#include <algorithm>

#include "text/catalogue.h"
#include "topics/hidden/shown/method_words.h"
#include "topics/hidden/shown/polygon_names.h"

namespace viewing {
namespace {

bool is_index(int index, std::size_t size) {
    return index >= 0 && static_cast<std::size_t>(index) < size;
}

}  // namespace

void TreeIndex::follow(const std::shared_ptr<const HiddenResult>& result) {
    if (!result || !result->tree || result == followed_) return;
    if (!followed_ || followed_->tree != result->tree) {
        take_tree(*result->tree, result->surface.get());
        ++revision_;
    }
    take_walk(*result);
    followed_ = result;
}

void TreeIndex::take_tree(const BspTree& tree, const SceneSurface* surface) {
    const std::size_t count = tree.nodes.size();
    nodes_.assign(count, {});
    labels_.clear();
    std::vector<std::size_t> label_ends(count);
    node_of_fragment_.assign(tree.fragments.size(), -1);
    for (std::size_t i = 0; i < count; ++i) {
        const BspNode& node = tree.nodes[i];
        nodes_[i].parent = node.parent;
        nodes_[i].front = node.front;
        nodes_[i].back = node.back;
        nodes_[i].color = polygon_color(surface, node.splitter_source);
        const std::string label = std::to_string(i + 1);
        labels_.insert(labels_.end(), label.begin(), label.end());
        label_ends[i] = labels_.size();
        for (int own = 0; own < node.fragment_count; ++own)
            node_of_fragment_[node.first_fragment + own] = static_cast<int>(i);
    }
    for (std::size_t i = 0, begin = 0; i < count; begin = label_ends[i++])
        nodes_[i].label = {labels_.data() + begin, label_ends[i] - begin};
}

void TreeIndex::take_walk(const HiddenResult& result) {
    eye_sides_.assign(nodes_.size(), 0);
    for (widgets::TreeNode& node : nodes_) {
        node.mark = -1;
        node.eye_side = 0;
    }
    if (!result.walk) return;
    const std::vector<BspVisit>& visits = result.walk->visits;
    for (std::size_t place = 0; place < visits.size(); ++place) {
        const BspVisit& visit = visits[place];
        if (!is_index(visit.node, nodes_.size())) continue;
        const auto node = static_cast<std::size_t>(visit.node);
        eye_sides_[node] = static_cast<signed char>(visit.eye_side);
        if (place >= static_cast<std::size_t>(std::max(result.visited_nodes, 0))) continue;
        nodes_[node].mark = static_cast<int>(place) + 1;
        nodes_[node].eye_side = visit.eye_side;
    }
}

int TreeIndex::node_of(int fragment) const {
    return is_index(fragment, node_of_fragment_.size()) ? node_of_fragment_[fragment] : -1;
}

int TreeIndex::eye_side_of(int node) const {
    return is_index(node, eye_sides_.size()) ? eye_sides_[node] : 0;
}

int current_node(const HiddenResult& result) {
    if (result.step < 0) return -1;
    if (result.visited_nodes > 0 && result.visited_nodes <= std::ssize(result.walk->visits))
        return result.walk->visits[result.visited_nodes - 1].node;
    return result.built_nodes - 1;
}

std::string tree_sentence(const HiddenResult& result) {
    if (!result.tree) return "";
    const BspTree& tree = *result.tree;
    const auto nodes = static_cast<int>(tree.nodes.size());
    const std::string whole = say(
        "{nodes}, depth {depth}, {fragments}, {splits}; splitter: {splitter}",
        "nodes"_a = say_count(nodes, "{count} node", "{count} nodes"), "depth"_a = grouped_number(tree.counters.depth),
        "fragments"_a =
            say_count(static_cast<std::int64_t>(tree.fragments.size()), "{count} fragment", "{count} fragments"),
        "splits"_a = say_count(tree.counters.splits, "{count} split", "{count} splits"),
        "splitter"_a = tr(splitter_names[result.request.visibility.splitter]));
    if (result.step < 0) return whole;
    if (result.built_nodes < nodes)
        return say("{tree}; nodes built so far: {count}", "tree"_a = whole,
                   "count"_a = grouped_number(result.built_nodes));
    return say("{tree}; nodes visited so far: {count}", "tree"_a = whole,
               "count"_a = grouped_number(result.visited_nodes));
}

std::string node_sentence(const HiddenResult& result, int node, const TreeIndex& index) {
    if (!result.tree || !is_index(node, result.tree->nodes.size()) || node >= result.built_nodes) return "";
    const BspNode& told = result.tree->nodes[node];
    if (!told.sorted)
        return say_count(told.fragment_count, "node {node}: budget reached, {count} polygon unsorted",
                         "node {node}: budget reached, {count} polygons unsorted", "node"_a = node + 1);
    const std::string plane =
        say("node {node}: plane of {polygon}; {front} in front, {behind} behind, {cut} cut", "node"_a = node + 1,
            "polygon"_a = listed_name(result.surface.get(), told.splitter_source),
            "front"_a = grouped_number(told.front_count), "behind"_a = grouped_number(told.back_count),
            "cut"_a = grouped_number(told.split_count));
    const bool is_visited = is_index(node, index.nodes().size()) && index.nodes()[node].mark > 0;
    if (!is_visited) return plane;
    const int side = index.eye_side_of(node);
    const bool front_first = (side > 0) == (result.request.visibility.walk == BspOrder::front_to_back);
    if (side == 0) return say("{plane}; the eye lies in the plane: neither side hides the other", "plane"_a = plane);
    if (side > 0)
        return front_first
                   ? say("{plane}; the eye is in front, so the plane's front side is drawn first", "plane"_a = plane)
                   : say("{plane}; the eye is in front, so the plane's back side is drawn first", "plane"_a = plane);
    return front_first ? say("{plane}; the eye is behind, so the plane's front side is drawn first", "plane"_a = plane)
                       : say("{plane}; the eye is behind, so the plane's back side is drawn first", "plane"_a = plane);
}

}  // namespace viewing
