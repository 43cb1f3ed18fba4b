#include "gl/stencil_mask.h"

#include <cassert>

#include "gl/target.h"

namespace viewing::gl {

StencilMask::StencilMask(glm::ivec2 size_px, GLuint color_texture, GLuint depth_texture)
    : size_px_(size_px),
      mask_(texture_2d(GL_R8, GL_RED, GL_UNSIGNED_BYTE, size_px)),
      previous_(texture_2d(GL_R8, GL_RED, GL_UNSIGNED_BYTE, size_px)),
      drawing_(make_framebuffer()),
      reading_(make_framebuffer()) {
    glBindFramebuffer(GL_FRAMEBUFFER, drawing_.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color_texture, 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, GL_TEXTURE_2D, mask_.name(), 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_texture, 0);
    assert(glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
    glBindFramebuffer(GL_FRAMEBUFFER, reading_.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, mask_.name(), 0);
    assert(glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
    clear();
}

void StencilMask::clear() const {
    static constexpr GLfloat unmarked[4] = {};
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, reading_.name());
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glClearBufferfv(GL_COLOR, 0, unmarked);
}

void StencilMask::keep_previous() const {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, reading_.name());
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, previous_.name());
    glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, size_px_.x, size_px_.y);
}

}  // namespace viewing::gl
