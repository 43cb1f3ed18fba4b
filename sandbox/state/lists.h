// Removes a light or a plane from its list, together with everything that belongs to it elsewhere in the state.
#pragma once

#include "state/params.h"

namespace viewing {

/// Removes a light or plane, and moves the later ones up together with the matrices that were entered for them by hand.
/// The chosen element stays chosen; if it is the one removed, the next one is chosen instead, or the last one if there
/// is no next. `index` must exist; the last remaining element cannot be removed.
void remove_light(Params& params, std::size_t index);
void remove_plane(Params& params, std::size_t index);

}  // namespace viewing
