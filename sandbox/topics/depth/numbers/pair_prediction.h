// Predicts how two surfaces fight: an interval for the fraction of their pixels that show the wrong surface. The
// interval holds for any float32 arithmetic; some pairs get no prediction. Pure;
// topics/depth/measured/fighting_measure.h counts the wrong pixels that GL draws.
#pragma once

#include <optional>

#include "topics/depth/numbers/fighting.h"

namespace viewing {

/// A fraction of a pair's pixels, from 0 to 1.
struct ShareInterval {
    double least = 0.0, most = 1.0;
    bool holds(double share) const { return least <= share && share <= most; }
};

/// Returns the fraction of wrong pixels for two surfaces whose codes fall on the pixels at random. The surfaces are
/// `gap_codes` to `most_gap_codes` apart, where gap_codes ≤ most_gap_codes, and arithmetic moves them by at most
/// `arithmetic_codes` relative to each other. `tie_is_wrong`: the wrong surface is visible if both have the same code.
/// Without arithmetic errors, the probability of such a tie is 1 − gap, or 0 for gaps of at least one code.
ShareInterval share_of_random_codes(double gap_codes, double most_gap_codes, double arithmetic_codes,
                                    bool tie_is_wrong);

/// The prediction for the camera's position.
struct PairPrediction {
    double distance = 0.0;  ///< eye distance of the overlap's center
    bool is_seen = false;   ///< part of the overlap is in the view; unknown if the projection has no distances
    double step = 0.0;      ///< depth_step() there
    FightingOnset onset;    ///< in eye distance, at the visible point that needs the widest gap
    double slant = 1.0;     ///< at that point: gap along the normal ÷ gap in eye distance; 0: seen edge-on
    /// The fraction of the pair's pixels that are wrong; none if it cannot be predicted to within nine tenths. There is
    /// no prediction for a pair that is out of view or whose surfaces cross, a depth function that does not compare
    /// nearness, a depth buffer that is not written or not cleared to the farthest depth, depths that may equal the
    /// cleared code, logarithms per vertex, arithmetic errors as large as the codes, surfaces that cross too few codes
    /// (all of their pixels may have the same code) or more than one code every two pixels (the codes then depend on
    /// the pixels' positions), decals drawn with GL_EQUAL, and a polygon offset whose effect is not measured and is not
    /// certain to exceed one code.
    std::optional<ShareInterval> wrong_share;
};

/// Predicts a pair in a picture of this size. The part of the overlap inside the view counts, even where it is hidden.
PairPrediction predict_pair(const FlatPair& pair, const Params& params, const Derived& derived, glm::ivec2 size_px);

}  // namespace viewing
