// "Why this pixel?" for the command line: draws the camera's picture, reads a pixel back, and explains it, as JSON or
// text (why_as_text). Read topics/why/numbers/why.h for the explanation.
#pragma once

#include <span>

#include "render/renderer.h"
#include "state/file/document.h"
#include "topics/why/numbers/why.h"

namespace viewing {

/// Explains pixels of the picture without multisampling, counted from the top left; they must be inside it. The error
/// comes from GL, or says that the scene is too large for its hidden-surface method.
Result<std::vector<Why>> explained_pixels(Renderer& renderer, const Params& params, const Scene& scene,
                                          std::span<const glm::ivec2> pixels, glm::ivec2 size_px);

/// "predicted" is the color computed from the chain, or null if this picture's colors are not computed; "read_back" is
/// the color in the buffer. "surface" and "casters" are the names of the scene's objects, not translated.
Json why_as_json(const Why& why);

}  // namespace viewing
