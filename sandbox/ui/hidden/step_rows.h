// Below the bar of steps: its two levels, the followed pixel's own steps, and how many pixels there are.
#pragma once

#include "frame/hidden/hidden_surfaces.h"
#include "state/params.h"

namespace viewing {

/// A switch for the small raster and its columns and rows.
void draw_raster_row(Params& params);

/// The steps that touch the followed pixel, the step's group among all, and the step within its group, with buttons to
/// the next and the one before. Groups are left out for a method whose steps are one level.
void draw_step_rows(Params& params, const HiddenResult& result);

/// The same buttons in one line, those for single steps too, and how far the step has come: for a view beside the
/// picture, wherever the panel is scrolled to.
void draw_step_line(Params& params, const HiddenResult& result);

}  // namespace viewing
