// The rows around the step bar: above it, the size of the raster; below it, the two levels of the steps, and the steps
// that touch the followed pixel.
#pragma once

#include "state/params.h"
#include "topics/hidden/numbers/hidden_surfaces.h"

namespace viewing {

/// Draws a toggle for the small raster, and fields for its columns and rows.
void draw_raster_row(Params& params);

/// Draws one row for the steps that touch the followed pixel, one for the step's group, and one for the step within its
/// group. The first two rows have buttons that go back and forward. Omits the last two rows if the method's steps have
/// only one level.
void draw_step_rows(Params& params, const HiddenResult& result);

/// Draws one line with the buttons of draw_step_rows(), buttons for single steps, and the step's progress. The line is
/// for a view beside the picture, where it stays visible however far the panel is scrolled.
void draw_step_line(Params& params, const HiddenResult& result);

}  // namespace viewing
