// How precise the depth buffer is between near and far: its step as curves, and its codes as ticks.
#pragma once

#include "frame/derive.h"
#include "session/session.h"
#include "ui/parts/layout.h"

namespace viewing {

/// The step Δz over the eye distance, for the state's near, far, format and mapping and for others; near and far can be
/// dragged. Where near does not suit what is in view, a sentence and the way to mend it. `cursor_z`: the eye distance
/// at the pixel under the pointer or the pinned one; ≤ 0: none.
void draw_precision_view(Session& session, const Derived& derived, const Rect& rect, double cursor_z);

/// Where the codes of the state's format and mapping lie between near and far.
void draw_codes_view(Session& session, const Derived& derived, const Rect& rect);

}  // namespace viewing
