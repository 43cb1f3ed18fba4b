// The view of a BSP tree.
#pragma once

#include "session/session.h"
#include "topics/hidden/shown/polygon_links.h"
#include "ui/parts/layout.h"
#include "widgets/diagrams.h"

namespace viewing {

struct TreeViewState {
    widgets::TreeDiagramState diagram;
    int revealed = -1;           ///< the selected node to which the diagram last moved
    int current = -1;            ///< the step's node to which the diagram last moved
    ImVec2 size_px{0.0F, 0.0F};  ///< the size to which the diagram was last fitted
};

void draw_tree_view(TreeViewState& state, PolygonLinks& links, Session& session, const HiddenStatus& hidden,
                    const Rect& rect);

}  // namespace viewing
