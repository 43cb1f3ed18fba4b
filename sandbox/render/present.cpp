#include "render/present.h"

#include <algorithm>

#include "frame/depth/depth_colors.h"
#include "frame/ground.h"
#include "render/pass_state.h"
#include "render/uniforms.h"

namespace viewing {
namespace {

/// grey = (value − first) · slope, of an eye distance or a window depth.
struct GreyScale {
    float first, slope;
};

/// A range without width makes a step from black to white.
GreyScale grey_scale(const FramePlan& plan) {
    const auto value_at = [&](double distance) {
        return plan.depth_scale == DepthScale::linear ? distance
                                                      : window_depth(plan.lens, plan.depth_mapping, distance);
    };
    const double first = value_at(plan.shown_range.x), width = value_at(plan.shown_range.y) - first;
    constexpr double steepest = 1e30;  // fits a float
    return {static_cast<float>(first),
            static_cast<float>(width == 0.0 ? steepest : std::clamp(1.0 / width, -steepest, steepest))};
}

}  // namespace

void Fullscreen::draw(const gl::Program& program) const {
    glUseProgram(program.name());
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
    glUseProgram(constant.program.name());
    for (int bit = 1; bit <= 128; bit *= 2) {
        glStencilFunc(GL_EQUAL, bit, static_cast<GLuint>(bit));
        glUniform4f(constant.value, static_cast<float>(bit) / 255.0F, 0.0F, 0.0F, 0.0F);
        fullscreen.draw(constant.program);
    }
}

void Presenter::draw_into(const gl::ColorTarget& into, GLuint texture, const gl::Program& program) const {
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
    glUseProgram(program.program.name());
    glUniform1i(program.mapping, static_cast<int>(plan.depth_mapping));
    glUniform1i(program.linear_scale, plan.depth_scale == DepthScale::linear);
    glUniform1i(program.orthographic, plan.lens.orthographic);
    glUniform2f(program.near_far, static_cast<float>(plan.lens.near), static_cast<float>(plan.lens.far));
    const GreyScale scale = grey_scale(plan);
    glUniform1f(program.shown_first, scale.first);
    glUniform1f(program.shown_slope, scale.slope);
    glUniform1i(program.shows_bands, plan.depth_colors == DepthColors::bands);
    set_colors(program.bands, depth_bands);
    glUniform1f(program.cleared, static_cast<float>(plan.clear_depth_value));
    set_vector(program.unwritten_color, srgb(plan.unwritten));
    draw_into(into, from.depth_texture(), program.program);
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
    glUseProgram((*show)->program.name());
    set_colors((*show)->stencil_colors, stencil_colors);
    draw_into(into, from.has_stencil() ? from.color_texture() : from.mask().texture(), (*show)->program);
    return std::monostate{};
}

Status Presenter::overdraw(const gl::Target& from, const gl::ColorTarget& into) {
    Result<const ShowOverdrawProgram*> show = programs_.show_overdraw();
    if (!show) return Error{show.error()};
    glUseProgram((*show)->program.name());
    set_colors((*show)->overdraw_colors, overdraw_colors);
    draw_into(into, from.color_texture(), (*show)->program);
    return std::monostate{};
}

}  // namespace viewing
