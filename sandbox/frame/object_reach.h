// Finds objects by position: on one side of a plane, or beyond the edge of a patch. Part of problems.h.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "frame/derive.h"
#include "state/scene.h"
#include "text/message.h"

namespace viewing {

/// The fraction of the picture's height that a few pixels take up.
inline constexpr double visible_share = 1.0 / 200.0;

/// Returns the height of the picture at an eye distance, in world units.
double picture_height(const Lens& lens, double distance);

/// Tolerance in world units: an object that rests on a plane does not count as behind it.
inline constexpr double standing = 1e-4;

/// Returns the names ("box, ball") of the objects that have a vertex p with form · (p, 1) ≤ limit. This is fast if the
/// scene's bounds rule out such a vertex; otherwise, it searches the BoxTree of each mesh.
Message objects_at_most(const Scene& scene, const glm::dvec4& form, double limit);

/// Returns the names of the objects that have vertices on both sides: one with form · (p, 1) ≤ limit, and one with
/// form · (p, 1) > limit.
Message objects_across(const Scene& scene, const glm::dvec4& form, double limit);

/// Returns whether any of at most 127 sampled vertices of an object is in the picture, between near and far.
bool is_in_view(const SceneObject& object, const Params& params, const Derived& derived);

/// Returns whether part of a patch is in the picture, between near and far, judged by a grid of points.
bool is_in_view(const PlanePatch& patch, const glm::dmat4& clip_from_world);

/// A map that sends the scene's vertices to the plane of a patch, and the conditions under which a vertex counts.
struct Landing {
    const glm::dmat4& plane_from_world;  ///< only vertices that it sends to w > 0 count
    const glm::dmat4& clip_from_world;   ///< the picture's matrix: only images inside the picture count
    glm::dvec4 side;                     ///< only vertices on the positive side of this plane count
    const PlanePatch& patch;
    /// Points of the plane that something covers count as outside the picture; null: no point is covered.
    std::function<bool(const glm::dvec3&)> is_covered = nullptr;
    /// The map makes a mirror image, which lies beyond the plane: where near cuts the patch off, the image counts as
    /// outside the patch.
    bool is_image = false;

    /// Returns whether a homogeneous point of the plane, with w > 0, is covered.
    bool hides(const glm::dvec4& sent) const { return is_covered && is_covered(glm::dvec3(sent) / sent.w); }
};

/// Return whether part of an object's image lies inside the picture and outside the patch (lands_beyond), or inside
/// both (lands_inside). Both functions examine vertices; lands_beyond() also finds triangles that cross the patch's
/// edge.
bool lands_beyond(const Scene& scene, const Landing& landing);
bool lands_inside(const Scene& scene, const Landing& landing);

/// Returns S with the eye as its light. It projects points onto a plane as the eye sees them; w is positive for points
/// on the same side of the eye as the plane.
glm::dmat4 seen_on_plane(const glm::dvec4& unit_plane, const glm::dvec4& eye_world);

/// Returns four linear forms: the distances of a point's image from the patch's edges, times the image's w. If w > 0,
/// the image is in the patch if and only if all four are nonnegative.
std::array<glm::dvec4, 4> forms_of_edges(const glm::dmat4& plane_from_world, const PlanePatch& patch);

/// Returns four linear forms, positive on the inner side of the picture's left, right, lower and upper edge,
/// respectively.
std::array<glm::dvec4, 4> forms_of_sides(const glm::dmat4& clip_from_world);

/// Returns forms_of_sides() and two more forms, which are both positive between near and far.
std::vector<glm::dvec4> forms_of_frustum(const glm::dmat4& clip_from_world);

/// Returns whether part of a triangle of an object is where all forms, at most 32, are positive. For a mesh of more
/// than 20,000 triangles, returns false only if one of the forms is positive at none of its vertices.
bool may_reach(const SceneObject& object, std::span<const glm::dvec4> forms);

/// Returns whether any object may reach a point where all forms are positive. Visits no mesh if the scene's bounds rule
/// this out.
bool may_reach(const Scene& scene, std::span<const glm::dvec4> forms);

/// Returns whether any object has, for each of the forms, a vertex where that form is positive; the vertices may
/// differ.
bool may_reach_each(const Scene& scene, std::span<const glm::dvec4> forms);

/// Returns whether all forms are positive on part of a patch.
bool may_reach(const PlanePatch& patch, std::span<const glm::dvec4> forms);

/// Returns whether a triangle with this winding on the screen is a front face.
inline bool is_front(const CullParams& cull, bool is_counter_clockwise) {
    return is_counter_clockwise == (cull.front_face == FrontFace::ccw);
}

/// Returns whether culling removes front or back faces.
inline bool is_culled(const CullParams& cull, bool front_facing) {
    if (!cull.enabled) return false;
    return cull.face == CullFace::front_and_back || (cull.face == CullFace::front) == front_facing;
}

/// Returns whether culling leaves no triangle of the objects.
inline bool culls_all(const Params& params) {
    return params.cull.enabled && params.cull.face == CullFace::front_and_back;
}

/// Returns whether the eye may see more than half a pixel of a shadow or an image: `place_from_world` sends the parts
/// of the surfaces where all forms are positive to places in the picture (w > 0) that no object covers. Objects that
/// are drawn before the planes, or culled, cover nothing.
bool may_see(const Params& params, const Derived& derived, const Scene& scene, std::span<const glm::dvec4> forms,
             const glm::dmat4& place_from_world);

/// Returns whether a mesh from a file is thinner than a pixel: its area in the picture, divided by its length there, is
/// less than 1/2000 of the picture's height. False for large meshes, and if part of the mesh is behind the eye.
bool is_too_thin(const SceneObject& object, const Derived& derived);

/// Returns whether every vertex of an object is at most `tolerance` (world units) away from a unit plane.
bool lies_in(const SceneObject& object, const glm::dvec4& unit_plane, double tolerance);

/// Returns whether an object has a face in a plane, and the eye sees this side of the face: its outside, or its inside
/// through a culled outside. Large meshes are not searched.
bool has_seen_face_in(const SceneObject& object, const glm::dvec4& unit_plane, double tolerance, const Params& params,
                      const Derived& derived);

}  // namespace viewing
