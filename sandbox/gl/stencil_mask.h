// What stands in for the stencil of a target that has none: one byte a pixel in a texture, drawn beside the colour.
// Read render/masks.h for how a pass tests and changes it.
#pragma once

#include "gl/objects.h"

namespace viewing::gl {

class StencilMask {
public:
    StencilMask() = default;
    /// The mask starts as 0. The textures are the target's own, which lives as long.
    StencilMask(glm::ivec2 size_px, GLuint color_texture, GLuint depth_texture);

    GLuint texture() const { return mask_.name(); }       ///< value / 255 as red
    GLuint previous() const { return previous_.name(); }  ///< what keep_previous() has kept, alike
    /// The target's colour as attachment 0, the mask as attachment 1, and the target's depth.
    GLuint draw_framebuffer() const { return drawing_.name(); }
    GLuint read_framebuffer() const { return reading_.name(); }  ///< the mask as attachment 0

    void clear() const;          ///< to 0, everywhere
    void keep_previous() const;  ///< copies, to be tested while the mask changes
    explicit operator bool() const { return static_cast<bool>(mask_); }

private:
    glm::ivec2 size_px_{0};
    Texture mask_, previous_;
    Framebuffer drawing_, reading_;
};

}  // namespace viewing::gl
