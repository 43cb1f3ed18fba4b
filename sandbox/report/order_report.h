// Who hides whom in a state, as JSON. Read visibility/hiding.h for how it is found.
#pragma once

#include "state/document.h"
#include "state/params.h"
#include "state/scene.h"

namespace viewing {

/// Which polygons, and which objects, must be painted before which, whether there is an order of whole ones or a cycle,
/// and how many pairs each of the painter's keys has the wrong way round. Nothing is drawn. The error: there are more
/// polygons than can be compared with one another.
Result<Json> order_as_json(const Params& params, const Scene& scene, glm::ivec2 size_px);

}  // namespace viewing
