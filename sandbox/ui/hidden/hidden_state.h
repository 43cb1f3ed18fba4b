// What the hidden-surface methods' part of the interface keeps between frames. Read hidden_panel.cpp, then
// tree_view.cpp, order_view.cpp and growth_view.cpp.
#pragma once

#include "ui/hidden/growth_view.h"
#include "ui/hidden/hidden_panel.h"
#include "ui/hidden/order_view.h"
#include "ui/hidden/polygon_links.h"
#include "ui/hidden/tree_view.h"

namespace viewing {

struct HiddenState {
    PolygonLinks links;
    HiddenPanelState panel;
    TreeViewState tree;
    OrderViewState order;
    GrowthViewState growth;

    /// Whether something here wants frames although no input comes.
    bool is_busy() const {
        return panel.player.playing || panel.failure.search.is_running() || growth.measuring.is_running();
    }
};

/// Once a frame, before anything is drawn: what has ended beside the window takes effect.
inline void begin_hidden_frame(HiddenState& state, Session& session, const HiddenStatus& hidden) {
    take_failure(state.panel.failure, session);
    take_growth_rows(state.growth, session);
    stop_at_other_step(state.panel, session);
    keep_selection(state.links, hidden);
}

/// Once a frame, at its end: what was pointed at takes effect.
inline void end_hidden_frame(HiddenState& state) {
    widgets::StopUnlessShown(state.panel.player);
    take_links(state.links);
}

}  // namespace viewing
