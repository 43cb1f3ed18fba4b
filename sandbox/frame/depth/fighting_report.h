// What the view of depth fighting tells: pair by pair what is predicted and what was counted, and the smallest gap that
// was found. Plain data; measure/fighting_measure.h counts, measure/minimum_gap.h searches, measure/fighting_counter.h
// fills it in.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "frame/depth/fighting.h"

namespace viewing {

/// A pair and its pixels: those through whose centre, and through those of all their neighbours, both objects are met
/// and one of the two is what is seen.
struct CountedPair {
    FlatPair pair;
    std::int64_t wrong = 0;  ///< where GL shows something else than what is seen
    std::int64_t pixels = 0;

    double wrong_fraction() const;  ///< 0 where there are no pixels
};

struct FightingCounts {
    std::vector<CountedPair> pairs;
    std::int64_t wrong_elsewhere = 0;  ///< away from edges too: what an offset that is too large lets through
    std::int64_t pixels_elsewhere = 0;

    /// Of all pairs' pixels; 0 where there are none.
    double wrong_fraction() const;
};

/// The smallest gap that is told apart. Lengths are eye distances. The quads that it was searched with face the eye but
/// for a few degrees, so that their depths cross many codes.
struct MinimumGap {
    double distance = 0.0;      ///< of the farther quad
    FightingOnset predicted;    ///< at that distance
    std::optional<double> gap;  ///< the smallest one with no wrong pixel, to within 5 %
    int pictures = 0;           ///< drawn and read back
    std::string problem;        ///< a sentence where no gap was found
};

struct FightingReport {
    /// One of counts.pairs.
    struct Row {
        std::string first, second;  ///< the objects' names, in drawing order
        PairPrediction predicted;
    };
    FightingCounts counts;
    std::vector<Row> rows;                  ///< of each pair in the counts
    glm::ivec2 size_px{0};                  ///< of the picture in which they were counted
    std::optional<MinimumGap> minimum_gap;  ///< none: not searched yet
    bool counts_are_behind = false;         ///< they belong to an earlier state
    bool gap_is_behind = false;
    std::string problem;  ///< a sentence where nothing could be counted
};

/// The counts with the names and predictions of their pairs.
FightingReport fighting_report(FightingCounts counts, const Params& params, const Derived& derived, const Scene& scene,
                               glm::ivec2 size_px);

}  // namespace viewing
