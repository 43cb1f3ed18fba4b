// The smallest gap that a depth buffer tells apart, found by drawing: a pair of parallel quads is pushed together until
// a pixel shows the wrong one. Read frame/fighting.h for what the formulas say, fighting_measure.h for the counting.
#pragma once

#include <optional>
#include <string>

#include "frame/fighting.h"
#include "render/renderer.h"
#include "visibility/progress.h"

namespace viewing {

/// Lengths are eye distances. The quads face the eye but for a few degrees, so that their depths cross many codes.
struct MinimumGap {
    double distance = 0.0;      ///< of the farther quad
    FightingOnset predicted;    ///< at that distance
    std::optional<double> gap;  ///< the smallest one with no wrong pixel, to within 5 %
    int pictures = 0;           ///< drawn and read back
    std::string problem;        ///< a sentence where no gap was found
};

/// Searches with GL at the state's lens, depth format, mapping, test, function and mask; its offset and scene play no
/// part. The pair stands where depth tells the least apart: at the far end of a code, the one nearest to `distance`. A
/// gap is wide enough when no pixel is wrong whichever quad is drawn first. The error is GL's, or says that the work
/// was cancelled.
Result<MinimumGap> find_minimum_gap(Renderer& renderer, const Params& params, double distance,
                                    WorkProgress* progress = nullptr);

}  // namespace viewing
