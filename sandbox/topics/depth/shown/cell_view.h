// The cell view: a block of pixels, as on the lecture's Z-buffer slide. Its colors and its depths are side by side, and
// both grids fill up one draw call or one triangle at a time.
#pragma once

#include "session/session.h"
#include "topics/depth/numbers/depth_data.h"
#include "ui/parts/layout.h"
#include "widgets/diagrams.h"

namespace viewing {

/// Draws the step bar, the color and depth buffers below it, and the comparison that decides the cell under the pointer
/// or, if the pointer is on no cell, the current pixel. Clicking a cell pins its pixel; clicking the pinned cell
/// releases it.
void draw_cell_view(Session& session, const DepthData& data, const FramePlan& plan, const Rect& rect,
                    widgets::StepPlayer& player);

/// Returns the requested number of columns and rows or, without a request, as many as are legible; at least 1 × 1.
glm::ivec2 cell_block_size(const Rect& rect, const std::optional<glm::ivec2>& asked);

}  // namespace viewing
