// The fragments that are computed for a pixel, made to agree with what was read back there: where surfaces fight, GL's
// rounding decides. Read fragments.h first.
#pragma once

#include "frame/depth/fragments.h"
#include "frame/pixel_report.h"

namespace viewing {

/// `report` and `fragments` are of the same pixel of the same plan. The fragment that is read back becomes the last one
/// that is drawn and gets the code that is read back; what is compared with it is compared with that code. Those whose
/// fate is no longer what their numbers say are marked as decided by rounding.
///
/// Left alone are the background and pixels that rounding does not explain: where GL has no or another surface because
/// an edge is near, or depth of a mirror image.
///
/// Where depth is not cleared the buffer holds what the frame before has left: what is compared with that is compared
/// with the code that is read back, also where nothing passes.
void reconcile(std::vector<Fragment>& fragments, const PixelReport& report, bool clears_depth);

}  // namespace viewing
