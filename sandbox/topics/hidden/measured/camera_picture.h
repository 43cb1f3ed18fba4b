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

/// Returns a pixel's color; (0, 0) is top left.
inline Color color_at(const Image& picture, glm::ivec2 pixel) {
    const std::uint8_t* at = picture.pixel(pixel.x, pixel.y);
    return {at[0], at[1], at[2]};
}

}  // namespace viewing
