// Finds objects by position: on one side of a plane, or beyond the edge of a patch. Part of problems.h.
#pragma once

#include <string>

#include "frame/derive.h"
#include "state/scene.h"

namespace viewing {

/// Tolerance in world units: an object that rests on a plane does not count as behind it.
inline constexpr double standing = 1e-4;

/// Returns the names ("box, ball") of the objects that have a vertex p with form · (p, 1) ≤ limit. Fast if the scene's
/// bounds rule that out; large meshes use their BoxTree.
std::string objects_at_most(const Scene& scene, const glm::dvec4& form, double limit);

/// Returns the names of such objects that also have a vertex above `limit`.
std::string objects_across(const Scene& scene, const glm::dvec4& form, double limit);

/// Returns whether one of 64 sampled vertices of an object is in the picture, between near and far.
bool is_in_view(const SceneObject& object, const Params& params, const Derived& derived);

/// Return whether a vertex that `plane_from_world` maps to the patch's plane with w > 0 lands outside the patch, or
/// inside it. Only vertices on the positive side of `side` count.
bool lands_beyond(const Scene& scene, const glm::dmat4& plane_from_world, const glm::dvec4& side,
                  const PlanePatch& patch);
bool lands_inside(const Scene& scene, const glm::dmat4& plane_from_world, const glm::dvec4& side,
                  const PlanePatch& patch);

}  // namespace viewing
