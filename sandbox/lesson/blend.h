// From one state to another in small steps, as a reveal shows a change.
#pragma once

#include "state/params.h"

namespace viewing {

/// `share` of the way, 0 … 1: numbers go there evenly, those of logarithmic fields by equal factors; everything else is
/// as in `to` from the beginning. At 1 it is `to` exactly.
Params blended(const Params& from, const Params& to, double share);

}  // namespace viewing
