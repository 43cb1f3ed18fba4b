// Moves from one state to another in small steps, to animate a reveal.
#pragma once

#include "state/params.h"

namespace viewing {

/// Returns the state at `share` of the way, 0 … 1. Numbers change evenly, or by equal factors in logarithmic fields;
/// everything else equals `to` from the start. At 1 the result is exactly `to`.
Params blended(const Params& from, const Params& to, double share);

}  // namespace viewing
