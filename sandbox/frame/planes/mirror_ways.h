// The same mirror image made in several ways, and how much their pictures and depths differ: measure/mirror_measure.h
// finds it.
#pragma once

#include <array>
#include <cstdint>

#include "state/params.h"

namespace viewing {

enum class MirrorWay { clip_distance, none, oblique, camera };

inline constexpr std::size_t mirror_way_count = 4;

/// What the parameters are for one way; `camera` mirrors the camera and clips by distance.
Params mirrored_in(Params params, MirrorWay way);

/// "clip distance", "no clipping", "oblique near plane", "mirrored camera": in English, tr() for a person.
const char* name_of(MirrorWay way);

/// One way beside the first one, which the others are compared with.
struct MirrorWayReport {
    std::int64_t different = 0;                  ///< pixels without a like in the first way's picture, nor next to it
    int worst = 0;                               ///< levels, of these pixels
    double first_depth = 0.0, last_depth = 0.0;  ///< window depths of the image, before the patch covers it
    std::int64_t distinct_depths = 0;            ///< how many different codes
    std::int64_t image_pixels = 0;
    std::int64_t compared = 0;
};

struct MirrorWays {
    glm::ivec2 size_px{0};
    std::array<MirrorWayReport, mirror_way_count> reports;
};

}  // namespace viewing
