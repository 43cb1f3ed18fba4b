// Who hides whom in a state, as JSON. Read visibility/hiding.h for how it is found.
#pragma once

#include "state/file/document.h"
#include "state/params.h"
#include "state/scene.h"

namespace viewing {

/// Which polygons, and which objects, must be painted before which, whether there is an order of whole ones or a cycle,
/// and how many pairs each of the painter's keys has the wrong way round. Nothing is drawn. The error: there are more
/// polygons than can be compared with one another.
Result<Json> order_as_json(const Params& params, const Scene& scene, glm::ivec2 size_px);

/// The BSP tree's nodes as the camera draws them, the farthest first: {"count": n, "order": [3, 1, 2]}, numbered from 1
/// on in the order in which they are built, as the tree's picture shows them. The error: the scene is too large.
Result<Json> bsp_order_as_json(const Params& params, const Scene& scene, glm::ivec2 size_px);

/// The pair that Newell's ladder compares at visibility.step, the last step where that is −1: {"test": "x_extents"}
/// that decided, "action", and of "a" and "b" what each covers: left, right, bottom, top on the screen in −1 … 1,
/// nearest and farthest by eye distance; "b" is null where nothing is left to compare with. The errors: the scene is
/// too large, or there is no such step.
Result<Json> newell_step_as_json(const Params& params, const Scene& scene, glm::ivec2 size_px);

}  // namespace viewing
