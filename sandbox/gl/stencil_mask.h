// A substitute for the stencil buffer of a target that has none: one byte per pixel in a texture, drawn together with
// the color. See render/masks.h for how a pass tests and changes it.
#pragma once

#include "gl/objects.h"

namespace viewing::gl {

class StencilMask {
public:
    StencilMask() = default;
    /// Makes a mask that is 0 everywhere. The textures belong to the target and must outlive the mask.
    StencilMask(glm::ivec2 size_px, GLuint color_texture, GLuint depth_texture);

    GLuint texture() const { return mask_.name(); }       ///< value / 255 as red
    GLuint previous() const { return previous_.name(); }  ///< the copy made by keep_previous(), in the same format
    /// Returns the framebuffer with the target's color as attachment 0, the mask as attachment 1, and the target's
    /// depth.
    GLuint draw_framebuffer() const { return drawing_.name(); }
    GLuint read_framebuffer() const { return reading_.name(); }  ///< the mask as attachment 0

    void clear() const;          ///< sets the mask to 0 everywhere
    void keep_previous() const;  ///< copies the mask, so that a pass can test the copy while it changes the mask
    explicit operator bool() const { return static_cast<bool>(mask_); }

private:
    glm::ivec2 size_px_{0};
    Texture mask_, previous_;
    Framebuffer drawing_, reading_;
};

}  // namespace viewing::gl
