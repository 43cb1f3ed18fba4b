// Where the parts of the cell view are. Everything in pixels of the window.
#pragma once

#include <glm/glm.hpp>

#include "ui/parts/layout.h"

namespace viewing {

struct CellLayout {
    bool has_step_bar = false;  ///< there is room for the whole one
    bool has_calls = true;      ///< the draw calls can be chosen
    bool calls_above = false;   ///< in a row of their own
    Rect calls, steps;          ///< rows of controls; overlap where they share one
    float caption_height = 0.0F;
    Rect colors, depths;  ///< the grids, below their captions
    Rect sentence;
    glm::ivec2 block{1};  ///< how many columns and rows of cells can be read
};

/// `rect`: of the whole view.
CellLayout lay_out_cells(const Rect& rect);

}  // namespace viewing
