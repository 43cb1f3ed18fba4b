#include "render/masks.h"

#include <algorithm>
#include <cassert>

#include "render/pass_state.h"
#include "render/uniforms.h"

namespace viewing {
namespace {

/// Beyond the units of pictures that surfaces are drawn from.
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
    assert(!use.writes || pass.blend != Blend::add);  // marks are bytes that blending leaves as they are
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
    glUniform1i(program.mask_texture, mask_unit);
    glUniform1i(program.mask_func, static_cast<int>(stencil.func));
    glUniform1i(program.mask_reference, std::clamp(reference, 0, 255));
    glUniform1i(program.mask_read_bits, stencil.read_bits);
    glUniform1i(program.mask_write_bits, stencil.write_bits);
    glUniform1i(program.mask_op, static_cast<int>(stencil.on_pass));
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
    glUseProgram(program.program.name());
    glUniform1i(program.previous_mask, mask_unit);
    glUniform1i(program.changed_mask, changed_mask_unit);
    set_vector(program.value, glm::vec4(pass.color));
    fullscreen.draw(program.program);
}

}  // namespace viewing
