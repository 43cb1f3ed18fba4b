// Translates the state of a pass into GL calls. Every pass sets all state that it depends on, so that nothing leaks
// into the next pass. After a frame, all of that state has GL's default values again, so that nothing leaks into the
// user interface. Read renderer.cpp next.
#pragma once

#include "frame/plan/plan.h"
#include "gl/objects.h"

namespace viewing {

void enable(GLenum capability, bool on);

/// Sets tests, masks, culling, blending and clip planes, but not the polygon offset, which differs from object to
/// object.
void apply_state(const Pass& pass, const gl::Capabilities& capabilities);

/// Sets the stencil test, with `reference` instead of the reference in `stencil`.
void apply_stencil(const StencilState& stencil, int reference);

void restore_defaults(const gl::Capabilities& capabilities);

}  // namespace viewing
