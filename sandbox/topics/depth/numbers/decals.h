// Finds the object under each decal of a scene, and gives both the same mark for the stencil buffer. See plan_depth.cpp
// for the use of the marks.
#pragma once

#include <vector>

#include "state/scene.h"

namespace viewing {

bool has_decals(const Scene& scene);

/// Returns each object's stencil value: a separate value for each object under a decal, that object's value for the
/// decal, and 0 for anything else. A decal lies on the first flat object that is not a decal and is nearly coplanar
/// with it (topics/depth/numbers/fighting.h); a decal without such an object gets 0. After 252 objects under decals,
/// the values repeat.
std::vector<int> decal_marks(const Scene& scene);

}  // namespace viewing
