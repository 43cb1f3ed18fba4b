#include "gl/target.h"

#include <algorithm>
#include <cassert>

namespace viewing::gl {
namespace {

Texture texture_2d(GLenum internal_format, GLenum format, GLenum type, glm::ivec2 size_px) {
    Texture texture = make_texture();
    glBindTexture(GL_TEXTURE_2D, texture.name());
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(internal_format), size_px.x, size_px.y, 0, format, type, nullptr);
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        glTexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
    for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
        glTexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
    return texture;
}

Texture color_texture_of(glm::ivec2 size_px) {
    return texture_2d(GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, size_px);
}

Renderbuffer multisampled(GLenum format, const TargetSpec& spec) {
    Renderbuffer buffer = make_renderbuffer();
    glBindRenderbuffer(GL_RENDERBUFFER, buffer.name());
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, spec.samples, format, spec.size_px.x, spec.size_px.y);
    return buffer;
}

void assert_complete() {
    assert(glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
}

}  // namespace

Target::Target(const TargetSpec& spec)
    : spec_(spec), color_(color_texture_of(spec.size_px)), single_(make_framebuffer()) {
    const GLenum depth_format = spec.float_depth ? GL_DEPTH32F_STENCIL8 : GL_DEPTH24_STENCIL8;
    const GLenum depth_type = spec.float_depth ? GL_FLOAT_32_UNSIGNED_INT_24_8_REV : GL_UNSIGNED_INT_24_8;

    glBindFramebuffer(GL_FRAMEBUFFER, single_.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color_.name(), 0);
    if (spec.samples == 0) {
        depth_stencil_ = texture_2d(depth_format, GL_DEPTH_STENCIL, depth_type, spec.size_px);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_TEXTURE_2D, depth_stencil_.name(), 0);
    } else {
        assert_complete();
        multi_ = make_framebuffer();
        samples_color_ = multisampled(GL_RGBA8, spec);
        samples_depth_stencil_ = multisampled(depth_format, spec);
        glBindFramebuffer(GL_FRAMEBUFFER, multi_.name());
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, samples_color_.name());
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER,
                                  samples_depth_stencil_.name());
    }
    assert_complete();
    glDepthMask(GL_TRUE);
    glStencilMask(0xFF);
    glClearBufferfi(GL_DEPTH_STENCIL, 0, 1.0F, 0);
}

GLuint Target::draw_framebuffer() const {
    return spec_.samples == 0 ? single_.name() : multi_.name();
}

void Target::resolve() const {
    if (spec_.samples == 0) return;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, multi_.name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, single_.name());
    glBlitFramebuffer(0, 0, spec_.size_px.x, spec_.size_px.y, 0, 0, spec_.size_px.x, spec_.size_px.y,
                      GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

ColorTarget::ColorTarget(glm::ivec2 size_px)
    : size_px_(size_px), color_(color_texture_of(size_px)), framebuffer_(make_framebuffer()) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color_.name(), 0);
    assert_complete();
}

std::vector<std::uint8_t> read_pixels(GLuint framebuffer, glm::ivec2 size_px) {
    const auto row_bytes = static_cast<std::size_t>(size_px.x) * 4;
    std::vector<std::uint8_t> pixels(row_bytes * static_cast<std::size_t>(size_px.y));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, size_px.x, size_px.y, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    auto* top = pixels.data();
    auto* bottom = pixels.data() + pixels.size();
    for (int row = 0; row < size_px.y / 2; ++row, top += row_bytes) {
        bottom -= row_bytes;
        std::swap_ranges(top, top + row_bytes, bottom);
    }
    return pixels;
}

}  // namespace viewing::gl
