// The layout of the cell view, in pixels of the window.
#pragma once

#include <glm/glm.hpp>

#include "ui/parts/layout.h"

namespace viewing {

struct CellLayout {
    bool has_step_bar = false;  ///< the full step bar fits
    bool has_calls = true;      ///< the draw calls can be chosen
    bool calls_above = false;   ///< the calls have their own row above the steps
    Rect calls, steps;          ///< rows of controls; identical if has_calls is false
    float caption_height = 0.0F;
    Rect colors, depths;  ///< the grids, without their captions
    Rect sentence;
    glm::ivec2 block{1};  ///< how many columns and rows fit with legible numbers
};

/// Returns the layout of a view that fills `rect`.
CellLayout lay_out_cells(const Rect& rect);

}  // namespace viewing
