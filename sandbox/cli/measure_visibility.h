// What the hidden-surface methods do with a state's scene, as JSON: a part of measure. Read measure_command.cpp for the
// other quantities, frame/hidden/hidden_surfaces.h for one method.
#pragma once

#include "cli/headless.h"
#include "state/document.h"
#include "state/presets.h"
#include "state/scene.h"

namespace viewing {

/// Every method on the scene from the state's camera, all steps of it: counters, times, and how many pixels differ from
/// ray casting with triangles, as difference() counts them. A number that a method does not have is null. Throws
/// Failure where GL does not draw.
Json visibility_as_json(Headless& headless, const LoadedState& state, const Scene& scene, glm::ivec2 size_px);

/// The name of a state's scene, "inline" for one that is written out in it.
std::string scene_name(const Params& params);

}  // namespace viewing
