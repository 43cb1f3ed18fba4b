// Where OpenGL 3.3 and OpenGL ES 3.0 (WebGL 2) say the same in other words, and what the current context has beyond
// what both have: the only place that asks which of the two it is.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace viewing::gl {

/// "#version 330 core" or "#version 300 es", without a newline: for those who bring shaders of their own.
const char* shader_version();

/// What every shader begins with: its version, and where numbers have none by themselves, their precision.
std::string_view shader_opening();

/// What a clear of depth writes, from 0 to 1.
void set_clear_depth(double depth);

/// Clip depths from 0 to w in the place of −w to w. Only where there is clip control.
void set_clip_depths_from_zero(bool from_zero);

/// "OpenGL 3.3 core · llvmpipe": what draws, for a line of text.
std::string driver_name();

/// The first bytes of the buffer that is bound to GL_PIXEL_PACK_BUFFER; waits until GL has written them.
void copy_pixel_pack_buffer(std::span<std::uint8_t> bytes);

bool has_clip_control();        ///< glClipControl: clip depths from 0 to w
bool has_clip_distance();       ///< gl_ClipDistance
bool can_read_depth_stencil();  ///< glReadPixels gives depth and stencil
bool has_debug_output();        ///< GL tells its errors as they happen
bool has_shared_stages();       ///< stages.h, and a driver that compiles each vertex stage on the processor

}  // namespace viewing::gl
