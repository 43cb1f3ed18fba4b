// What is at a pixel, and in a block of them, as it was read back from the buffers. Filled by render/probe.h.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "geometry/projection.h"
#include "state/params.h"

namespace viewing {

/// What `inspect`, the status bar and the pixel view say about one pixel.
struct PixelReport {
    glm::ivec2 pixel{0};  ///< (0, 0) is the top left one
    Color color;
    bool written = false;  ///< some surface was drawn here
    std::string object;    ///< "" for the background, "plane" for the patch
    bool front_facing = true;
    bool has_depth = false;     ///< other than a cleared buffer's; else eye_z, step and world say nothing
    double window_depth = 1.0;  ///< as read back
    std::uint32_t stored = 0;   ///< the integer code, or the bits of the float
    DepthPrecision precision;
    double ndc_z = 0.0;
    double eye_z = 0.0;            ///< negative in front of the camera; like step and world 0 without depth
    double step = 0.0;             ///< width in eye z of one code there: depth_step()
    double resolvable_step = 0.0;  ///< what can be told apart there: resolvable_depth_step()
    int stencil = 0;
    glm::dvec3 world{0.0};
};

/// The state to plan and draw when pixels are asked about: the scene's own colours in place of counts, differences and
/// the heat map, which say nothing about the surface at a pixel.
inline Params probed(Params params) {
    Shows& shows = params.view.shows;
    if (shows == Shows::overdraw || shows == Shows::difference || shows == Shows::fighting) shows = Shows::color;
    return params;
}

/// One pixel of a block.
struct BufferCell {
    Color color;
    std::uint32_t stored = 0;   ///< the integer code, or the bits of the float
    double window_depth = 1.0;  ///< as read back
    bool operator==(const BufferCell&) const = default;
};

/// A block of pixels, the top row first.
struct CellBlock {
    glm::ivec2 first_pixel{0};  ///< its top left one
    glm::ivec2 size{0};         ///< columns and rows
    std::vector<BufferCell> cells;

    const BufferCell& at(glm::ivec2 cell) const { return cells[static_cast<std::size_t>(cell.y * size.x + cell.x)]; }
};

/// How often eye distances occur in a depth buffer: bins of equal width between near and far on the scale of the view.
struct DepthCounts {
    std::vector<std::uint32_t> counts;
    double min = 0.0, max = 1.0;  ///< eye distance, or window depth where the scale is that
    std::uint64_t unwritten = 0;  ///< pixels that hold what the buffer was cleared to
};

}  // namespace viewing
