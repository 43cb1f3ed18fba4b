// What is at one pixel, read back from the buffers, and every surface that was sent there, as JSON. Read
// frame/pixel_report.h and frame/depth/fragments.h for the numbers.
#pragma once

#include <span>

#include "render/renderer.h"
#include "state/file/document.h"

namespace viewing {

/// One object for each pixel; they count from the top left one of a picture without multisampling, in which they lie.
/// The colour is that of the picture, as view.shows says; the rest is the surface's, whatever the colours show. The
/// error is GL's.
Result<Json> pixels_as_json(Renderer& renderer, const Params& params, const Scene& scene,
                            std::span<const glm::ivec2> pixels, glm::ivec2 size_px);

/// The object of one.
Result<Json> pixel_as_json(Renderer& renderer, const Params& params, const Scene& scene, glm::ivec2 pixel,
                           glm::ivec2 size_px);

}  // namespace viewing
