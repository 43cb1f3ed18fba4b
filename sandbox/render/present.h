// Makes the buffers of a frame visible: draws depth, stencil and counts as colors into another target. See
// buffer_read.h for how to read their numbers.
#pragma once

#include "frame/plan/plan.h"
#include "gl/target.h"
#include "render/programs.h"

namespace viewing {

/// Draws without a mesh: one triangle over the whole target.
class Fullscreen {
public:
    void draw(const ShaderProgram& program) const;  ///< leaves the program current

private:
    gl::VertexArray no_vertices_ = gl::make_vertex_array();
};

/// Converts the stencil of the framebuffer to values in its red channel, with one masked test for each bit, because not
/// every context can sample or read the stencil. The other channels become 0; the caller restores the state.
void gather_stencil(GLuint framebuffer, const ConstantProgram& constant, const Fullscreen& fullscreen);

/// Makes the buffers of a frame visible. The frame must have been drawn without multisampling. Leaves GL in its default
/// state.
class Presenter {
public:
    /// Keeps references to both arguments.
    Presenter(const gl::Capabilities& capabilities, Programs& programs)
        : capabilities_(capabilities), programs_(programs) {}

    const Fullscreen& fullscreen() const { return fullscreen_; }

    Status depth(const FramePlan& plan, const gl::Target& from, const gl::ColorTarget& into);
    Status stencil(const gl::Target& from, const gl::ColorTarget& into);  ///< overwrites the colors of `from`
    Status overdraw(const gl::Target& from, const gl::ColorTarget& into);

private:
    /// Draws with the texture bound to unit 0.
    void draw_into(const gl::ColorTarget& into, GLuint texture, const ShaderProgram& program) const;

    const gl::Capabilities& capabilities_;
    Programs& programs_;
    Fullscreen fullscreen_;
};

}  // namespace viewing
