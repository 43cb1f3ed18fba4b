// The precision of the depth buffer between near and far: the step Δz as curves, and the codes as ticks.
#pragma once

#include "frame/derive.h"
#include "session/session.h"
#include "ui/parts/layout.h"

namespace viewing {

/// Draws the step Δz over the eye distance, for the state's near, far, format, and mapping, and for other formats and
/// mappings. Near and far can be dragged. If near does not suit the visible scene, adds a sentence and a button that
/// fixes it. `cursor_z`: eye distance at the pixel under the pointer or at the pinned one; ≤ 0: none.
void draw_precision_view(Session& session, const Derived& derived, const Rect& rect, double cursor_z);

/// Draws the codes of the state's format and mapping between near and far.
void draw_codes_view(Session& session, const Derived& derived, const Rect& rect);

}  // namespace viewing
