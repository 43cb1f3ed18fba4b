// How far a step of a method has come: what is drawn by then, and what has been counted. Part of hidden_surfaces.cpp.
#pragma once

#include "frame/hidden/hidden_surfaces.h"

namespace viewing {

/// From all that the software depth buffer tests: the last fragment of each polygon, and those of the followed pixel.
void find_fragment_steps(HiddenResult& result, const RasterResult& all);
/// From the whole order painted: the steps that draw a polygon over the followed pixel.
void find_polygon_steps(HiddenResult& result, const RasterResult& all);

/// Counts steps and says how far the wanted one reaches into the order, which has been found.
void find_step(HiddenResult& result);

/// What Newell's ladder and the tree's build have done by the step; the other numbers are those of all steps.
void count_to_step(HiddenResult& result);

}  // namespace viewing
