// Data for the views of the depth buffer, read back from the buffers whenever a view needs it and something has
// changed. The studio fills in the data; the views only read it.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "frame/pixel_report.h"
#include "frame/plan/draw_calls.h"
#include "topics/depth/numbers/fighting_report.h"
#include "topics/depth/numbers/fragments.h"

namespace viewing {

/// Returns the limit just after the triangle that this fragment comes from; none if GL does not draw that triangle.
std::optional<DrawLimit> limit_after(const Fragment& fragment, const std::vector<DrawCall>& calls);

struct DepthData {
    std::optional<PixelReport> pixel;  ///< the pinned pixel or else the pixel under the pointer, if any
    std::vector<Fragment> fragments;   ///< on that pixel's ray, in drawing order

    std::vector<DrawCall> calls;     ///< of the whole frame, in order
    std::vector<DrawLimit> touches;  ///< just after each triangle of the whole frame that sends that pixel a fragment
    CellBlock before, now;           ///< around that pixel, one step earlier and at the step shown
    std::vector<std::optional<Fragment>> incoming;  ///< per cell: the fragment that the step sends to that cell

    DepthCounts depth_counts;  ///< of the camera's picture

    std::shared_ptr<const FightingReport> fighting;  ///< null: nothing has been counted yet
};

}  // namespace viewing
