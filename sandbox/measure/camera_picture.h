// The camera view alone, as `snapshot --view camera` draws it.
#pragma once

#include <optional>

#include "image/image.h"
#include "render/renderer.h"
#include "state/scene.h"

namespace viewing {

/// With the samples and the colours (view.shows) that the state says. `background` in the place of the theme's. The
/// error is GL's.
Result<Image> camera_picture(Renderer& renderer, const Params& params, const Scene& scene, glm::ivec2 size_px,
                             std::optional<Color> background = std::nullopt);

}  // namespace viewing
