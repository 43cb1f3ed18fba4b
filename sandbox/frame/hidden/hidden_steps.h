// How far a step of a method has come: what is drawn by then, and what has been counted. Part of hidden_surfaces.cpp.
#pragma once

#include "frame/hidden/hidden_surfaces.h"

namespace viewing {

/// Counts steps and says how far the wanted one reaches into the order, which has been found.
void find_step(HiddenResult& result);

/// What Newell's ladder and the tree's build have done by the step; the other numbers are those of all steps.
void count_to_step(HiddenResult& result);

}  // namespace viewing
