// The precision of the depth buffer between near and far: the step Δz as curves, and the codes as ticks.
#pragma once

#include "frame/derive.h"
#include "session/session.h"
#include "ui/parts/layout.h"

namespace viewing {

/// Plots the step Δz against the eye distance for the state's near, far, format, and mapping, and for other formats and
/// mappings. Near and far can be dragged. If near does not suit the visible scene, adds a sentence and a button that
/// fixes it. `cursor_z`: the eye distance at the pinned pixel or at the one under the pointer; ≤ 0 if there is none.
void draw_precision_view(Session& session, const Derived& derived, const Rect& rect, double cursor_z);

/// Draws the codes of the state's format and mapping between near and far.
void draw_codes_view(Session& session, const Derived& derived, const Rect& rect);

}  // namespace viewing
