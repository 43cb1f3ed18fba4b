// The buffers of a frame made visible: depth, stencil and counts become colours in a picture of their own.
// Read buffer_read.h for their numbers.
#pragma once

#include "frame/plan.h"
#include "gl/target.h"
#include "render/programs.h"

namespace viewing {

/// Draws without a mesh: one triangle over the whole target.
class Fullscreen {
public:
    void draw(const ShaderProgram& program) const;  ///< which is in use then

private:
    gl::VertexArray no_vertices_ = gl::make_vertex_array();
};

/// Adds up the stencil bits of the framebuffer as its red, one masked test each: stencil cannot be sampled or read
/// everywhere. Its other colours become 0; the caller restores state.
void gather_stencil(GLuint framebuffer, const ConstantProgram& constant, const Fullscreen& fullscreen);

/// Needs a frame that was drawn without samples; leaves GL's default state.
class Presenter {
public:
    /// Keeps references to both.
    Presenter(const gl::Capabilities& capabilities, Programs& programs)
        : capabilities_(capabilities), programs_(programs) {}

    const Fullscreen& fullscreen() const { return fullscreen_; }

    Status depth(const FramePlan& plan, const gl::Target& from, const gl::ColorTarget& into);
    Status stencil(const gl::Target& from, const gl::ColorTarget& into);  ///< uses up the colours of `from`
    Status overdraw(const gl::Target& from, const gl::ColorTarget& into);

private:
    /// With the texture in unit 0.
    void draw_into(const gl::ColorTarget& into, GLuint texture, const ShaderProgram& program) const;

    const gl::Capabilities& capabilities_;
    Programs& programs_;
    Fullscreen fullscreen_;
};

}  // namespace viewing
