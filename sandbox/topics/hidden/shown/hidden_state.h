// The state of the hidden-surface interface between frames. Read hidden_panel.cpp, then tree_view.cpp, order_view.cpp
// and growth_view.cpp.
#pragma once

#include "topics/hidden/shown/growth_view.h"
#include "topics/hidden/shown/hidden_panel.h"
#include "topics/hidden/shown/order_view.h"
#include "topics/hidden/shown/polygon_links.h"
#include "topics/hidden/shown/tree_view.h"
#include "ui/parts/topics.h"

namespace viewing {

struct HiddenState {
    PolygonLinks links;
    HiddenPanelState panel;
    TreeViewState tree;
    OrderViewState order;
    GrowthViewState growth;

    /// Whether anything here needs new frames even without user input.
    bool is_busy() const {
        return panel.player.playing || panel.failure.search.is_running() || growth.measuring.is_running();
    }
};

/// Call once a frame before drawing. Applies the results of background work.
inline void begin_hidden_frame(HiddenState& state, Session& session, const HiddenStatus& hidden) {
    take_failure(state.panel.failure, session);
    const bool is_live_stage = widgets::CurrentContext().is_on_stage && hidden.shows_time;
    if (is_live_stage && is_shown(session.params, Topic::growth)) measure_for_stage(state.growth, session);
    take_growth_rows(state.growth, session);
    stop_at_other_step(state.panel, session);
    keep_selection(state.links, hidden);
}

/// Call at the end of each frame. Applies the selection and hovering. Stops playback if no step bar was drawn.
inline void end_hidden_frame(HiddenState& state) {
    widgets::StopUnlessShown(state.panel.player);
    take_links(state.links);
}

}  // namespace viewing
