// Reports how the hidden-surface methods perform on a state's scene, as JSON. Read
// topics/hidden/numbers/hidden_surfaces.h for a single method.
#pragma once

#include "render/renderer.h"
#include "state/file/document.h"
#include "state/scene.h"

namespace viewing {

/// Runs every method on the scene from the state's camera, up to the method's last step. Reports each method's counters
/// and times, and the number of pixels that differ from ray casting with triangles, as difference() counts them.
/// Numbers that do not apply to a method are null. Any error comes from GL.
Result<Json> visibility_as_json(Renderer& renderer, const Params& params, const Scene& scene, glm::ivec2 size_px);

}  // namespace viewing
