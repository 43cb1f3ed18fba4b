// The z-buffer algorithm in software. With rules other than the depth test, the same scan converter paints the orders
// that the other methods find. Read ray_cast.h next. Source: Catmull 1974; lecture, Z-buffer Algorithm.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

#include "image/id_image.h"
#include "platform/progress.h"
#include "topics/hidden/methods/polygons.h"

namespace viewing {

/// The fragment that a pixel keeps: the last (for an order from back to front), the first (from front to back, with the
/// picture itself as the coverage mask), or the nearest (the z-buffer).
enum class PaintRule { overwrite, keep_first, depth_test };

struct RasterOptions {
    PaintRule rule = PaintRule::depth_test;
    int width = 0, height = 0;
    std::int64_t stop_after = -1;  ///< replay: stop after this many fragments; −1: all
    int subpixel_bits = -1;  ///< round screen positions to 2^−bits of a pixel, like GL (0 … 16); −1: no rounding
    bool count_per_pixel = false;         ///< fill RasterResult::written_per_pixel
    std::optional<glm::ivec2> watched{};  ///< fill RasterResult::touches for this pixel
};

/// One fragment: the point of a polygon at a pixel's center, compared with the pixel's contents.
struct RasterStep {
    int x = -1, y = -1;
    int polygon = -1;  ///< index into the given polygons
    double depth = 0.0;
    double stored_depth = 0.0;  ///< before the test; infinite on the background
    bool written = false;
};

/// A fragment of the watched pixel.
struct RasterTouch {
    std::int64_t number = 0;  ///< among all tested fragments, counted from 1
    int place = 0;            ///< position of its polygon in the order
    RasterStep fragment;
};

struct RasterCounters {
    std::int64_t polygons = 0;  ///< those with a part between near and far
    std::int64_t pixels_tested = 0, pixels_written = 0;
    std::int64_t pixels_covered = 0;  ///< pixels with an ID at the end

    /// Returns the fragments per covered pixel; 0 for an empty picture.
    double overdraw() const {
        return pixels_covered > 0 ? static_cast<double>(pixels_tested) / static_cast<double>(pixels_covered) : 0.0;
    }
};

struct RasterResult {
    IdImage image;
    RasterCounters counters;
    RasterStep last;                               ///< the last fragment tested
    std::vector<std::uint32_t> written_per_pixel;  ///< for the overdraw view; empty unless requested
    std::vector<std::int64_t> tested_after;        ///< the value of pixels_tested after each polygon drawn so far
    std::vector<RasterTouch> touches;              ///< in the order in which they were tested
};

/// Draws `polygons` in `order`, which may contain any number of indices into them. A pixel belongs to a polygon that
/// contains its center, with the top-left rule on edges. Clips at the near and far planes; clip_from_world has the clip
/// range −1 … 1. Depths are in double precision; among fragments whose depths agree to 1e−12, the first one stays, so
/// coplanar polygons do not fight. If canceled, returns the picture so far.
RasterResult rasterize(std::span<const Polygon> polygons, std::span<const int> order, const glm::dmat4& clip_from_world,
                       const RasterOptions& options, WorkProgress* progress = nullptr);

/// Draws all polygons in their own order.
RasterResult rasterize(std::span<const Polygon> polygons, const glm::dmat4& clip_from_world,
                       const RasterOptions& options, WorkProgress* progress = nullptr);

}  // namespace viewing
