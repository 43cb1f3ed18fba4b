// Reports the values at one pixel, read back from the buffers, and every surface that was drawn there, as JSON. Read
// frame/pixel_report.h and topics/depth/numbers/fragments.h for the numbers.
#pragma once

#include <span>

#include "render/renderer.h"
#include "state/file/document.h"

namespace viewing {

/// Returns one object for each pixel. Pixels are counted from the top left of a picture without multisampling, and must
/// be inside it. The color is that of the picture for view.shows; all other values are those of the surface, regardless
/// of what the colors show. The error comes from GL, or says that the scene is too large for its hidden-surface method.
Result<Json> pixels_as_json(Renderer& renderer, const Params& params, const Scene& scene,
                            std::span<const glm::ivec2> pixels, glm::ivec2 size_px);

/// Returns the object for one pixel.
Result<Json> pixel_as_json(Renderer& renderer, const Params& params, const Scene& scene, glm::ivec2 pixel,
                           glm::ivec2 size_px);

}  // namespace viewing
