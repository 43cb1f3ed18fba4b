// The pixel view: the pixel that is pinned or under the pointer, the chain of numbers behind its depth, and every
// surface on its ray. Read pixel_numbers.h and fragment_table.h next.
#pragma once

#include "frame/derive.h"
#include "frame/pinned_pixel.h"
#include "session/session.h"
#include "topics/depth/numbers/depth_data.h"
#include "ui/parts/layout.h"

namespace viewing {

/// `pinned`: the state's pinned pixel, or the reason why it is not visible.
void draw_pixel_view(Session& session, const Derived& derived, const DepthData& data, const PinnedPixel& pinned,
                     const Rect& rect);

}  // namespace viewing
