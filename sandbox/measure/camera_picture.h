// Draws the camera view alone, like `snapshot --view camera`.
#pragma once

#include <optional>

#include "image/image.h"
#include "render/renderer.h"
#include "state/scene.h"

namespace viewing {

/// Draws with the state's samples and colors (view.shows). `background` replaces the theme's color. The error comes
/// from GL, or says that the scene is too large for its hidden-surface method.
Result<Image> camera_picture(Renderer& renderer, const Params& params, const Scene& scene, glm::ivec2 size_px,
                             std::optional<Color> background = std::nullopt);

}  // namespace viewing
