// The mirror image of a state made in four ways, as JSON: a part of measure. Read measure/mirror_measure.h for the
// counting.
#pragma once

#include "cli/headless.h"
#include "state/document.h"
#include "state/presets.h"
#include "state/scene.h"

namespace viewing {

/// No clipping, clip distance, oblique near plane and mirrored camera, compared by their pictures and depths. Throws
/// Failure where GL does not draw.
Json mirror_as_json(Headless& headless, const LoadedState& state, const Scene& scene, glm::ivec2 size_px);

}  // namespace viewing
