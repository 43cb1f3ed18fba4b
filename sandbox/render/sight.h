// Finds objects that no pixel will show. They need no draw call, and their programs need not be compiled. Read
// renderer.cpp next.
#pragma once

#include <span>

#include "frame/plan/plan.h"
#include "geometry/mesh.h"

namespace viewing {

/// Returns whether a box lies entirely outside one side of the picture or entirely behind one of the pass's clip
/// planes, so that nothing in it is visible. Ignores the near and far planes. A box that touches an edge counts as
/// visible, and so does an empty one.
bool is_out_of_sight(const Bounds& box_model, const Pass& pass, const glm::dmat4& world_from_model);

/// Returns whether none of the pass's clip planes cuts anything off a mesh; points on a plane are kept, as in the
/// shader. For a mesh of more than 4,096 vertices, tests only its box; since the box may be larger than the mesh, the
/// result can be false although nothing is cut off.
bool is_kept_whole(const Bounds& box_model, std::span<const glm::vec3> positions_model, const Pass& pass,
                   const glm::dmat4& world_from_model);

}  // namespace viewing
