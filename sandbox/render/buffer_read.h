// A view's buffers as numbers: colours, depths as they are stored, stencil values. Read probe.h for what they mean.
#pragma once

#include <vector>

#include "frame/pixel_report.h"
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

private:
    explicit BufferReader(const gl::Capabilities& capabilities)
        : capabilities_(capabilities), programs_(capabilities) {}

    void read_depths(const View& view, const PixelRect& rect);
    void read_stencil(const View& view, const PixelRect& rect);
    void draw_depths(const View& view, const PixelRect& rect);
    void draw_stencil(const View& view, const PixelRect& rect);
    void begin_bytes(const View& view, const PixelRect& rect);

    gl::Capabilities capabilities_;
    Programs programs_;
    Fullscreen fullscreen_;
    gl::ColorTarget bytes_;               ///< what depth and stencil are drawn into
    std::vector<std::uint32_t> depths_;   ///< as read: codes of 16 or 24 bits, or bits of floats; rows from the bottom
    std::vector<std::uint8_t> stencils_;  ///< alike
};

}  // namespace viewing
