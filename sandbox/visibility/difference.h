// Where two methods disagree. Read ray_cast.h for the reference.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "visibility/id_image.h"

namespace viewing {

/// 1 for every pixel one of whose eight neighbours has another id, 0 elsewhere; row by row from the top. There two
/// correct methods may differ, by how they round.
std::vector<std::uint8_t> edge_pixels(const IdImage& image);

struct IdDifference {
    std::int64_t compared = 0;   ///< pixels that are no edges of the reference
    std::int64_t different = 0;  ///< of those
    std::int64_t different_at_edges = 0;
    std::vector<std::uint8_t> differs;  ///< 1 where `different` counted; row by row from the top
};

/// Compares ids away from the edges of `reference`. Both images have the same size.
IdDifference difference(const IdImage& reference, const IdImage& image);

/// The same picture with `new_id[id]` in place of every id, such as objects for polygons.
IdImage with_ids(IdImage image, std::span<const int> new_id);

}  // namespace viewing
