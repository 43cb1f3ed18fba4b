// What is done against depth fighting, each by itself: the state with that one thing changed, so that all of them can
// be counted on the same fight. Pure.
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
    std::string explanation;  ///< what it sets, in a sentence or two
    Params params;            ///< the state with it, or just the state where it is so already
};

/// In the order of CureKind, those for decals only where the scene has some. Near goes to what near_advice() would have
/// it at, wherever it is now, and stays where something reaches up to the eye.
std::vector<Cure> cures(const Params& params, const Derived& derived, const Scene& scene);

}  // namespace viewing
