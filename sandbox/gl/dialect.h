// Hides the differences between OpenGL 3.3 and OpenGL ES 3.0 (WebGL 2), and reports which features of the current
// context go beyond both. No other code asks which of the two is in use.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace viewing::gl {

/// Returns "#version 330 core" or "#version 300 es", without a newline, for libraries with their own shaders.
const char* shader_version();

/// Returns the first lines of every shader: its version, and default precisions for types that have none.
std::string_view shader_opening();

/// Sets the depth that a clear writes, from 0 to 1.
void set_clear_depth(double depth);

/// Switches clip depths to 0 … w instead of −w … w. Needs clip control.
void set_clip_depths_from_zero(bool from_zero);

/// Returns a short description of the driver: "OpenGL 3.3 core · llvmpipe".
std::string driver_name();

/// Copies the first bytes of the buffer bound to GL_PIXEL_PACK_BUFFER; waits until GL has written them.
void copy_pixel_pack_buffer(std::span<std::uint8_t> bytes);

bool has_clip_control();        ///< glClipControl: clip depths from 0 to w
bool has_clip_distance();       ///< gl_ClipDistance
bool can_read_depth_stencil();  ///< glReadPixels reads depth and stencil
bool has_debug_output();        ///< GL reports errors as they happen
bool has_shared_stages();       ///< stages.h works, and the driver compiles each vertex stage on the CPU

}  // namespace viewing::gl
