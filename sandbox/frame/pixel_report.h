// The contents of a pixel and of a block of pixels, read back from the buffers. render/probe.h fills them.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "geometry/projection.h"
#include "state/params.h"

namespace viewing {

/// One pixel, as reported by `inspect`, the status bar and the pixel view.
struct PixelReport {
    glm::ivec2 pixel{0};  ///< (0, 0) is top left
    Color color;
    bool written = false;  ///< some surface was drawn here
    std::string object;    ///< "" for the background, "plane" for the patch
    bool front_facing = true;
    bool has_depth = false;     ///< depth is not the cleared value; if false, eye_z, step and world are meaningless
    double window_depth = 1.0;  ///< as read back
    std::uint32_t stored = 0;   ///< the integer code, or the bits of the float
    DepthPrecision precision;
    double ndc_z = 0.0;
    double eye_z = 0.0;            ///< negative in front of the camera; 0 without depth, like step and world
    double step = 0.0;             ///< width of one code there, in eye z: depth_step()
    double resolvable_step = 0.0;  ///< smallest resolvable gap there: resolvable_depth_step()
    int stencil = 0;
    glm::dvec3 world{0.0};
};

/// Returns the state to plan and draw when pixels are inspected. It shows the scene's own colors instead of counts,
/// differences or the heat map, which do not identify the surface at a pixel.
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

/// A block of pixels, top row first.
struct CellBlock {
    glm::ivec2 first_pixel{0};  ///< top left
    glm::ivec2 size{0};         ///< columns and rows
    std::vector<BufferCell> cells;

    const BufferCell& at(glm::ivec2 cell) const { return cells[cell.y * size.x + cell.x]; }
};

/// Histogram of the eye distances in a depth buffer: bins of equal width between near and far, on the view's scale.
struct DepthCounts {
    std::vector<std::uint32_t> counts;
    double min = 0.0, max = 1.0;  ///< eye distances or, on the window-depth scale, window depths
    std::uint64_t unwritten = 0;  ///< pixels that still hold the cleared value
};

}  // namespace viewing
