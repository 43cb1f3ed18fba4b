// Reports, as JSON, how four ways of making the mirror image of a state differ. See
// topics/planes/measured/mirror_measure.h for how pixels are counted.
#pragma once

#include "render/renderer.h"
#include "state/file/document.h"
#include "state/scene.h"

namespace viewing {

/// Compares the pictures and depths of four ways: no clipping, clip distance, oblique near plane and mirrored camera.
/// Any error comes from GL.
Result<Json> mirror_as_json(Renderer& renderer, const Params& params, const Scene& scene, glm::ivec2 size_px);

}  // namespace viewing
