// The cell view: a block of pixels as on the lecture's Z-buffer slide, colour beside depth, filled draw call by draw
// call and triangle by triangle.
#pragma once

#include "frame/depth/depth_data.h"
#include "session/session.h"
#include "ui/parts/layout.h"
#include "widgets/diagrams.h"

namespace viewing {

/// Above the bar of steps, below it the colour buffer and the depth buffer, and the compare that decides the cell under
/// the pointer, else the pixel. A click on a cell pins its pixel, a click on the pinned one releases it.
void draw_cell_view(Session& session, const DepthData& data, const FramePlan& plan, const Rect& rect,
                    widgets::StepPlayer& player);

/// The columns and rows that are asked for, else as many as fit so that their numbers can be read; at least 1 × 1.
glm::ivec2 cell_block_size(const Rect& rect, const std::optional<glm::ivec2>& asked);

}  // namespace viewing
