// What the views of the depth buffer tell about, read back from the buffers whenever a view wants it and something
// changed. The studio fills it; the views only read it.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "frame/depth/fighting_report.h"
#include "frame/depth/fragments.h"
#include "frame/draw_calls.h"
#include "frame/pixel_report.h"

namespace viewing {

/// Just after the triangle that sends a fragment; none where GL is sent no such call.
std::optional<DrawLimit> limit_after(const Fragment& fragment, const std::vector<DrawCall>& calls);

struct DepthData {
    std::optional<PixelReport> pixel;  ///< the pinned pixel, else the one under the pointer; none: neither
    std::vector<Fragment> fragments;   ///< on its ray, in drawing order

    std::vector<DrawCall> calls;     ///< of the whole frame, in order
    std::vector<DrawLimit> touches;  ///< of the whole frame: just after each triangle that sends that pixel a fragment
    CellBlock before, now;           ///< around that pixel, one step before and at the step that is shown
    std::vector<std::optional<Fragment>> incoming;  ///< of each cell: the fragment that the step sends to it

    DepthCounts depth_counts;  ///< of the camera's picture

    std::shared_ptr<const FightingReport> fighting;  ///< null: nothing is counted yet
};

}  // namespace viewing
