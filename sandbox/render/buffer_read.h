// Reads the buffers of a view as numbers: colors, stored depths, and stencil values. See probe.h for their meaning.
#pragma once

#include <vector>

#include "frame/pixel_report.h"
#include "gl/fence.h"
#include "render/present.h"
#include "render/renderer.h"

namespace viewing {

/// A rectangle of pixels inside a view; (0, 0) is the top left pixel.
struct PixelRect {
    glm::ivec2 first_pixel{0};
    glm::ivec2 size{1};
};

/// Depth and stencil of one pixel, as stored in the buffers. `stencil` is the value of the mask if the target has no
/// stencil.
struct StoredPixel {
    double window_depth = 1.0;
    std::uint32_t code = 0;  ///< the integer code, or the bits of the float
    int stencil = 0;
    bool operator==(const StoredPixel&) const = default;
};

/// The same pixel of two views with targets of the same kind: one shows colors, the other identities.
struct ReadPixel {
    Color color, identity;
    StoredPixel stored;
};

/// Reads views that were drawn without multisampling, and leaves GL in its default state. Rows are ordered from the
/// top.
///
/// If GL cannot read depth and stencil, this class draws them into a color buffer, depth as the bytes of a float32.
/// The values read are exact, except that a 24-bit code may be off by one.
class BufferReader {
public:
    /// `capabilities` are those of the renderer that drew the views.
    static Result<BufferReader> make(const gl::Capabilities& capabilities);

    /// Returns the colors that the passes drew, even if the view shows depth or counts instead.
    std::vector<Color> colors(const View& view, const PixelRect& rect) const;
    std::vector<StoredPixel> stored(const View& view, DepthFormat format, const PixelRect& rect);

    /// Makes a histogram of the whole buffer on the plan's depth scale: 128 bins of equal width, between near and far
    /// or from 0 to 1. For a view with multisampling, which cannot be read, the counts are empty.
    DepthCounts count_depths(const View& view, const FramePlan& plan);

    /// Requests a pixel without waiting; drops an earlier request whose pixel has not arrived. The views must not
    /// change until the pixel has arrived.
    void ask(const View& view, glm::ivec2 pixel);
    bool is_asked() const { return asked_.has_value(); }
    /// Returns the requested pixel once, as soon as it has arrived. Never waits.
    std::optional<ReadPixel> take(const View& view, const View& identities, DepthFormat format);
    void drop() { asked_.reset(); }

private:
    /// A request waits until the drawing is done before it starts the copy, because llvmpipe in Mesa 22.3 sometimes
    /// reads before its threads have finished drawing.
    struct Asked {
        glm::ivec2 pixel{0};
        gl::Fence drawn, copied;
    };
    /// The format in which to read the bound framebuffer.
    struct ReadFormat {
        GLenum format, type;
    };
    explicit BufferReader(const gl::Capabilities& capabilities)
        : capabilities_(capabilities), programs_(capabilities) {}

    void read_depths(const View& view, const PixelRect& rect);
    void read_stencil(const View& view, const PixelRect& rect);
    /// Draw depths or stencil values as colors if GL cannot read them; otherwise do nothing.
    void draw_depths(const View& view, const PixelRect& rect);
    void draw_stencil(const View& view, const PixelRect& rect);
    void begin_bytes(gl::ColorTarget& bytes, const View& view, const PixelRect& rect);
    ReadFormat bind_depths(const View& view) const;
    ReadFormat bind_stencil(const View& view) const;
    /// Converts a value read from GL to an integer code or, for a float buffer, to the bits of the float.
    std::uint32_t depth_of(std::uint32_t given, const DepthPrecision& in_buffer) const;
    void copy(const View& view, const View& identities);

    gl::Capabilities capabilities_;
    Programs programs_;
    Fullscreen fullscreen_;
    gl::ColorTarget depth_bytes_, stencil_bytes_;  ///< depths and stencil values, drawn as bytes
    std::optional<Asked> asked_;
    gl::Buffer copied_;                   ///< four bytes each for color, depth, stencil, identity
    std::vector<std::uint32_t> depths_;   ///< as read: codes of 16 or 24 bits, or bits of floats; rows from the bottom
    std::vector<std::uint8_t> stencils_;  ///< rows from the bottom
};

}  // namespace viewing
