// What moves by itself: the parameters as they are at a time.
#pragma once

#include "state/params.h"

namespace viewing {

/// Whether anything moves.
bool is_animated(const Params& params);

/// At 0 s they are the parameters themselves. The camera's tremor is a thousandth of the target's distance, sideways.
Params animated(const Params& params, double time_s);

}  // namespace viewing
