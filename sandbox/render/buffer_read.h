// A view's buffers as numbers: colours, depths as they are stored, stencil values. Read probe.h for what they mean.
#pragma once

#include <vector>

#include "frame/pixel_report.h"
#include "gl/fence.h"
#include "render/present.h"
#include "render/renderer.h"

namespace viewing {

/// Some pixels of a view; (0, 0) is the top left one. It must lie inside the view.
struct PixelRect {
    glm::ivec2 first_pixel{0};
    glm::ivec2 size{1};
};

/// Depth and stencil of one pixel, as the buffers hold them; of a target without a stencil, its mask.
struct StoredPixel {
    double window_depth = 1.0;
    std::uint32_t code = 0;  ///< the integer code, or the bits of the float
    int stencil = 0;
    bool operator==(const StoredPixel&) const = default;
};

/// What a pixel of two views holds, whose targets are alike: one shows colours, the other identities.
struct ReadPixel {
    Color color, identity;
    StoredPixel stored;
};

/// Reads views that were drawn without samples, and leaves GL's default state. Rows come from the top.
///
/// Where GL cannot read depth and stencil they are drawn into a picture, depth as the bytes of a float32: exact but for
/// 24 bits, where a code may be off by one.
class BufferReader {
public:
    /// For the capabilities of the renderer that drew the views.
    static Result<BufferReader> make(const gl::Capabilities& capabilities);

    /// The colours that the passes drew, also where the view shows depth or counts in their place.
    std::vector<Color> colors(const View& view, const PixelRect& rect) const;
    std::vector<StoredPixel> stored(const View& view, DepthFormat format, const PixelRect& rect);

    /// The whole buffer on the plan's depth scale: 128 bins of equal width, between near and far or from 0 to 1. What a
    /// view with samples holds cannot be read: nothing is counted.
    DepthCounts count_depths(const View& view, const FramePlan& plan);

    /// Asks for a pixel without waiting; what was asked for before and has not come is dropped. The views have to stay
    /// as they are until it has come.
    void ask(const View& view, glm::ivec2 pixel);
    bool is_asked() const { return asked_.has_value(); }
    /// The pixel that was asked for, once, when it has come. Never waits.
    std::optional<ReadPixel> take(const View& view, const View& identities, DepthFormat format);
    void drop() { asked_.reset(); }

private:
    /// A pixel is first waited for to be drawn, then to be copied: llvmpipe of Mesa 22.3 at times reads before its
    /// threads have drawn.
    struct Asked {
        glm::ivec2 pixel{0};
        gl::Fence drawn, copied;
    };
    /// The framebuffer to be read is bound.
    struct ReadFormat {
        GLenum format, type;
    };
    explicit BufferReader(const gl::Capabilities& capabilities)
        : capabilities_(capabilities), programs_(capabilities) {}

    void read_depths(const View& view, const PixelRect& rect);
    void read_stencil(const View& view, const PixelRect& rect);
    /// Where GL cannot read them; else nothing.
    void draw_depths(const View& view, const PixelRect& rect);
    void draw_stencil(const View& view, const PixelRect& rect);
    void begin_bytes(gl::ColorTarget& bytes, const View& view, const PixelRect& rect);
    ReadFormat bind_depths(const View& view) const;
    ReadFormat bind_stencil(const View& view) const;
    /// The code or the bits of the float, of what GL gave.
    std::uint32_t depth_of(std::uint32_t given, const DepthPrecision& in_buffer) const;
    void copy(const View& view, const View& identities);

    gl::Capabilities capabilities_;
    Programs programs_;
    Fullscreen fullscreen_;
    gl::ColorTarget depth_bytes_, stencil_bytes_;  ///< what they are drawn into
    std::optional<Asked> asked_;
    gl::Buffer copied_;                   ///< four bytes each: colour, depth, stencil, identity
    std::vector<std::uint32_t> depths_;   ///< as read: codes of 16 or 24 bits, or bits of floats; rows from the bottom
    std::vector<std::uint8_t> stencils_;  ///< alike
};

}  // namespace viewing
