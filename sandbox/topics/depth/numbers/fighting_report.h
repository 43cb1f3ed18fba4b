// The data of the depth fighting view: each pair's prediction and counts, and the smallest gap found. Plain data:
// topics/depth/measured/fighting_measure.h counts the pixels, topics/depth/measured/minimum_gap.h searches for the gap,
// and topics/depth/measured/fighting_counter.h fills in the data.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "topics/depth/numbers/cures.h"
#include "topics/depth/numbers/pair_prediction.h"

namespace viewing {

/// A pair and its pixels. A pixel belongs to the pair if the rays through its center and through the centers of all its
/// neighbors meet both objects, and one of the two is visible.
struct CountedPair {
    FlatPair pair;
    std::int64_t wrong = 0;     ///< where GL does not show the surface that should be visible
    std::int64_t vanished = 0;  ///< of these, where GL shows the background
    std::int64_t pixels = 0;

    double wrong_fraction() const;  ///< 0 without pixels
};

struct FightingCounts {
    std::vector<CountedPair> pairs;
    std::int64_t wrong_elsewhere = 0;     ///< wrong pixels outside the pairs, away from edges
    std::int64_t bleeding_elsewhere = 0;  ///< of these, where GL shows an object behind the visible one
    std::int64_t vanished_elsewhere = 0;  ///< of these, where GL shows the background
    std::int64_t pixels_elsewhere = 0;

    std::int64_t vanished() const;  ///< in all pairs and elsewhere
    /// Fraction of the pixels of all pairs; 0 if there are no pixels.
    double wrong_fraction() const;
};

/// The range and mean of a pair's fraction of wrong pixels, as seen by several cameras that jitter like
/// animation.jiggle. The depth codes at the pixels are practically random, so a single picture says little.
struct ShareSpread {
    int cameras = 0;  ///< those that see pixels of the pair
    double sum = 0.0, sum_of_squares = 0.0, least = 1.0, most = 0.0;
    double mean() const { return cameras > 0 ? sum / cameras : 0.0; }
    double deviation() const;       ///< of one camera's share; 0 for fewer than two
    double standard_error() const;  ///< of the mean
    void take(double share);
};

/// The smallest gap that depth resolves. Lengths are eye distances. The search's quads are turned a few degrees away
/// from facing the eye, so that their depths cross many codes.
struct MinimumGap {
    double distance = 0.0;      ///< of the farther quad
    FightingOnset predicted;    ///< at that distance
    std::optional<double> gap;  ///< the smallest gap without a wrong pixel, to within 5 %
    int pictures = 0;           ///< drawn and read back
    std::string problem;        ///< a sentence if no gap was found
};

struct FightingReport {
    /// One row per entry of counts.pairs.
    struct Row {
        std::string first, second;  ///< the objects' names, in drawing order
        PairPrediction predicted;
        ShareSpread spread;  ///< `cameras` is 0 until the spread is known
    };
    FightingCounts counts;
    /// A cure and its counts, for the same pairs and in a picture of the same size.
    struct Cured {
        Cure cure;
        std::optional<FightingCounts> counts;  ///< none until counted
    };
    std::vector<Row> rows;                  ///< one per pair in the counts
    std::vector<Cured> cured;               ///< in the order of cures(); empty without pairs
    glm::ivec2 size_px{0};                  ///< of the counted picture
    std::optional<MinimumGap> minimum_gap;  ///< none: not searched for yet
    bool counts_are_behind = false;         ///< the counts belong to an earlier state
    bool gap_is_behind = false;
    bool spread_is_behind = false;
    std::string problem;  ///< a sentence if nothing could be counted
};

/// The number of cameras in a spread. jittered() returns the state with one of them (counted from 0): the state's own
/// camera, jittered.
constexpr int spread_cameras = 12;
Params jittered(const Params& state, int camera);

/// Returns the counts with the names and predictions of their pairs.
FightingReport fighting_report(FightingCounts counts, const Params& params, const Derived& derived, const Scene& scene,
                               glm::ivec2 size_px);

}  // namespace viewing
