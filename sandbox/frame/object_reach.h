// Which objects of a scene lie where: on which side of a plane, and beyond the edge of a patch. Part of problems.h.
#pragma once

#include <string>

#include "geometry/plane.h"
#include "state/scene.h"

namespace viewing {

/// What stands on a plane is not behind it: world units.
inline constexpr double standing = 1e-4;

/// Names ("box, ball") of the objects with a vertex p for which form · (p, 1) ≤ limit. Quick where the scene's bounds
/// tell that there is none, and with large meshes by their BoxTree.
std::string objects_at_most(const Scene& scene, const glm::dvec4& form, double limit);

/// Names of those among them that have another vertex for which it is above `limit`.
std::string objects_across(const Scene& scene, const glm::dvec4& form, double limit);

/// Whether a vertex that `plane_from_world` sends to the plane of the patch with w > 0 lands beyond its edge, or inside
/// it. Only vertices on the positive side of `side` count.
bool lands_beyond(const Scene& scene, const glm::dmat4& plane_from_world, const glm::dvec4& side,
                  const PlanePatch& patch);
bool lands_inside(const Scene& scene, const glm::dmat4& plane_from_world, const glm::dvec4& side,
                  const PlanePatch& patch);

}  // namespace viewing
