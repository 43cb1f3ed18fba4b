// Finds the object under each decal of a scene, and marks both in the stencil buffer. Read plan.cpp for the use of the
// marks.
#pragma once

#include <vector>

#include "state/scene.h"

namespace viewing {

bool has_decals(const Scene& scene);

/// Returns each object's stencil value: its own value if it has a decal on it, the value of the object below for a
/// decal, 0 for anything else. A decal lies on the first flat object that is not a decal and nearly coplanar with it
/// (frame/depth/fighting.h); a decal without such an object has 0. After 252 objects the values repeat.
std::vector<int> decal_marks(const Scene& scene);

}  // namespace viewing
