// Computes the parameters at a given time, for everything that moves without user input.
#pragma once

#include "state/params.h"

namespace viewing {

/// Elapsed time, and the light's rotation so far. The rotation is accumulated because the speed may change during the
/// motion.
struct Moment {
    double time_s = 0.0;
    double light_turn_deg = 0.0;
};

/// Returns whether anything moves.
bool is_animated(const Params& params);

/// Returns the moment `dt_s` later.
Moment advanced(Moment moment, const Params& params, double dt_s);

/// Returns the parameters at `moment`; at time 0 they equal `params`. The camera jitters, mostly sideways, by up to
/// about a thousandth of the target's distance. The chosen light rotates about the world's y axis, counterclockwise as
/// seen from above.
Params animated(const Params& params, const Moment& moment);

}  // namespace viewing
