#include "render/pass_state.h"

namespace viewing {
namespace {

GLenum gl_enum(CompareFunc func) {
    return GL_NEVER + static_cast<GLenum>(func);
}

}  // namespace

void enable(GLenum capability, bool on) {
    on ? glEnable(capability) : glDisable(capability);
}

void apply_stencil(const StencilState& stencil, int reference) {
    enable(GL_STENCIL_TEST, stencil.test);
    glStencilFunc(gl_enum(stencil.func), reference, static_cast<GLuint>(stencil.read_bits));
    glStencilMask(static_cast<GLuint>(stencil.write_bits));
    static constexpr GLenum ops[] = {GL_KEEP, GL_REPLACE, GL_INCR, GL_DECR, GL_INVERT, GL_ZERO};
    glStencilOp(GL_KEEP, GL_KEEP, ops[static_cast<std::size_t>(stencil.on_pass)]);
}

void apply_state(const Pass& pass, const gl::Capabilities& capabilities) {
    enable(GL_DEPTH_TEST, pass.depth.test);
    glDepthFunc(gl_enum(pass.depth.func));
    glDepthMask(pass.depth.write ? GL_TRUE : GL_FALSE);

    enable(GL_CULL_FACE, pass.cull.enabled);
    static constexpr GLenum faces[] = {GL_FRONT, GL_BACK, GL_FRONT_AND_BACK};
    glCullFace(faces[static_cast<std::size_t>(pass.cull.face)]);
    glFrontFace(pass.cull.front_face == FrontFace::ccw ? GL_CCW : GL_CW);

    apply_stencil(pass.stencil, pass.stencil.reference);

    enable(GL_BLEND, pass.blend != Blend::none);
    if (pass.blend == Blend::add)
        glBlendFuncSeparate(GL_ONE, GL_ONE, GL_ZERO, GL_ONE);
    else
        glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    const GLboolean writes = pass.color_write ? GL_TRUE : GL_FALSE;
    glColorMask(writes, writes, writes, writes);

    if (capabilities.clip_distance)
        for (std::size_t plane = 0; plane < 2; ++plane)
            enable(GL_CLIP_DISTANCE0 + static_cast<GLenum>(plane), plane < pass.clip_planes.size());
}

void restore_defaults(const gl::Capabilities& capabilities) {
    Pass defaults;
    defaults.depth.test = false;
    defaults.cull = CullParams{};
    apply_state(defaults, capabilities);
    glDisable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(0.0F, 0.0F);
    glBlendFunc(GL_ONE, GL_ZERO);
    glClearColor(0.0F, 0.0F, 0.0F, 0.0F);
    glClearDepth(1.0);
    if (capabilities.clip_control) glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    glBindVertexArray(0);
    glUseProgram(0);
}

}  // namespace viewing
