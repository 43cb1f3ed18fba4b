// What the view of depth fighting tells: pair by pair what is predicted and what was counted, and the smallest gap that
// was found. Plain data; measure/fighting_measure.h counts, measure/minimum_gap.h searches, measure/fighting_counter.h
// fills it in.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "frame/depth/cures.h"
#include "frame/depth/pair_prediction.h"

namespace viewing {

/// A pair and its pixels: those through whose centre, and through those of all their neighbours, both objects are met
/// and one of the two is what is seen.
struct CountedPair {
    FlatPair pair;
    std::int64_t wrong = 0;     ///< where GL shows something else than what is seen
    std::int64_t vanished = 0;  ///< of them: where GL shows the background
    std::int64_t pixels = 0;

    double wrong_fraction() const;  ///< 0 where there are no pixels
};

struct FightingCounts {
    std::vector<CountedPair> pairs;
    std::int64_t wrong_elsewhere = 0;     ///< away from edges too
    std::int64_t bleeding_elsewhere = 0;  ///< of them: where GL shows an object that is behind what is seen
    std::int64_t vanished_elsewhere = 0;  ///< of them: where GL shows the background
    std::int64_t pixels_elsewhere = 0;

    std::int64_t vanished() const;  ///< of all pairs, and elsewhere
    /// Of all pairs' pixels; 0 where there are none.
    double wrong_fraction() const;
};

/// The share of a pair's wrong pixels from several cameras that tremble as animation.jiggle does: which codes meet the
/// pixels goes by chance, so one picture says little.
struct ShareSpread {
    int cameras = 0;  ///< from which the pair has pixels
    double sum = 0.0, least = 1.0, most = 0.0;
    double mean() const { return cameras > 0 ? sum / cameras : 0.0; }
    void take(double share);
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
        ShareSpread spread;  ///< of no camera until they are counted
    };
    FightingCounts counts;
    /// A cure, and what is counted with it, of the same pairs and in a picture of the same size.
    struct Cured {
        Cure cure;
        std::optional<FightingCounts> counts;  ///< none until they are there
    };
    std::vector<Row> rows;                  ///< of each pair in the counts
    std::vector<Cured> cured;               ///< in the order of cures(); none where there are no pairs
    glm::ivec2 size_px{0};                  ///< of the picture in which they were counted
    std::optional<MinimumGap> minimum_gap;  ///< none: not searched yet
    bool counts_are_behind = false;         ///< they belong to an earlier state
    bool gap_is_behind = false;
    bool spread_is_behind = false;
    std::string problem;  ///< a sentence where nothing could be counted
};

/// How many cameras a spread is taken from, and one of them, from 0: the state's own camera, trembling.
constexpr int spread_cameras = 12;
Params trembling(const Params& state, int camera);

/// The counts with the names and predictions of their pairs.
FightingReport fighting_report(FightingCounts counts, const Params& params, const Derived& derived, const Scene& scene,
                               glm::ivec2 size_px);

}  // namespace viewing
