// Makes the fragments computed for a pixel agree with the values read back there: where surfaces fight, GL's rounding
// decides. Read fragments.h first.
#pragma once

#include "frame/pixel_report.h"
#include "topics/depth/numbers/fragments.h"

namespace viewing {

/// Makes `fragments` agree with `report`; both must belong to the same pixel of the same plan. The fragment read back
/// becomes the last one drawn and gets the code read back; comparisons with it use that code. Fragments whose codes no
/// longer explain their fate are marked as decided by rounding.
///
/// Changes nothing for the background, or for pixels that rounding does not explain: near an edge, GL may show no
/// surface or a different one, and elsewhere a mirror image may have written the depth.
///
/// If depth is not cleared, the buffer holds values of the previous frame: comparisons with these use the code read
/// back, even if nothing passes.
void reconcile(std::vector<Fragment>& fragments, const PixelReport& report, bool clears_depth);

}  // namespace viewing
