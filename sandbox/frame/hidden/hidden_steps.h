// Finds the polygons drawn and the operations counted up to a step. Part of hidden_surfaces.cpp.
#pragma once

#include "frame/hidden/hidden_surfaces.h"

namespace viewing {

/// Finds each polygon's last fragment, and the fragments of the followed pixel, among all tests of the software depth
/// buffer.
void find_fragment_steps(HiddenResult& result, const RasterResult& all);
/// Finds the steps that draw a polygon over the followed pixel. `all`: the result of painting the whole order.
void find_polygon_steps(HiddenResult& result, const RasterResult& all);

/// Counts steps, and finds how far into the order the requested step reaches; the order must be known.
void find_step(HiddenResult& result);

/// Counts the operations of Newell's tests and of the tree's construction up to the step; the other counts cover all
/// steps.
void count_to_step(HiddenResult& result);

}  // namespace viewing
