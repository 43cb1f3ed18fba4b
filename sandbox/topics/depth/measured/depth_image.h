// Reads the whole depth buffer of a state's camera view, as `inspect` reads one pixel.
#pragma once

#include "image/depth_file.h"
#include "render/renderer.h"
#include "state/params.h"
#include "state/scene.h"

namespace viewing {

/// Draws the camera view without multisampling and returns its window depths as stored, rows from the top; 1 (reversed
/// depth: 0) where the buffer holds only the cleared depth. Needs a current context.
Result<DepthImage> depth_image(Renderer& renderer, Params params, const Scene& scene, glm::ivec2 size_px);

}  // namespace viewing
