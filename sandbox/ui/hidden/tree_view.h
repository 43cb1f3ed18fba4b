// The tree of a BSP build as a view of its own.
#pragma once

#include "session/session.h"
#include "ui/hidden/polygon_links.h"
#include "ui/parts/layout.h"
#include "widgets/diagrams.h"

namespace viewing {

struct TreeViewState {
    widgets::TreeDiagramState diagram;
    int revealed = -1;           ///< the node that the diagram was last moved to, as it was selected
    int current = -1;            ///< and as the step reached it
    ImVec2 size_px{0.0F, 0.0F};  ///< that it was fitted to
};

void draw_tree_view(TreeViewState& state, PolygonLinks& links, Session& session, const HiddenStatus& hidden,
                    const Rect& rect);

}  // namespace viewing
