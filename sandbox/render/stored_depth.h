// Measures the precision with which the driver stores depth, and the unit of its polygon offset, by drawing rows of
// pixels that pass or fail the depth test. Works even if depth cannot be read back.
#pragma once

#include "frame/driver_depth.h"
#include "gl/objects.h"
#include "gl/target.h"
#include "text/result.h"

namespace viewing {

/// Measures what the driver provides for `kind`. Needs a current context; leaves GL in its default state. Fails if the
/// driver refuses the shader.
Result<StoredDepth> measure_stored_depth(const gl::Capabilities& capabilities, gl::DepthKind kind);

}  // namespace viewing
