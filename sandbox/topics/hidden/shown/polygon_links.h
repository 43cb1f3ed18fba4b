// The polygon and the node that the tree, the list, the camera view, and the observer view highlight together. See
// tree_view.cpp and polygon_table.cpp for usage.
#pragma once

#include <memory>
#include <vector>

#include "topics/hidden/shown/hidden_status.h"
#include "topics/hidden/shown/tree_index.h"

namespace viewing {

/// Indices of a polygon in the result's `fragments` and of a node in its tree; −1 means none. The view under the
/// pointer sets the hovered indices, which last for one frame.
struct PolygonLink {
    int hovered_fragment = -1, selected_fragment = -1;
    int hovered_node = -1, selected_node = -1;

    int shown_fragment() const { return hovered_fragment >= 0 ? hovered_fragment : selected_fragment; }
    int shown_node() const { return hovered_node >= 0 ? hovered_node : selected_node; }
};

struct PolygonLinks {
    PolygonLink now;   ///< shown in this frame
    PolygonLink next;  ///< collected while drawing; replaces `now` at the end of the frame
    TreeIndex tree;    ///< for the latest result that has a tree; maps polygons to nodes

    std::shared_ptr<const std::vector<Polygon>> fragments;  ///< the links are indices into these
};

/// Call once a frame before drawing. If the fragments have changed, clears all links, but keeps the selected source
/// polygon selected if it has a fragment.
void keep_selection(PolygonLinks& links, const HiddenStatus& hidden);

/// Call once a frame at its end. Applies the collected links.
void take_links(PolygonLinks& links);

}  // namespace viewing
