// Owners of GL objects: move-only, and empty until an object is made. An owner deletes its object. An empty owner needs
// no context.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "gl/gl.h"
#include "text/result.h"

namespace viewing::gl {

/// A GL name and its deleter.
template <typename Deleter>
class Handle {
public:
    Handle() = default;
    explicit Handle(GLuint name) : name_(name) {}
    Handle(Handle&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    Handle& operator=(Handle&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }
    ~Handle() {
        if (name_ != 0) Deleter{}(name_);
    }

    GLuint name() const { return name_; }
    explicit operator bool() const { return name_ != 0; }

private:
    GLuint name_ = 0;
};

struct DeleteBuffer {
    void operator()(GLuint name) const { glDeleteBuffers(1, &name); }
};
struct DeleteVertexArray {
    void operator()(GLuint name) const { glDeleteVertexArrays(1, &name); }
};
struct DeleteTexture {
    void operator()(GLuint name) const { glDeleteTextures(1, &name); }
};
struct DeleteRenderbuffer {
    void operator()(GLuint name) const { glDeleteRenderbuffers(1, &name); }
};
struct DeleteFramebuffer {
    void operator()(GLuint name) const { glDeleteFramebuffers(1, &name); }
};
struct DeleteProgram {
    void operator()(GLuint name) const { glDeleteProgram(name); }
};

using Buffer = Handle<DeleteBuffer>;
using VertexArray = Handle<DeleteVertexArray>;
using Texture = Handle<DeleteTexture>;
using Renderbuffer = Handle<DeleteRenderbuffer>;
using Framebuffer = Handle<DeleteFramebuffer>;
using Program = Handle<DeleteProgram>;

Buffer make_buffer();
VertexArray make_vertex_array();
Texture make_texture();
Renderbuffer make_renderbuffer();
Framebuffer make_framebuffer();

/// Compiles and links a program; `defines` are lines that follow shader_opening(). The error contains the driver's log.
Result<Program> make_program(std::string_view vertex_source, std::string_view fragment_source,
                             std::string_view defines = "");

/// Returns the driver's log of compiling and linking, without a newline at the end.
std::string log_of(const Program& program);

/// Features that some drivers lack, most of them beyond the common subset of GL 3.3 and WebGL 2; see gl/dialect.h.
struct Capabilities {
    bool clip_control = false;
    bool clip_distance = false;
    bool read_depth_stencil = false;
    bool multisampling = true;   ///< with 4 samples: required by both standards, but missing in softpipe
    bool shared_stages = false;  ///< gl/stages.h
    static Capabilities of_current_context();
};

}  // namespace viewing::gl
