// Removes a light or a plane from its list, with everything that belongs to it elsewhere in the state.
#pragma once

#include "state/params.h"

namespace viewing {

/// Moves the later lights or planes up, together with their matrices entered by hand. The chosen element stays chosen;
/// if it is removed, the next one is chosen, or the last. `index` must exist; the last remaining element cannot be
/// removed.
void remove_light(Params& params, std::size_t index);
void remove_plane(Params& params, std::size_t index);

}  // namespace viewing
