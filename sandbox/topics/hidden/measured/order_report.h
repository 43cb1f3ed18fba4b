// Reports which surfaces of a state hide which others, as JSON. Read topics/hidden/methods/hiding.h for the method.
#pragma once

#include "state/file/document.h"
#include "state/params.h"
#include "state/scene.h"

namespace viewing {

/// Reports, for polygons and for objects, which must be painted before which others, and whether all of them can be
/// painted whole in some order or some form a cycle. Also reports how many pairs each of the painter's keys orders
/// wrongly. Draws nothing. The error says that there are too many polygons to compare.
Result<Json> order_as_json(const Params& params, const Scene& scene, glm::ivec2 size_px);

/// Returns the nodes of the BSP tree in the order in which the camera draws them, farthest first: {"count": n, "order":
/// [3, 1, 2]}. Nodes are numbered from 1 in the order in which they are built, as in the picture of the tree. The error
/// says that the scene is too large.
Result<Json> bsp_order_as_json(const Params& params, const Scene& scene, glm::ivec2 size_px);

/// Returns the pair that Newell's sequence of tests compares at visibility.step (−1: the last step): "test", the test
/// that decided, such as "x_extents"; "action"; and the extents of "a" and "b": left, right, bottom, top on the screen
/// in −1 … 1, and nearest and farthest eye distance. "b" is null if nothing is left to compare with. The error says
/// that the scene is too large, or that there is no such step.
Result<Json> newell_step_as_json(const Params& params, const Scene& scene, glm::ivec2 size_px);

}  // namespace viewing
