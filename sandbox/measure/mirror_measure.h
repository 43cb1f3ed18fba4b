// Draws the mirror image with GL in four ways and compares them. Read frame/planes/mirror_ways.h for the counts.
#pragma once

#include "frame/planes/mirror_ways.h"
#include "render/buffer_read.h"

namespace viewing {

/// Draws the state in all ways with GL's depth buffer, completely, in color and without multisampling, and compares
/// them with the first one. `pictures` receives the differences, one for each way. Depths are those of the frame's
/// first mirror image; 0 if there is none. Any error comes from GL.
Result<MirrorWays> compare_mirror_ways(Renderer& renderer, const Params& state, const Scene& scene, glm::ivec2 size_px,
                                       std::array<View, mirror_way_count>* pictures = nullptr);

}  // namespace viewing
