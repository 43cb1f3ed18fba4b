// Finds the smallest gap that a depth buffer resolves, by drawing: two parallel quads move closer together until a
// pixel shows the wrong one. See topics/depth/numbers/fighting.h for the formulas, and fighting_measure.h for the
// counting.
#pragma once

#include <memory>

#include "platform/progress.h"
#include "render/renderer.h"
#include "topics/depth/numbers/fighting_report.h"

namespace viewing {

/// Searches with GL, using the state's lens, depth format, mapping, test, function and mask; ignores the state's depth
/// offset and scene, and whether it clears depth correctly. The pair is placed where depth resolution is coarsest: at
/// the far end of the interval that one code covers, close to `distance`. A gap is wide enough if no pixel is wrong,
/// whichever quad is drawn first. Draws one picture per step, so that a window can do other work in between.
class MinimumGapSearch {
public:
    MinimumGapSearch(const Renderer& renderer, const Params& state, double distance);
    MinimumGapSearch(MinimumGapSearch&&) noexcept;
    MinimumGapSearch& operator=(MinimumGapSearch&&) noexcept;
    ~MinimumGapSearch();

    bool is_done() const;
    /// Draws one more small picture. The error comes from GL, or says that the work was canceled; an error ends the
    /// search.
    Status step(Renderer& renderer, WorkProgress* progress = nullptr);
    const MinimumGap& found() const;  ///< valid once the search is done

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

/// Runs the whole search.
Result<MinimumGap> find_minimum_gap(Renderer& renderer, const Params& params, double distance,
                                    WorkProgress* progress = nullptr);

}  // namespace viewing
