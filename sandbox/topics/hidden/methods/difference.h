// Finds where two methods disagree. See ray_cast.h for the reference.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "image/id_image.h"
#include "topics/hidden/methods/polygons.h"

namespace viewing {

struct IdDifference {
    std::int64_t compared = 0;            ///< pixels
    std::int64_t different = 0;           ///< pixels whose ID the reference shows nowhere within one pixel
    std::int64_t different_at_edges = 0;  ///< all other differing pixels: rounding alone may cause them
    std::vector<std::uint8_t> differs;    ///< 1 for each pixel that `different` counts; row by row from the top
};

/// Compares the IDs of two images, which must have the same size.
IdDifference difference(const IdImage& reference, const IdImage& image);

/// Compares an image that GL has drawn. GL rounds the corners of `drawn` to 1/256 of a pixel, so it may show either of
/// two polygons at a pixel's center that is less than 1/64 of a pixel from an edge of one of them.
IdDifference difference(const IdImage& reference, const IdImage& image, std::span<const Polygon> drawn,
                        const glm::dmat4& clip_from_world);

/// The pair of polygons with the most wrong pixels: pixels where the hidden one was drawn over the visible one.
struct WrongPair {
    int seen = -1, drawn = -1;    ///< sources: the polygon visible in the reference, and the one drawn there instead
    std::int64_t pixels = 0;      ///< wrong pixels of this pair
    std::int64_t all_pixels = 0;  ///< wrong pixels of all pairs
    std::int64_t compared = 0;    ///< pixels of the picture that were compared
    double x = 0.0, y = 0.0;      ///< the center of the pair's pixels, as fractions of the picture from the top left
};

/// Returns the pair with the most wrong pixels; none if no polygon was drawn over a visible one.
std::optional<WrongPair> worst_pair(const IdImage& reference, const IdImage& image);

/// Returns the same image with every ID replaced by `new_id[id]`, for example to show objects instead of polygons.
IdImage with_ids(IdImage image, std::span<const int> new_id);

}  // namespace viewing
