// Computes how depth precision is spread between near and far: the step as a function of eye distance, for every format
// and mapping, and the positions of the codes. Pure. Read near_advice.h next; topics/depth/shown/precision_view.h draws
// the result.
#pragma once

#include <cstdint>
#include <vector>

#include "text/message.h"
#include "topics/depth/numbers/fighting.h"

namespace viewing {

/// The points of a curve: (eye distance, step Δz), from near to far.
using StepPoints = std::vector<glm::dvec2>;

/// The curve of the total step Δz for one format and mapping.
struct StepCurve {
    DepthFormat format = DepthFormat::d24;
    DepthMapping mapping = DepthMapping::standard;
    StepPoints points;
};

struct PrecisionCurves {
    StepCurve current;                    ///< the state's own: the sum of the next two
    StepPoints quantization, arithmetic;  ///< fighting_onset()'s terms
    std::vector<StepCurve> others;        ///< 16 bit, 24 bit and float32 with each mapping, except the current one
};

/// Returns the curves for the state's near and far. Each curve begins at the first distance whose code is certain to
/// differ from that of the near plane.
PrecisionCurves precision_curves(const Params& params, const Derived& derived);

/// Returns a curve's name: "24 bit", "24 rev", "float log".
Message short_name(DepthFormat format, DepthMapping mapping);

/// Evenly spaced codes (up to rounding), from the near plane's code to the far plane's.
struct DepthCodes {
    std::vector<std::uint32_t> codes;   ///< as stored; for a float format, its bits
    std::vector<double> eye_distances;  ///< the distances they represent
    std::int64_t codes_per_tick = 1;
};

/// Returns the codes at the ends of equal intervals: every code if there are at most `most_ticks` + 1 of them;
/// otherwise, the number of intervals is the largest power of two up to `most_ticks`. A `most_ticks` below 2 counts as
/// 2.
DepthCodes depth_codes(const Lens& lens, DepthMapping mapping, const DepthPrecision& precision, int most_ticks);

/// States where half of the codes lie or, for a float format, how many lie in the farther half of the range.
Message codes_sentence(const Lens& lens, DepthMapping mapping, const DepthPrecision& precision);

}  // namespace viewing
