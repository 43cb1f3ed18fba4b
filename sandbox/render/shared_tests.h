// A software renderer recompiles a fragment shader for each stencil test; only a change of the reference is free.
// Passes that are drawn alike therefore share one test if it lets the same fragments through. Read renderer.cpp next.
#pragma once

#include <span>
#include <vector>

#include "frame/plan/plan.h"

namespace viewing {

/// Returns the stencil state for each pass of a frame that begins with a cleared stencil. With these states, the same
/// fragments pass and the stencil ends up with the same values as with each pass's own test. For passes that are drawn
/// alike, "equal to the highest region" becomes "at least that region", and "no test" becomes "at least 0".
std::vector<StencilState> shared_stencil_tests(std::span<const Pass> passes);

}  // namespace viewing
