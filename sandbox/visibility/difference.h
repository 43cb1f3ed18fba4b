// Where two methods disagree. Read ray_cast.h for the reference.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "visibility/id_image.h"

namespace viewing {

struct IdDifference {
    std::int64_t compared = 0;            ///< pixels
    std::int64_t different = 0;           ///< that show what the reference shows nowhere within a pixel
    std::int64_t different_at_edges = 0;  ///< the other ones that differ: two correct methods may, by how they round
    std::vector<std::uint8_t> differs;    ///< 1 where `different` counted; row by row from the top
};

/// Compares ids. Both images have the same size.
IdDifference difference(const IdImage& reference, const IdImage& image);

/// The two polygons of which the one that is hidden was drawn over the other one in most of the pixels that differ.
struct WrongPair {
    int seen = -1, drawn = -1;    ///< sources: what the reference shows, and what was drawn there
    std::int64_t pixels = 0;      ///< of this pair
    std::int64_t all_pixels = 0;  ///< of all pairs
    std::int64_t compared = 0;    ///< of the picture
    double x = 0.0, y = 0.0;      ///< the middle of the pair's pixels, as shares of the picture from the top left
};

/// None where no polygon was drawn over one that is seen.
std::optional<WrongPair> worst_pair(const IdImage& reference, const IdImage& image);

/// The same picture with `new_id[id]` in place of every id, such as objects for polygons.
IdImage with_ids(IdImage image, std::span<const int> new_id);

}  // namespace viewing
