// An own framebuffer: colour to show as a texture, depth and stencil to read back, multisampled or not.
#pragma once

#include <vector>

#include "gl/stencil_mask.h"

namespace viewing::gl {

/// GL has no format with 16 bits of depth and a stencil: such a target has a mask in its place.
enum class DepthKind {
    d24_s8,   ///< DEPTH24_STENCIL8
    d32f_s8,  ///< DEPTH32F_STENCIL8
    d16       ///< DEPTH_COMPONENT16
};

/// What a target is made of; two equal specs are the same target.
struct TargetSpec {
    glm::ivec2 size_px{0};
    int samples = 0;  ///< 0 or 4
    DepthKind depth = DepthKind::d24_s8;
    bool operator==(const TargetSpec&) const = default;
};

class Target {
public:
    Target() = default;
    explicit Target(const TargetSpec& spec);  ///< depth starts as 1, stencil as 0

    const TargetSpec& spec() const { return spec_; }
    glm::ivec2 size_px() const { return spec_.size_px; }
    bool has_stencil() const { return spec_.depth != DepthKind::d16; }
    const StencilMask& mask() const { return mask_; }  ///< empty with a stencil, and with samples

    GLuint draw_framebuffer() const;  ///< what passes draw into
    void resolve() const;             ///< multisampled colour → texture; nothing to do without samples
    GLuint color_texture() const { return color_.name(); }
    GLuint depth_texture() const { return depth_.name(); }        ///< only without samples
    GLuint single_framebuffer() const { return single_.name(); }  ///< colour texture (and depth without samples)

private:
    TargetSpec spec_;
    Texture color_, depth_;  ///< with the stencil, where there is one
    Framebuffer single_;
    StencilMask mask_;
    Renderbuffer samples_color_, samples_depth_;
    Framebuffer multi_;
};

/// A texture without contents, to be fetched from without filtering and drawn into.
Texture texture_2d(GLenum internal_format, GLenum format, GLenum type, glm::ivec2 size_px);

/// A colour-only target for what is made from another one: depth and stencil shown, the whole window.
class ColorTarget {
public:
    ColorTarget() = default;
    explicit ColorTarget(glm::ivec2 size_px);

    glm::ivec2 size_px() const { return size_px_; }
    GLuint framebuffer() const { return framebuffer_.name(); }
    GLuint texture() const { return color_.name(); }

private:
    glm::ivec2 size_px_{0};
    Texture color_;
    Framebuffer framebuffer_;
};

/// RGBA bytes of a framebuffer's colour, top row first. Ends every drawing before it.
std::vector<std::uint8_t> read_pixels(GLuint framebuffer, glm::ivec2 size_px);

}  // namespace viewing::gl
