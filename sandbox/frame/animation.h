// What moves by itself: the parameters as they are at a time.
#pragma once

#include "state/params.h"

namespace viewing {

/// How long something has been moving, and how far the light has turned meanwhile: speeds change while it turns.
struct Moment {
    double time_s = 0.0;
    double light_turn_deg = 0.0;
};

/// Whether anything moves.
bool is_animated(const Params& params);

/// So much later.
Moment advanced(Moment moment, const Params& params, double dt_s);

/// At the beginning they are the parameters themselves. The camera's tremor is a thousandth of the target's distance,
/// sideways. The light turns about the world's y axis, counter-clockwise seen from above.
Params animated(const Params& params, const Moment& moment);

}  // namespace viewing
