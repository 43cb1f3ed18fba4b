// A software renderer compiles a fragment shader anew for each stencil test, of which only the reference may change
// freely: what is drawn alike is given one test where that lets the same fragments through. Read renderer.cpp next.
#pragma once

#include <span>
#include <vector>

#include "frame/plan.h"

namespace viewing {

/// The stencil's state for each pass of a frame that begins with a cleared stencil: what passes, and what is left in
/// the stencil, is as the passes have it. "Equal to the highest region" becomes "at least that region", and "no test"
/// "at least 0", for passes that are drawn alike.
std::vector<StencilState> shared_stencil_tests(std::span<const Pass> passes);

}  // namespace viewing
