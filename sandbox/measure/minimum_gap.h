// The smallest gap that a depth buffer tells apart, found by drawing: a pair of parallel quads is pushed together until
// a pixel shows the wrong one. Read frame/depth/fighting.h for what the formulas say, fighting_measure.h for the
// counting.
#pragma once

#include <memory>

#include "frame/depth/fighting_report.h"
#include "platform/progress.h"
#include "render/renderer.h"

namespace viewing {

/// Searches with GL at the state's lens, depth format, mapping, test, function and mask; its offset and scene, and
/// whether it clears rightly, play no part. The pair stands where depth tells the least apart: at the far end of a
/// code, the one nearest to `distance`. A gap is wide enough when no pixel is wrong whichever quad is drawn first. Goes
/// on picture by picture, so that a window can do something else in between.
class MinimumGapSearch {
public:
    MinimumGapSearch(const Renderer& renderer, const Params& state, double distance);
    MinimumGapSearch(MinimumGapSearch&&) noexcept;
    MinimumGapSearch& operator=(MinimumGapSearch&&) noexcept;
    ~MinimumGapSearch();

    bool is_done() const;
    /// One small picture further. The error is GL's, or says that the work was cancelled; the search is over then.
    Status step(Renderer& renderer, WorkProgress* progress = nullptr);
    const MinimumGap& found() const;  ///< once it is done

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

/// The whole search at once.
Result<MinimumGap> find_minimum_gap(Renderer& renderer, const Params& params, double distance,
                                    WorkProgress* progress = nullptr);

}  // namespace viewing
