// Draws a state as a vector figure, in which the user interface remains shapes and text.
#pragma once

#include "app/picture.h"
#include "figure/drawing.h"

namespace viewing {

/// Draws any view, like draw_picture(). Needs a current context. Content that GL draws becomes an embedded picture.
Result<Drawing> draw_figure(Renderer& renderer, const LoadedState& state, const Scene& scene,
                            const PictureRequest& request);

}  // namespace viewing
