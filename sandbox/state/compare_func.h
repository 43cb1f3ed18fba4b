// The comparisons of glDepthFunc and glStencilFunc. They are also correct for the bit patterns of floats ≥ 0,
// which sort in the same order as the floats.
#pragma once

#include "state/depth_params.h"

namespace viewing {

/// Returns whether the incoming value passes the test against the stored one.
template <typename Value>
constexpr bool compare(CompareFunc func, Value incoming, Value stored) {
    switch (func) {
        case CompareFunc::never:
            return false;
        case CompareFunc::less:
            return incoming < stored;
        case CompareFunc::equal:
            return incoming == stored;
        case CompareFunc::lequal:
            return incoming <= stored;
        case CompareFunc::greater:
            return incoming > stored;
        case CompareFunc::notequal:
            return incoming != stored;
        case CompareFunc::gequal:
            return incoming >= stored;
        case CompareFunc::always:
            break;
    }
    return true;
}

}  // namespace viewing
