// What the hidden-surface methods do with a state's scene, as JSON. Read frame/hidden/hidden_surfaces.h for one
// method.
#pragma once

#include "render/renderer.h"
#include "state/file/document.h"
#include "state/scene.h"

namespace viewing {

/// Every method on the scene from the state's camera, all steps of it: counters, times, and how many pixels differ from
/// ray casting with triangles, as difference() counts them. A number that a method does not have is null. The
/// error is GL's.
Result<Json> visibility_as_json(Renderer& renderer, const Params& params, const Scene& scene, glm::ivec2 size_px);

}  // namespace viewing
