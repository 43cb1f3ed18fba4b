// Depth fighting counted: GL's picture by object identities, read back, against exact visibility by ray casting.
// Read minimum_gap.h next: from which gap on a depth buffer tells two surfaces apart.
#pragma once

#include <cstdint>
#include <span>

#include "frame/fighting.h"
#include "render/renderer.h"
#include "visibility/progress.h"

namespace viewing {

/// A pair and its pixels: those through whose centre, and through those of all their neighbours, both objects are met
/// and one of the two is what is seen.
struct CountedPair {
    FlatPair pair;
    std::int64_t wrong = 0;  ///< where GL shows something else than what is seen
    std::int64_t pixels = 0;
};

struct FightingCounts {
    std::vector<CountedPair> pairs;
    std::int64_t wrong_elsewhere = 0;  ///< away from edges too: what an offset that is too large lets through
    std::int64_t pixels_elsewhere = 0;

    /// Of all pairs' pixels; 0 where there are none.
    double wrong_fraction() const;
};

/// Draws the scene's objects, alone, with the depth buffer of the state, whatever its hidden-surface method, and counts
/// these pairs: near_coplanar_pairs(scene), as a rule. The error is GL's, or says that the work was cancelled.
Result<FightingCounts> count_fighting(Renderer& renderer, const Params& params, const Scene& scene,
                                      std::span<const FlatPair> pairs, glm::ivec2 size_px,
                                      WorkProgress* progress = nullptr);

}  // namespace viewing
