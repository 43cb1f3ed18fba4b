// The tree of a BSP build, linked with the pictures: it stays still while the camera moves, only the walk over it
// changes. Read laboratory_order.cpp next.
#include <algorithm>

#include "ui/hidden/laboratory.h"
#include "ui/hidden/laboratory_parts.h"
#include "ui/parts/look.h"

namespace viewing {
namespace {

/// The selected node: that of the selected polygon where there is one.
int selected_node(const LaboratoryState& state) {
    const int of_polygon = state.tree_index.node_of(state.link.selected_fragment);
    return of_polygon >= 0 ? of_polygon : state.link.selected_node;
}

/// A node that was chosen, with the polygon of it that is seen.
void select_node(LaboratoryState& state, const BspTree& tree, int node) {
    PolygonLink& link = state.next_link;
    link.selected_node = node;
    link.selected_fragment = -1;
    if (node < 0) return;
    const BspNode& chosen = tree.nodes[static_cast<std::size_t>(node)];
    if (chosen.fragment_count > 0) link.selected_fragment = chosen.first_fragment + chosen.fragment_count - 1;
}

/// The node that the step is at; −1 when all steps are shown.
int current_node(const HiddenResult& result) {
    if (result.step < 0) return -1;
    if (result.visited_nodes > 0 && result.visited_nodes <= static_cast<int>(result.walk->visits.size()))
        return result.walk->visits[static_cast<std::size_t>(result.visited_nodes - 1)].node;
    return result.built_nodes - 1;
}

/// As long as a sentence about a node gets, so that the tree does not move when another one is told.
constexpr const char* longest_sentence =
    "node 1000: plane of small box, polygon 1000; 1000 in front, 1000 behind, 1000 cut; the eye is in front, so its "
    "back side is drawn first";

void draw_diagram(LaboratoryState& state, const HiddenResult& result, float height) {
    widgets::TreeDiagramState& diagram = state.tree;
    const float width = ImGui::GetContentRegionAvail().x;
    if (state.tree_size_px.x != width || state.tree_size_px.y != height) diagram.fit_next = true;
    state.tree_size_px = {width, height};
    int selected = selected_node(state);
    if (selected >= static_cast<int>(state.tree_index.nodes().size())) selected = -1;
    if (selected != state.tree_revealed && selected < result.built_nodes) diagram.reveal_next = selected;
    state.tree_revealed = selected;
    const int current = current_node(result);
    if (current >= 0 && current != state.tree_current) diagram.reveal_next = current;
    state.tree_current = current;
    const int hovered = state.tree_index.node_of(state.link.hovered_fragment);
    const widgets::TreeDiagramStyle style{.shown_count = result.built_nodes,
                                          .current = current,
                                          .lit = hovered >= 0 ? hovered : state.link.hovered_node,
                                          .size = {0.0F, height}};
    if (widgets::TreeDiagram("tree", state.tree_index.nodes(), state.tree_revision, diagram, selected, style)) {
        select_node(state, *result.tree, selected);
        state.tree_revealed = selected;
    }
    if (diagram.hovered >= 0) state.next_link.hovered_node = diagram.hovered;
}

}  // namespace

void draw_tree_view(LaboratoryState& state, Session& session, const HiddenStatus& hidden, const Rect& rect) {
    const LaboratoryView view("tree view", rect, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    if (session.params.visibility.method != VisibilityMethod::bsp) {
        if (offer("Only the BSP tree has a tree to show.", "Use the BSP tree"))
            session.params.visibility.method = VisibilityMethod::bsp;
        return;
    }
    const std::shared_ptr<const HiddenResult>& result = shown_result(hidden);
    if (!result || !result->tree) return tell_waiting(hidden);
    if (state.tree_index.follow(result)) ++state.tree_revision;

    // What there is no room for is left out, the node's sentence first.
    const std::string sentence = tree_sentence(*result);
    const float gap = ImGui::GetStyle().ItemSpacing.y, least = px(100.0F);
    float room = ImGui::GetContentRegionAvail().y;
    const float above = note_height(sentence.c_str()) + gap, below = note_height(longest_sentence) + gap;
    if (room - above >= least) {
        widgets::Note(sentence.c_str());
        widgets::Record(sentence.c_str());
        room -= above;
    }
    const bool tells_node = room - below >= least;
    draw_diagram(state, *result, tells_node ? room - below : room);
    if (!tells_node) return;
    int told = state.tree.hovered >= 0 ? state.tree.hovered : state.tree_index.node_of(state.link.hovered_fragment);
    if (told < 0) told = selected_node(state);
    if (told < 0) told = current_node(*result);
    const std::string about = node_sentence(*result, told, state.tree_index);
    if (about.empty()) return;
    widgets::Note(about.c_str());
    widgets::Record(about.c_str());
}

}  // namespace viewing
