// The hidden-surface methods in the panel: options, steps, counters.
#pragma once

#include "session/session.h"
#include "ui/hidden/failure_finder.h"
#include "ui/hidden/hidden_status.h"
#include "widgets/diagrams.h"

namespace viewing {

struct HiddenPanelState {
    widgets::StepPlayer player;
    int left_step = -1;  ///< as the player's bar left it
    FailureFinder failure;
    bool restart_method = false;  ///< asked for: what was cancelled shall be begun again
    bool cancel_method = false;   ///< asked for: the work on the current question shall be given up
};

/// The method's options, steps and counters: the last part of the panel's section on hidden surfaces.
void draw_hidden_panel(HiddenPanelState& state, Session& session, const HiddenStatus& hidden);

/// Once a frame, before anything is drawn: playing ends when somebody else has changed the step.
void stop_at_other_step(HiddenPanelState& state, const Session& session);

}  // namespace viewing
