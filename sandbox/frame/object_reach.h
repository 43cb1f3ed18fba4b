// Finds objects by position: on one side of a plane, or beyond the edge of a patch. Part of problems.h.
#pragma once

#include <string>

#include "frame/derive.h"
#include "state/scene.h"

namespace viewing {

/// A share of the picture's height that is a few pixels.
inline constexpr double visible_share = 1.0 / 200.0;

/// Returns the height of the picture at an eye distance, in world units.
double picture_height(const Lens& lens, double distance);

/// Tolerance in world units: an object that rests on a plane does not count as behind it.
inline constexpr double standing = 1e-4;

/// Returns the names ("box, ball") of the objects that have a vertex p with form · (p, 1) ≤ limit. Fast if the scene's
/// bounds rule that out; large meshes use their BoxTree.
std::string objects_at_most(const Scene& scene, const glm::dvec4& form, double limit);

/// Returns the names of such objects that also have a vertex above `limit`.
std::string objects_across(const Scene& scene, const glm::dvec4& form, double limit);

/// Returns whether one of 64 sampled vertices of an object is in the picture, between near and far.
bool is_in_view(const SceneObject& object, const Params& params, const Derived& derived);

/// Returns whether a grid of points on a patch shows that part of it is in the picture.
bool is_in_view(const PlanePatch& patch, const glm::dmat4& clip_from_world);

/// A map of the scene's vertices to the plane of a patch.
struct Landing {
    const glm::dmat4& plane_from_world;  ///< only vertices with w > 0 afterward count
    const glm::dmat4& clip_from_world;   ///< of the picture: only images inside it count
    glm::dvec4 side;                     ///< only vertices on the positive side of this plane count
    const PlanePatch& patch;
};

/// Return whether part of an object's image is in the picture and outside the patch, or inside it. Looks at vertices.
bool lands_beyond(const Scene& scene, const Landing& landing);
bool lands_inside(const Scene& scene, const Landing& landing);

}  // namespace viewing
