// The cures for depth fighting, each applied alone: the state with one change, so that all cures can be counted on the
// same fight. Pure.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "frame/derive.h"

namespace viewing {

enum class CureKind { near, float_format, reversed_float, logarithmic, offset, equal, stencil };

struct Cure {
    CureKind kind = CureKind::near;
    std::string name;         ///< short: "near 3.4"
    std::string explanation;  ///< its setting, in a sentence or two
    Params params;            ///< the state with the cure applied; unchanged if it already has it
};

/// Returns the cures in the order of CureKind; those for decals only if the scene has decals. The cure for near uses
/// the value of near_advice() in any case, and changes nothing if something reaches up to the eye.
std::vector<Cure> cures(const Params& params, const Derived& derived, const Scene& scene);

}  // namespace viewing
