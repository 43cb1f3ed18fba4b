// The hidden-surface methods in the panel: options, steps, counters.
#pragma once

#include "session/session.h"
#include "topics/hidden/shown/failure_finder.h"
#include "topics/hidden/shown/hidden_status.h"
#include "widgets/diagrams.h"

namespace viewing {

struct HiddenPanelState {
    widgets::StepPlayer player;
    int left_step = -1;  ///< the step when the panel or stop_at_other_step() last ran
    FailureFinder failure;
    bool restart_method = false;  ///< request: run the canceled work again
    bool cancel_method = false;   ///< request: cancel the current work
};

/// Draws the method's options, steps, and counters. They are the last part of the panel's section on hidden surfaces.
void draw_hidden_panel(HiddenPanelState& state, Session& session, const HiddenStatus& hidden);

/// Call once a frame before drawing. Stops playback if anything other than the panel has changed the step.
void stop_at_other_step(HiddenPanelState& state, const Session& session);

}  // namespace viewing
