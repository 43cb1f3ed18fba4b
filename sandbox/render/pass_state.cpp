#include "render/pass_state.h"

#include "gl/dialect.h"

namespace viewing {
namespace {

GLenum gl_enum(CompareFunc func) {
    switch (func) {
        case CompareFunc::never:
            return GL_NEVER;
        case CompareFunc::less:
            return GL_LESS;
        case CompareFunc::equal:
            return GL_EQUAL;
        case CompareFunc::lequal:
            return GL_LEQUAL;
        case CompareFunc::greater:
            return GL_GREATER;
        case CompareFunc::notequal:
            return GL_NOTEQUAL;
        case CompareFunc::gequal:
            return GL_GEQUAL;
        case CompareFunc::always:
            break;
    }
    return GL_ALWAYS;
}

GLenum gl_enum(StencilOp op) {
    switch (op) {
        case StencilOp::keep:
            break;
        case StencilOp::replace:
            return GL_REPLACE;
        case StencilOp::increment:
            return GL_INCR;
        case StencilOp::decrement:
            return GL_DECR;
        case StencilOp::invert:
            return GL_INVERT;
        case StencilOp::zero:
            return GL_ZERO;
    }
    return GL_KEEP;
}

GLenum gl_enum(CullFace face) {
    switch (face) {
        case CullFace::front:
            return GL_FRONT;
        case CullFace::back:
            return GL_BACK;
        case CullFace::front_and_back:
            break;
    }
    return GL_FRONT_AND_BACK;
}

}  // namespace

void enable(GLenum capability, bool on) {
    on ? glEnable(capability) : glDisable(capability);
}

void apply_stencil(const StencilState& stencil, int reference) {
    enable(GL_STENCIL_TEST, stencil.test);
    glStencilFunc(gl_enum(stencil.func), reference, static_cast<GLuint>(stencil.read_bits));
    glStencilMask(static_cast<GLuint>(stencil.write_bits));
    glStencilOp(GL_KEEP, GL_KEEP, gl_enum(stencil.on_pass));
}

void apply_state(const Pass& pass, const gl::Capabilities& capabilities) {
    enable(GL_DEPTH_TEST, pass.depth.test);
    glDepthFunc(gl_enum(pass.depth.func));
    glDepthMask(pass.depth.write ? GL_TRUE : GL_FALSE);

    enable(GL_CULL_FACE, pass.cull.enabled);
    glCullFace(gl_enum(pass.cull.face));
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
        for (std::size_t plane = 0; plane < most_clip_planes; ++plane)
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
    gl::set_clear_depth(1.0);
    if (capabilities.clip_control) gl::set_clip_depths_from_zero(false);
    glBindVertexArray(0);
    glUseProgram(0);
}

}  // namespace viewing
