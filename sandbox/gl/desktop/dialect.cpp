#include "gl/dialect.h"

#include <algorithm>

#include "gl/gl.h"

namespace viewing::gl {
namespace {

/// Both standards fix how the version begins. epoxy_is_desktop_gl(), which also looks for the context, takes 4 % of a
/// frame.
bool is_es() {
    return std::string_view(reinterpret_cast<const char*>(glGetString(GL_VERSION))).starts_with("OpenGL ES");
}

}  // namespace

const char* shader_version() {
    return is_es() ? "#version 300 es" : "#version 330 core";
}

std::string_view shader_opening() {
    return is_es() ? "#version 300 es\nprecision highp float;\nprecision highp int;\nprecision highp sampler2D;\n"
                   : "#version 330 core\n";
}

void set_clear_depth(double depth) {
    is_es() ? glClearDepthf(static_cast<GLfloat>(depth)) : glClearDepth(depth);
}

void set_clip_depths_from_zero(bool from_zero) {
    glClipControl(GL_LOWER_LEFT, from_zero ? GL_ZERO_TO_ONE : GL_NEGATIVE_ONE_TO_ONE);
}

std::string driver_name() {
    const std::string name(reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
    return "OpenGL 3.3 core · " + name.substr(0, name.find(" ("));
}

void copy_pixel_pack_buffer(std::span<std::uint8_t> bytes) {
    const auto size = static_cast<GLsizeiptr>(bytes.size());
    if (!is_es()) return glGetBufferSubData(GL_PIXEL_PACK_BUFFER, 0, size, bytes.data());
    const auto* const mapped =
        static_cast<const std::uint8_t*>(glMapBufferRange(GL_PIXEL_PACK_BUFFER, 0, size, GL_MAP_READ_BIT));
    if (mapped != nullptr) std::copy_n(mapped, bytes.size(), bytes.begin());
    glUnmapBuffer(GL_PIXEL_PACK_BUFFER);
}

bool has_clip_control() {
    return !is_es() && (epoxy_gl_version() >= 45 || epoxy_has_gl_extension("GL_ARB_clip_control"));
}

bool has_clip_distance() {
    return !is_es();
}

bool can_read_depth_stencil() {
    return !is_es();
}

bool has_debug_output() {
    return (!is_es() && epoxy_gl_version() >= 43) || epoxy_has_gl_extension("GL_KHR_debug");
}

// Only llvmpipe benefits: hardware drivers optimize a whole program better, because they then see both stages.
bool has_shared_stages() {
    return !is_es() && (epoxy_gl_version() >= 41 || epoxy_has_gl_extension("GL_ARB_separate_shader_objects")) &&
           driver_name().find("llvmpipe") != std::string::npos;
}

}  // namespace viewing::gl
