#include "gl/target.h"

#include <algorithm>
#include <cassert>

namespace viewing::gl {
namespace {

Texture color_texture_of(glm::ivec2 size_px) {
    return texture_2d(GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, size_px);
}

Renderbuffer multisampled(GLenum format, const TargetSpec& spec) {
    Renderbuffer buffer = make_renderbuffer();
    glBindRenderbuffer(GL_RENDERBUFFER, buffer.name());
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, spec.samples, format, spec.size_px.x, spec.size_px.y);
    return buffer;
}

struct DepthStorage {
    GLenum internal_format, format, type, attachment;
};

DepthStorage storage_of(DepthKind kind) {
    switch (kind) {
        case DepthKind::d24_s8:
            return {GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, GL_DEPTH_STENCIL_ATTACHMENT};
        case DepthKind::d32f_s8:
            return {GL_DEPTH32F_STENCIL8, GL_DEPTH_STENCIL, GL_FLOAT_32_UNSIGNED_INT_24_8_REV,
                    GL_DEPTH_STENCIL_ATTACHMENT};
        case DepthKind::d16:
            break;
    }
    return {GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT, GL_DEPTH_ATTACHMENT};
}

void assert_complete() {
    assert(glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
}

}  // namespace

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

Target::Target(const TargetSpec& spec)
    : spec_(spec), color_(color_texture_of(spec.size_px)), single_(make_framebuffer()) {
    const DepthStorage storage = storage_of(spec.depth);
    glBindFramebuffer(GL_FRAMEBUFFER, single_.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color_.name(), 0);
    if (spec.samples == 0) {
        depth_ = texture_2d(storage.internal_format, storage.format, storage.type, spec.size_px);
        glFramebufferTexture2D(GL_FRAMEBUFFER, storage.attachment, GL_TEXTURE_2D, depth_.name(), 0);
    } else {
        assert_complete();
        multi_ = make_framebuffer();
        samples_color_ = multisampled(GL_RGBA8, spec);
        samples_depth_ = multisampled(storage.internal_format, spec);
        glBindFramebuffer(GL_FRAMEBUFFER, multi_.name());
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, samples_color_.name());
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, storage.attachment, GL_RENDERBUFFER, samples_depth_.name());
    }
    assert_complete();
    glDepthMask(GL_TRUE);
    glStencilMask(0xFF);
    if (has_stencil()) {
        glClearBufferfi(GL_DEPTH_STENCIL, 0, 1.0F, 0);
    } else {
        static constexpr GLfloat farthest = 1.0F;
        glClearBufferfv(GL_DEPTH, 0, &farthest);
    }
    if (!has_stencil() && spec.samples == 0) mask_ = StencilMask(spec.size_px, color_.name(), depth_.name());
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
    glFinish();  // llvmpipe in Mesa 22.3 sometimes reads before its threads have finished drawing
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
