// Measures what the driver stores as depth, and the unit of its polygon offset, by drawing: some rows of pixels that
// the depth test lets pass or not. Works where depth cannot be read back.
#pragma once

#include "frame/depth/driver_depth.h"
#include "gl/objects.h"
#include "gl/target.h"
#include "text/result.h"

namespace viewing {

/// Of what the driver gives for that name. Needs a current context; leaves GL's default state. The error is a driver
/// that refuses the shader.
Result<StoredDepth> measure_stored_depth(const gl::Capabilities& capabilities, gl::DepthKind kind);

}  // namespace viewing
