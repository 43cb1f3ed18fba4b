// The BSP tree, linked with the pictures. The tree does not change while the camera moves; only its traversal does.
// Read order_view.cpp next.
#include "topics/hidden/shown/tree_view.h"

#include <algorithm>

#include "text/catalogue.h"
#include "topics/hidden/numbers/hidden_method.h"
#include "ui/parts/look.h"
#include "ui/parts/view_window.h"

namespace viewing {
namespace {

/// The node of the selected polygon if there is one, otherwise the selected node.
int selected_node(const PolygonLinks& links) {
    const int of_polygon = links.tree.node_of(links.now.selected_fragment);
    return of_polygon >= 0 ? of_polygon : links.now.selected_node;
}

/// Selects a node and the last of its polygons.
void select_node(PolygonLink& link, const BspTree& tree, int node) {
    link.selected_node = node;
    link.selected_fragment = -1;
    if (node < 0) return;
    const BspNode& chosen = tree.nodes[node];
    if (chosen.fragment_count > 0) link.selected_fragment = chosen.first_fragment + chosen.fragment_count - 1;
}

/// The longest sentence that is likely for a node. Its height is reserved, so that the tree does not move when the
/// sentence changes.
constexpr const char* longest_sentence = marked(
    "node 1000: plane of small box, polygon 1000; 1000 in front, 1000 behind, 1000 cut; the eye is in front, so the "
    "plane's back side is drawn first");

void draw_diagram(TreeViewState& state, PolygonLinks& links, const HiddenResult& result, float height) {
    widgets::TreeDiagramState& diagram = state.diagram;
    const float width = ImGui::GetContentRegionAvail().x;
    if (state.size_px.x != width || state.size_px.y != height) diagram.fit_next = true;
    state.size_px = {width, height};
    int selected = selected_node(links);
    if (selected >= std::ssize(links.tree.nodes())) selected = -1;
    if (selected != state.revealed && selected < result.built_nodes) diagram.reveal_next = selected;
    state.revealed = selected;
    const int current = current_node(result);
    if (current >= 0 && current != state.current) diagram.reveal_next = current;
    state.current = current;
    const int hovered = links.tree.node_of(links.now.hovered_fragment);
    const widgets::TreeDiagramStyle style{.shown_count = result.built_nodes,
                                          .current = current,
                                          .lit = hovered >= 0 ? hovered : links.now.hovered_node,
                                          .size = {0.0F, height}};
    if (widgets::TreeDiagram("tree", links.tree.nodes(), links.tree.revision(), diagram, selected, style)) {
        select_node(links.next, *result.tree, selected);
        state.revealed = selected;
    }
    if (diagram.hovered >= 0) links.next.hovered_node = diagram.hovered;
}

}  // namespace

void draw_tree_view(TreeViewState& state, PolygonLinks& links, Session& session, const HiddenStatus& hidden,
                    const Rect& rect) {
    const ViewWindow view("tree view", rect, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    if (!hidden_method(session.params.visibility.method).has_tree) {
        if (offer("Only the BSP tree method has a tree to show.", "Use the BSP tree"))
            session.params.visibility.method = VisibilityMethod::bsp;
        return;
    }
    const std::shared_ptr<const HiddenResult>& result = shown_result(hidden);
    if (!result || !result->tree) return tell_waiting(hidden);
    links.tree.follow(result);

    // Omit the sentences that do not fit, starting with the node's.
    const std::string sentence = tree_sentence(*result);
    const float gap = ImGui::GetStyle().ItemSpacing.y, least = px(100.0F);
    float room = ImGui::GetContentRegionAvail().y;
    const float above = note_height(sentence.c_str()) + gap, below = note_height(tr(longest_sentence)) + gap;
    if (room - above >= least) {
        recorded_note(sentence);
        room -= above;
    }
    // On stage, omit the node's sentence: it is only for the user who is pointing at the node, and the tree needs the
    // space.
    const bool tells_node = room - below >= least && !widgets::CurrentContext().is_on_stage;
    draw_diagram(state, links, *result, tells_node ? room - below : room);
    if (!tells_node) return;
    int told = state.diagram.hovered >= 0 ? state.diagram.hovered : links.tree.node_of(links.now.hovered_fragment);
    if (told < 0) told = selected_node(links);
    if (told < 0) told = current_node(*result);
    recorded_note(node_sentence(*result, told, links.tree));
}

}  // namespace viewing
