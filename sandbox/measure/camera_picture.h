// The camera view alone, as `snapshot --view camera` draws it.
#pragma once

#include "image/image.h"
#include "render/renderer.h"
#include "state/scene.h"

namespace viewing {

/// With the samples and the colours (view.shows) that the state says. The error is GL's.
Result<Image> camera_picture(Renderer& renderer, const Params& params, const Scene& scene, glm::ivec2 size_px);

}  // namespace viewing
