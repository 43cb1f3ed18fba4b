// What the formulas say of two surfaces that can fight: how many of their pixels show the wrong one, as an interval
// that holds whatever float32 arithmetic does, or nothing. Pure; measure/fighting_measure.h counts what GL makes of
// them.
#pragma once

#include <optional>

#include "frame/depth/fighting.h"

namespace viewing {

/// Of the pixels of a pair, from 0 to 1.
struct ShareInterval {
    double least = 0.0, most = 1.0;
    bool holds(double share) const { return least <= share && share <= most; }
};

/// The share of wrong pixels of surfaces `gap_codes` to `most_gap_codes` (not less) apart, whose codes meet the pixels
/// at random. Arithmetic moves the two by at most `arithmetic_codes` against each other. A tie is the same code.
/// Without arithmetic a tie has the probability 1 − gap, and none from one code on.
ShareInterval share_of_random_codes(double gap_codes, double most_gap_codes, double arithmetic_codes,
                                    bool tie_is_wrong);

/// From where the camera is.
struct PairPrediction {
    double distance = 0.0;  ///< eye distance of the overlap's centre
    double step = 0.0;      ///< depth_step() there
    FightingOnset onset;    ///< in eye distance
    double slant = 1.0;     ///< a gap along the normal divided by it is the gap in eye distance; 0: seen edge-on
    /// Of the pair's pixels. None where it cannot be said to within nine tenths: out of the view, a depth function that
    /// does not go by nearness, a depth buffer that is not cleared to what is farthest, the cleared code itself,
    /// logarithms at the corners, arithmetic as coarse as the codes, surfaces that cross too few codes (all of their
    /// pixels have the same one) or more than one in two pixels (which ones goes by where pixels fall), decals by
    /// GL_EQUAL, and a polygon offset that is not sure to be more than a code.
    std::optional<ShareInterval> wrong_share;
};

/// In a picture of that size. The overlap counts as far as the view holds it, hidden parts included.
PairPrediction predict_pair(const FlatPair& pair, const Params& params, const Derived& derived, glm::ivec2 size_px);

}  // namespace viewing
