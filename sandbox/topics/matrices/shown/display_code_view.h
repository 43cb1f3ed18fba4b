// The code of the lecture's display() function, with the camera's numbers filled in. The code is part of the matrix
// column and also has its own view.
#pragma once

#include "frame/derive.h"
#include "ui/parts/layout.h"

namespace viewing {

inline constexpr float display_code_height = 200.0F;  ///< in the column of matrices, with its heading; design pixels

/// Draws the lines one below the other, starting at the cursor.
void draw_display_code(const Params& params, const Derived& derived);

/// Draws the code in the largest size that fits.
void draw_display_code_view(const Params& params, const Derived& derived, const Rect& rect);

}  // namespace viewing
