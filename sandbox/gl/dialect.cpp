#include "gl/dialect.h"

#include "gl/gl.h"

namespace viewing::gl {
namespace {

bool is_es() {
    return !epoxy_is_desktop_gl();
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

}  // namespace viewing::gl
