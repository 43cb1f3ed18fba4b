// Moves from one state to another in small steps, to animate a reveal.
#pragma once

#include "state/params.h"

namespace viewing {

/// Returns the state at the fraction `share` (0 … 1) of the way. Numbers change evenly, or by equal factors in
/// logarithmic fields; everything else equals `to` from the start. If `share` is 1, the result is exactly `to`.
Params blended(const Params& from, const Params& to, double share);

}  // namespace viewing
