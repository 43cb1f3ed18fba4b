// The polygon and the node that tree, list, camera view and observer point out together. Read tree_view.cpp and
// polygon_table.cpp for their use.
#pragma once

#include <memory>
#include <vector>

#include "ui/hidden/hidden_status.h"
#include "ui/hidden/tree_index.h"

namespace viewing {

/// A polygon of the result's `fragments`, and a node of its tree. −1: none. Hovered ones are set by whoever has the
/// pointer and hold for one frame.
struct PolygonLink {
    int hovered_fragment = -1, selected_fragment = -1;
    int hovered_node = -1, selected_node = -1;

    int shown_fragment() const { return hovered_fragment >= 0 ? hovered_fragment : selected_fragment; }
    int shown_node() const { return hovered_node >= 0 ? hovered_node : selected_node; }
};

struct PolygonLinks {
    PolygonLink now;   ///< of this frame
    PolygonLink next;  ///< gathered while it is drawn; takes over at its end
    TreeIndex tree;    ///< of the latest result with a tree: the way from polygons to nodes

    std::shared_ptr<const std::vector<Polygon>> fragments;  ///< the ones that the links are indices into
};

/// Once a frame, before anything is drawn. When other fragments take over, what is selected becomes a piece of the same
/// triangle, if there is one, and nodes and hovered polygons are let go.
void keep_selection(PolygonLinks& links, const HiddenStatus& hidden);

/// Once a frame, at its end: what was gathered takes over.
void take_links(PolygonLinks& links);

}  // namespace viewing
