#include "render/masks.h"

#include <algorithm>
#include <cassert>

#include "render/pass_state.h"

namespace viewing {
namespace {

/// These texture units are above those of the textures that hold a method's surface points.
constexpr GLint mask_unit = 8, changed_mask_unit = 9;

void bind(GLint unit, GLuint texture) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, texture);
    glActiveTexture(GL_TEXTURE0);
}

}  // namespace

MaskUse mask_use(const Pass& pass, const gl::Target& target) {
    if (!target.mask() || !pass.stencil.test) return {};
    MaskUse use;
    use.tests = pass.stencil.func != CompareFunc::always;
    use.writes = pass.stencil.on_pass != StencilOp::keep;
    use.fills = use.tests && use.writes && pass.color_write && pass.shading == Shading::flat;
    assert(!use.writes || pass.blend != Blend::add);  // blending must not change the mask values
    return use;
}

void begin_mask(const Pass& pass, const MaskUse& use, const gl::Target& target) {
    const gl::StencilMask& mask = target.mask();
    if (use.writes) mask.keep_previous();
    if (use.tests || use.writes) bind(mask_unit, use.writes ? mask.previous() : mask.texture());
    glBindFramebuffer(GL_FRAMEBUFFER, use.writes ? mask.draw_framebuffer() : target.draw_framebuffer());
    if (!use.writes) return;
    const bool draws_color = pass.color_write && !use.fills;
    const GLenum buffers[] = {draws_color ? GLenum{GL_COLOR_ATTACHMENT0} : GLenum{GL_NONE}, GL_COLOR_ATTACHMENT1};
    glDrawBuffers(2, buffers);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void set_mask(const SurfaceProgram& program, const StencilState& stencil, int reference) {
    program.mask_texture.set(Sampler{mask_unit});
    program.mask_func.set(stencil.func);
    program.mask_reference.set(std::clamp(reference, 0, 255));
    program.mask_read_bits.set(stencil.read_bits);
    program.mask_write_bits.set(stencil.write_bits);
    program.mask_op.set(stencil.on_pass);
}

void fill_changed(const Pass& pass, const gl::Target& target, const FillProgram& program, const Fullscreen& fullscreen,
                  const gl::Capabilities& capabilities) {
    Pass fill;
    fill.depth = without_depth;
    fill.cull.enabled = false;
    fill.blend = pass.blend;
    apply_state(fill, capabilities);
    glDisable(GL_POLYGON_OFFSET_FILL);
    glBindFramebuffer(GL_FRAMEBUFFER, target.draw_framebuffer());
    bind(mask_unit, target.mask().previous());
    bind(changed_mask_unit, target.mask().texture());
    program.use();
    program.previous_mask.set(Sampler{mask_unit});
    program.changed_mask.set(Sampler{changed_mask_unit});
    program.value.set(pass.color);
    fullscreen.draw(program);
}

}  // namespace viewing
