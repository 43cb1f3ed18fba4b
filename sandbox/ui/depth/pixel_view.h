// The pixel view: what is at the pixel that is pinned or pointed at, the chain of numbers that its depth went through,
// and every surface on its ray. Read pixel_numbers.h and fragment_table.h next.
#pragma once

#include "frame/depth/depth_data.h"
#include "frame/derive.h"
#include "frame/pinned_pixel.h"
#include "session/session.h"
#include "ui/parts/layout.h"

namespace viewing {

/// `pinned`: as the state says, to tell why there is nothing where something is pinned.
void draw_pixel_view(Session& session, const Derived& derived, const DepthData& data, const PinnedPixel& pinned,
                     const Rect& rect);

}  // namespace viewing
