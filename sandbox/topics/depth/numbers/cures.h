// The cures for depth fighting. Each is applied alone, as one change to the state, so that wrong pixels can be counted
// for all cures in the same scene. Pure.
#pragma once

#include <optional>
#include <vector>

#include "frame/derive.h"
#include "text/message.h"

namespace viewing {

enum class CureKind { near, float_format, reversed_float, logarithmic, offset, equal, stencil };

struct Cure {
    CureKind kind = CureKind::near;
    Message name;         ///< short: "near 3.4"
    Message explanation;  ///< its setting, in a sentence or two
    Params params;        ///< the state with the cure applied; unchanged if the state already has it
};

/// Returns the cures in the order of CureKind, without those for decals if the scene has none. The cure that changes
/// near uses largest_near(), even if near is already fine; it changes nothing if something reaches the eye.
std::vector<Cure> cures(const Params& params, const Derived& derived, const Scene& scene);

}  // namespace viewing
