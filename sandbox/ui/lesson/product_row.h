// The product of a question's tiles as it grows: a small matrix for the first tile, the first two, and so on.
#pragma once

#include "lesson/lesson_run.h"
#include "widgets/widgets.h"

namespace viewing {

/// Returns the height that the products of a right answer need at this width, in one or more rows; 0 if the tiles have
/// no factors. Also works outside a frame.
float product_row_height(const Ask& ask, float width, const widgets::Context& context);

/// Draws the products below the tiles. If there are more products than in a right answer, shows only the last ones.
void draw_product_row(const LessonRun& run, float width);

}  // namespace viewing
