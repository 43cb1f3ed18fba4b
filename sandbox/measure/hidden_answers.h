// Answers to hidden-surface questions with GL's help: where one of GL's own methods is compared, GL draws it and its
// polygon numbers are read back. Read hidden_worker.h for the window's way to the answers.
#pragma once

#include "frame/hidden/hidden_views.h"
#include "render/renderer.h"

namespace viewing {

/// Fills the difference in where the answer lacks it; nothing to do otherwise.
Status complete_difference(Renderer& renderer, const Params& params, const Derived& derived, const Scene& scene,
                           HiddenAnswer& answer);

/// The polygons that a result shows, as they are drawn: by GL, with the state's depth buffer where that is the method,
/// or pixel by pixel as the method found them.
Result<IdImage> polygon_ids_drawn(Renderer& renderer, const Params& params, const Derived& derived, const Scene& scene,
                                  const HiddenResult& result);

/// The camera view's frame with everything that its method finds; takes as long as the method does.
Result<FramePlan> plan_at_once(Renderer& renderer, const Params& params, const Derived& derived, const Scene& scene,
                               glm::ivec2 size_px);

}  // namespace viewing
