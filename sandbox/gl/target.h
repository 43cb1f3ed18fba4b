// An own framebuffer: colour to show as a texture, depth and stencil to read back, multisampled or not.
#pragma once

#include <vector>

#include "gl/objects.h"

namespace viewing::gl {

/// What a target is made of; two equal specs are the same target.
struct TargetSpec {
    glm::ivec2 size_px{0};
    int samples = 0;           ///< 0 or 4
    bool float_depth = false;  ///< DEPTH32F_STENCIL8 in place of DEPTH24_STENCIL8
    bool operator==(const TargetSpec&) const = default;
};

class Target {
public:
    Target() = default;
    explicit Target(const TargetSpec& spec);  ///< depth starts as 1, stencil as 0

    const TargetSpec& spec() const { return spec_; }
    glm::ivec2 size_px() const { return spec_.size_px; }

    GLuint draw_framebuffer() const;  ///< what passes draw into
    void resolve() const;             ///< multisampled colour → texture; nothing to do without samples
    GLuint color_texture() const { return color_.name(); }
    GLuint depth_texture() const { return depth_stencil_.name(); }  ///< only without samples
    GLuint single_framebuffer() const { return single_.name(); }    ///< colour texture (and depth without samples)

private:
    TargetSpec spec_;
    Texture color_, depth_stencil_;
    Framebuffer single_;
    Renderbuffer samples_color_, samples_depth_stencil_;
    Framebuffer multi_;
};

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
