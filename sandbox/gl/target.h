// Our own framebuffer, with or without multisampling: its color can be shown as a texture, and its depth and stencil
// can be read back.
#pragma once

#include <vector>

#include "gl/stencil_mask.h"

namespace viewing::gl {

/// GL has no format with 16 bits of depth and a stencil, so a d16 target has a mask instead.
enum class DepthKind {
    d24_s8,   ///< DEPTH24_STENCIL8
    d32f_s8,  ///< DEPTH32F_STENCIL8
    d16       ///< DEPTH_COMPONENT16
};

/// Size and format of a target; targets with equal specs are interchangeable.
struct TargetSpec {
    glm::ivec2 size_px{0};
    int samples = 0;  ///< 0 or 4
    DepthKind depth = DepthKind::d24_s8;
    bool operator==(const TargetSpec&) const = default;
};

class Target {
public:
    Target() = default;
    explicit Target(const TargetSpec& spec);  ///< depth is initially 1, stencil 0

    const TargetSpec& spec() const { return spec_; }
    glm::ivec2 size_px() const { return spec_.size_px; }
    bool has_stencil() const { return spec_.depth != DepthKind::d16; }
    const StencilMask& mask() const { return mask_; }  ///< empty if the target has a stencil or is multisampled

    GLuint draw_framebuffer() const;  ///< passes draw into it
    void resolve() const;             ///< multisampled color → texture; does nothing without samples
    GLuint color_texture() const { return color_.name(); }
    GLuint depth_texture() const { return depth_.name(); }        ///< only without samples
    GLuint single_framebuffer() const { return single_.name(); }  ///< color texture (and depth without samples)

private:
    TargetSpec spec_;
    Texture color_, depth_;  ///< depth includes the stencil, if there is one
    Framebuffer single_;
    StencilMask mask_;
    Renderbuffer samples_color_, samples_depth_;
    Framebuffer multi_;
};

/// Makes a texture without contents, for unfiltered fetches and for drawing into.
Texture texture_2d(GLenum internal_format, GLenum format, GLenum type, glm::ivec2 size_px);

/// A color-only target for pictures that are made from another target (visualized depth and stencil) and for the whole
/// window.
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

/// Returns the RGBA bytes of a framebuffer's color, top row first. Finishes all earlier drawing.
std::vector<std::uint8_t> read_pixels(GLuint framebuffer, glm::ivec2 size_px);

}  // namespace viewing::gl
