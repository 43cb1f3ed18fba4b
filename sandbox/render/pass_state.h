// A pass's state as GL calls. Every pass sets every piece of state it depends on, and after a frame all of it is GL's
// default again, so that nothing leaks into the next pass or into the user interface. Read renderer.cpp next.
#pragma once

#include "frame/plan.h"
#include "gl/objects.h"

namespace viewing {

void enable(GLenum capability, bool on);

/// Tests, masks, culling, blending and clip planes; not the polygon offset, which is each object's own.
void apply_state(const Pass& pass, const gl::Capabilities& capabilities);

/// The stencil test with a reference in place of the pass's own.
void apply_stencil(const StencilState& stencil, int reference);

void restore_defaults(const gl::Capabilities& capabilities);

}  // namespace viewing
