// Which object each decal of a scene lies on, as marks in the stencil buffer. Read plan.cpp for their use.
#pragma once

#include <vector>

#include "state/scene.h"

namespace viewing {

bool has_decals(const Scene& scene);

/// Of each object the stencil value that belongs to it: one of its own for what has a decal on it, the same one for the
/// decal, 0 for anything else. A decal lies on the first object that is flat, no decal, and nearly coplanar with it
/// (frame/depth/fighting.h); one that lies on nothing has 0. Above 252 the values repeat.
std::vector<int> decal_marks(const Scene& scene);

}  // namespace viewing
