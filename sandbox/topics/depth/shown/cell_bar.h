// The controls above the cell view, which set the draw call and the triangle after which the frame stops.
#pragma once

#include "topics/depth/shown/cell_layout.h"
#include "topics/depth/shown/cell_view.h"

namespace viewing {

/// Draws a list from which to choose the block size (columns × rows). The list is `width` pixels wide.
void choose_cells(std::optional<glm::ivec2>& cells, float width);

/// Draws the controls. Edits params.view.call and params.view.triangle, and advances them during playback.
void draw_cell_bar(Session& session, const DepthData& data, const FramePlan& plan, const CellLayout& layout,
                   widgets::StepPlayer& player);

}  // namespace viewing
