// The mirror image in four ways, drawn by GL and compared: read frame/planes/mirror_ways.h for what is counted.
#pragma once

#include "frame/planes/mirror_ways.h"
#include "render/buffer_read.h"

namespace viewing {

/// Draws all ways of the state with GL's depth buffer, whole, in colour and without samples, and compares them with the
/// first one. With `pictures` each becomes what shows its differences. Depths are those of the frame's first image; 0
/// where there is none. The error is GL's.
Result<MirrorWays> compare_mirror_ways(Renderer& renderer, const Params& state, const Scene& scene, glm::ivec2 size_px,
                                       std::array<View, mirror_way_count>* pictures = nullptr);

}  // namespace viewing
