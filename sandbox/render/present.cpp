#include "render/present.h"

#include "render/pass_state.h"

namespace viewing {

void Fullscreen::draw(const ShaderProgram& program) const {
    program.use();
    glBindVertexArray(no_vertices_.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void gather_stencil(GLuint framebuffer, const ConstantProgram& constant, const Fullscreen& fullscreen) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glClearColor(0.0F, 0.0F, 0.0F, 0.0F);
    glClear(GL_COLOR_BUFFER_BIT);
    glEnable(GL_STENCIL_TEST);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    constant.use();
    for (int bit = 1; bit <= 128; bit *= 2) {
        glStencilFunc(GL_EQUAL, bit, static_cast<GLuint>(bit));
        constant.value.set(glm::vec4(static_cast<float>(bit) / 255.0F, 0.0F, 0.0F, 0.0F));
        fullscreen.draw(constant);
    }
}

void Presenter::draw_into(const gl::ColorTarget& into, GLuint texture, const ShaderProgram& program) const {
    glBindFramebuffer(GL_FRAMEBUFFER, into.framebuffer());
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, texture);
    fullscreen_.draw(program);
    restore_defaults(capabilities_);
}

Status Presenter::depth(const FramePlan& plan, const gl::Target& from, const gl::ColorTarget& into) {
    Result<const ShowDepthProgram*> found = programs_.show_depth();
    if (!found) return Error{found.error()};
    const ShowDepthProgram& program = **found;
    program.use();
    program.depth_texture.set(Sampler{0});
    program.mapping.set(plan.depth_mapping);
    program.linear_scale.set(plan.depth_scale == DepthScale::linear);
    program.orthographic.set(plan.lens.orthographic);
    const bool is_logarithmic = plan.depth_mapping == DepthMapping::logarithmic;
    constexpr double as_good_as_infinite = 1e30;  // f − n = f in float32, and n f is still finite
    if (is_logarithmic)
        program.near_far.set(glm::dvec2(plan.lens.logarithmic_near(), plan.lens.logarithmic_far()));
    else
        program.near_far.set(glm::dvec2(plan.lens.near, std::min(plan.lens.far, as_good_as_infinite)));
    const GrayScale scale = gray_scale(plan);
    program.shown_first.set(static_cast<float>(scale.first));
    program.shown_slope.set(static_cast<float>(scale.slope));
    program.shows_bands.set(plan.depth_colors == DepthColors::bands);
    program.bands.set_first(srgb(depth_bands));
    program.cleared.set(plan.clear_depth_value);
    program.unwritten_color.set(srgb(plan.unwritten));
    draw_into(into, from.depth_texture(), program);
    return std::monostate{};
}

Status Presenter::stencil(const gl::Target& from, const gl::ColorTarget& into) {
    Result<const ConstantProgram*> constant = programs_.constant();
    if (!constant) return Error{constant.error()};
    Result<const ShowStencilProgram*> show = programs_.show_stencil();
    if (!show) return Error{show.error()};
    if (from.has_stencil()) {
        gather_stencil(from.draw_framebuffer(), **constant, fullscreen_);
        restore_defaults(capabilities_);
    }
    (*show)->use();
    (*show)->value_texture.set(Sampler{0});
    (*show)->colors.set_first(srgb(stencil_colors));
    draw_into(into, from.has_stencil() ? from.color_texture() : from.mask().texture(), **show);
    return std::monostate{};
}

Status Presenter::overdraw(const gl::Target& from, const gl::ColorTarget& into) {
    Result<const ShowOverdrawProgram*> show = programs_.show_overdraw();
    if (!show) return Error{show.error()};
    (*show)->use();
    (*show)->value_texture.set(Sampler{0});
    (*show)->colors.set_first(srgb(overdraw_colors));
    draw_into(into, from.color_texture(), **show);
    return std::monostate{};
}

}  // namespace viewing
