// What is at one pixel, read back from the buffers, and every surface that was sent there, as JSON. Read
// frame/pixel_report.h and frame/depth/fragments.h for the numbers.
#pragma once

#include "render/renderer.h"
#include "state/document.h"

namespace viewing {

/// `pixel` counts from the top left one of a picture without multisampling, in which it lies. The error is GL's.
Result<Json> pixel_as_json(Renderer& renderer, const Params& params, const Scene& scene, glm::ivec2 pixel,
                           glm::ivec2 size_px);

}  // namespace viewing
