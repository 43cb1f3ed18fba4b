// The left column: every parameter that has an effect, in the lecture's order and terms.
#pragma once

#include "frame/problems.h"
#include "session/session.h"
#include "topics/camera/shown/camera_tab.h"
#include "topics/hidden/shown/hidden_panel.h"

namespace viewing {

/// Draws the sections into the current ImGui window and edits the session's parameters.
void draw_panel(Session& session, const Derived& derived, const std::vector<Problem>& problems,
                HiddenPanelState& hidden_state, const HiddenStatus& hidden, CameraTab& tab);

/// Draws only the controls that the state lists (view.layout.controls), under one heading at most.
void draw_listed_controls(Session& session, const Derived& derived, const std::vector<Problem>& problems,
                          HiddenPanelState& hidden_state, const HiddenStatus& hidden, CameraTab& tab, bool has_title);

}  // namespace viewing
