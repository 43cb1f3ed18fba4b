// Several ways to draw the same mirror image, and the differences between their pictures and depths. See
// topics/planes/measured/mirror_measure.h for the measurement.
#pragma once

#include <array>
#include <cstdint>

#include "state/params.h"

namespace viewing {

enum class MirrorWay { clip_distance, none, oblique, camera };

inline constexpr std::size_t mirror_way_count = 4;

/// Returns the parameters for one way; `camera` mirrors the camera and uses clip distances.
Params mirrored_in(Params params, MirrorWay way);

/// Returns "clip distance", "no clipping", "oblique near plane", "mirrored camera": in English; use tr() to show it.
const char* name_of(MirrorWay way);

/// The comparison of one way with the first one.
struct MirrorWayReport {
    std::int64_t different = 0;                  ///< pixels with no match within 1 px in the first way's picture
    int worst = 0;                               ///< largest difference among these pixels, in color levels
    double first_depth = 0.0, last_depth = 0.0;  ///< least and greatest window depth, before the patch covers the image
    std::int64_t distinct_depths = 0;            ///< number of different codes
    std::int64_t image_pixels = 0;
    std::int64_t compared = 0;
};

struct MirrorWays {
    glm::ivec2 size_px{0};
    std::array<MirrorWayReport, mirror_way_count> reports;
};

}  // namespace viewing
