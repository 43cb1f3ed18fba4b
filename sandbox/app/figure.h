// A picture of a state as vectors: what the user interface draws stays shapes and text.
#pragma once

#include "app/picture.h"
#include "figure/drawing.h"

namespace viewing {

/// The same as draw_picture(), of any view. Needs a current context. What GL draws is a picture in it.
Result<Drawing> draw_figure(Renderer& renderer, const LoadedState& state, const Scene& scene,
                            const PictureRequest& request);

}  // namespace viewing
