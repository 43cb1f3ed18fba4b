// How the precision of a depth buffer is spread between near and far: the step over the eye distance for every format
// and mapping, and where its codes lie. Pure. Read near_advice.h next; ui/depth/precision_view.h draws it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "frame/depth/fighting.h"

namespace viewing {

/// The points of a curve: (eye distance, step Δz), from near to far.
using StepPoints = std::vector<glm::dvec2>;

/// The whole step of a format and a mapping.
struct StepCurve {
    DepthFormat format = DepthFormat::d24;
    DepthMapping mapping = DepthMapping::standard;
    StepPoints points;
};

struct PrecisionCurves {
    StepCurve current;                    ///< of the state: the sum of the next two
    StepPoints quantisation, arithmetic;  ///< fighting_onset()'s terms
    std::vector<StepCurve> others;        ///< 16 and 24 bit and float32 with each mapping, without the current one
};

/// With the state's near and far. Each curve begins where not even a surface on the near plane shares a code any more.
PrecisionCurves precision_curves(const Params& params, const Derived& derived);

/// "24 bit", "24 rev", "float log": a curve's name.
std::string short_name(DepthFormat format, DepthMapping mapping);

/// Codes that are equally far apart, up to rounding, from that of near to that of far.
struct DepthCodes {
    std::vector<std::uint32_t> codes;   ///< as stored; of a float format its bits
    std::vector<double> eye_distances;  ///< that they mean
    std::int64_t codes_per_tick = 1;
};

/// At most `most_ticks` (at least 2) steps from code to code: all codes where there are so few, else as many steps as a
/// power of two.
DepthCodes depth_codes(const Lens& lens, DepthMapping mapping, const DepthPrecision& precision, int most_ticks);

/// Where half of the codes lie, in a sentence, or of a float format how many lie in the farther half of the way.
std::string codes_sentence(const Lens& lens, DepthMapping mapping, const DepthPrecision& precision);

}  // namespace viewing
