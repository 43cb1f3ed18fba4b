// What no pixel will ever show need not be drawn, nor its program compiled. Read renderer.cpp next.
#pragma once

#include <span>

#include "frame/plan.h"
#include "geometry/mesh.h"

namespace viewing {

/// Whether all of a box lies beyond one side of the picture, or behind one of the pass's clip planes: nothing in it can
/// be seen. Near and far planes are not asked, what touches an edge is in sight, and so is an empty box.
bool is_out_of_sight(const Bounds& box_model, const Pass& pass, const glm::dmat4& world_from_model);

/// Whether none of the pass's clip planes cuts anything off a mesh: what touches one is kept, as in the shader. Of a
/// mesh of more than 4,096 vertices only the box is asked, which may reach further than the mesh: then the answer is
/// no.
bool is_kept_whole(const Bounds& box_model, std::span<const glm::vec3> positions_model, const Pass& pass,
                   const glm::dmat4& world_from_model);

}  // namespace viewing
