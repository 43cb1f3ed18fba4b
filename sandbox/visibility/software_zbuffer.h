// The z-buffer algorithm in software, and with other rules than the depth test the same scan converter paints the
// orders that the other methods find. Read ray_cast.h next.
// Source: Catmull 1974; lecture, Z-buffer Algorithm.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

#include "platform/progress.h"
#include "visibility/id_image.h"
#include "visibility/polygons.h"

namespace viewing {

/// Which fragment a pixel keeps: the last (an order from back to front), the first (from front to back, with the
/// picture itself as the coverage mask), or the nearest (the z-buffer).
enum class PaintRule { overwrite, keep_first, depth_test };

struct RasterOptions {
    PaintRule rule = PaintRule::depth_test;
    int width = 0, height = 0;
    std::int64_t stop_after = -1;  ///< replay: stop after so many fragments; −1: all
    int subpixel_bits = -1;  ///< round screen positions to 2^−bits of a pixel, as GL does (0 … 16); −1: do not
    bool count_per_pixel = false;         ///< fill RasterResult::written_per_pixel
    std::optional<glm::ivec2> watched{};  ///< fill RasterResult::touches for this pixel
};

/// One fragment: a polygon's point in a pixel, held against what the pixel had.
struct RasterStep {
    int x = -1, y = -1;
    int polygon = -1;  ///< index into the polygons that were passed
    double depth = 0.0;
    double stored_depth = 0.0;  ///< before; infinite on the background
    bool written = false;
};

/// A fragment of the pixel that is watched.
struct RasterTouch {
    std::int64_t number = 0;  ///< among all fragments that are tested, from 1 on
    int place = 0;            ///< of its polygon in the order
    RasterStep fragment;
};

struct RasterCounters {
    std::int64_t polygons = 0;  ///< that had at least a part between near and far
    std::int64_t pixels_tested = 0, pixels_written = 0;
    std::int64_t pixels_covered = 0;  ///< that hold an id at the end

    /// Fragments for each covered pixel; 0 for an empty picture.
    double overdraw() const {
        return pixels_covered > 0 ? static_cast<double>(pixels_tested) / static_cast<double>(pixels_covered) : 0.0;
    }
};

struct RasterResult {
    IdImage image;
    RasterCounters counters;
    RasterStep last;                               ///< the last fragment that was tested
    std::vector<std::uint32_t> written_per_pixel;  ///< overdraw view; empty unless asked for
    std::vector<std::int64_t> tested_after;        ///< of each place in the order that was come to: pixels_tested then
    std::vector<RasterTouch> touches;              ///< in the order of their tests
};

/// Draws `polygons` in `order` (indices into them, any number of them). A pixel belongs to a polygon that its centre
/// lies in, by the top-left rule on edges. Clipped at the near and far planes; clip_from_world has clip range −1 … 1.
/// Depths are in double; of fragments whose depths agree to 1e−12 the first stays, so coplanar polygons do not fight.
/// Cancelled: what was drawn so far.
RasterResult rasterise(std::span<const Polygon> polygons, std::span<const int> order, const glm::dmat4& clip_from_world,
                       const RasterOptions& options, WorkProgress* progress = nullptr);

/// All of them, as they stand.
RasterResult rasterise(std::span<const Polygon> polygons, const glm::dmat4& clip_from_world,
                       const RasterOptions& options, WorkProgress* progress = nullptr);

}  // namespace viewing
