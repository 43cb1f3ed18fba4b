// The rows below the step bar: its two levels, the steps of the followed pixel, and the size of the raster.
#pragma once

#include "frame/hidden/hidden_surfaces.h"
#include "state/params.h"

namespace viewing {

/// Draws a toggle for the small raster, and its columns and rows.
void draw_raster_row(Params& params);

/// Draws rows for the steps that touch the followed pixel and for the step's group, both with buttons to the previous
/// and the next one, and for the step within its group. Omits groups if the method's steps have only one level.
void draw_step_rows(Params& params, const HiddenResult& result);

/// Draws the same buttons and those for single steps in one line, with the progress of the step. For a view beside the
/// picture: it stays visible wherever the panel is scrolled.
void draw_step_line(Params& params, const HiddenResult& result);

}  // namespace viewing
