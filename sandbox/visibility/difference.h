// Where two methods disagree. Read ray_cast.h for the reference.
#pragma once

#include <cstdint>
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

/// The same picture with `new_id[id]` in place of every id, such as objects for polygons.
IdImage with_ids(IdImage image, std::span<const int> new_id);

}  // namespace viewing
