// Answers hidden-surface questions with the help of GL: if one of GL's own methods is being compared, GL draws the
// picture, and the polygon ids are read back from it. See hidden_worker.h for how the window gets its answers.
#pragma once

#include "render/renderer.h"
#include "topics/hidden/numbers/hidden_views.h"

namespace viewing {

/// Adds the difference between the two methods' pictures, if the question compares two and the answer lacks it.
Status complete_difference(Renderer& renderer, const Params& params, const Derived& derived, const Scene& scene,
                           HiddenAnswer& answer);

/// Returns the ids of the polygons in the result's picture. GL draws them (with the state's depth buffer if the method
/// is the depth buffer), unless the method itself finds a polygon for each pixel.
Result<IdImage> polygon_ids_drawn(Renderer& renderer, const Params& params, const Derived& derived, const Scene& scene,
                                  const HiddenResult& result);

/// Returns the frame for the camera's view with the complete result of its method; takes as long as the method does.
Result<FramePlan> plan_at_once(Renderer& renderer, const Params& params, const Derived& derived, const Scene& scene,
                               glm::ivec2 size_px);

}  // namespace viewing
