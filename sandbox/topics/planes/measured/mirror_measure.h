// Draws the mirror image with GL in four ways and compares them. See topics/planes/numbers/mirror_ways.h for the
// counts.
#pragma once

#include "render/buffer_read.h"
#include "topics/planes/numbers/mirror_ways.h"

namespace viewing {

/// Draws the state's complete frame in each of the ways, with GL's depth buffer, in color and without multisampling,
/// and compares each picture with the first one. `pictures` receives the first picture and, for each other way, its
/// differences. Depths are those of the frame's first mirror image; 0 if there is none. Any error comes from GL.
Result<MirrorWays> compare_mirror_ways(Renderer& renderer, const Params& state, const Scene& scene, glm::ivec2 size_px,
                                       std::array<View, mirror_way_count>* pictures = nullptr);

}  // namespace viewing
