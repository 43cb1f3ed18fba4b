// Taking a light or a plane out of its list, with what belongs to it elsewhere in the state.
#pragma once

#include "state/params.h"

namespace viewing {

/// The lights and planes behind the removed one move up with their matrices by hand, and the chosen one stays chosen;
/// where it is the removed one, the next is, or the last. The index is that of an element; the last one that is left
/// cannot be removed.
void remove_light(Params& params, std::size_t index);
void remove_plane(Params& params, std::size_t index);

}  // namespace viewing
