// The controls above the cell view: which draw call and which triangle of it the frame stops after.
#pragma once

#include "ui/depth/cell_layout.h"
#include "ui/depth/cell_view.h"

namespace viewing {

/// Columns and rows of the block, as a list `width` pixels wide.
void choose_cells(std::optional<glm::ivec2>& cells, float width);

/// Edits params.view.call and triangle; goes on by itself while it plays.
void draw_cell_bar(Session& session, const DepthData& data, const FramePlan& plan, const CellLayout& layout,
                   widgets::StepPlayer& player);

}  // namespace viewing
