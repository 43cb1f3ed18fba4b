// What moves by itself: the parameters as they are at a time.
#pragma once

#include "state/params.h"

namespace viewing {

/// Whether anything moves.
bool is_animated(const Params& params);

/// At 0 s they are the parameters themselves. The camera's tremor is a thousandth of the target's distance, sideways.
/// The light turns about the world's y axis, counter-clockwise seen from above where its speed is positive.
Params animated(const Params& params, double time_s);

}  // namespace viewing
