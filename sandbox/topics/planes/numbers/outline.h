// The outline of an object as the light sees it: the vertices at which light rays graze the object and reach the edge
// of its shadow.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/plane.h"
#include "state/scene.h"

namespace viewing {

/// A vertex of the outline, and the position of its shadow.
struct OutlineVertex {
    glm::dvec3 vertex_world{0.0};
    glm::dvec3 shadow_world{0.0};
};

/// Returns the vertices whose shadows are the corners of the convex hull of the object's shadow on the plane, in order
/// around it. Leaves out vertices without a shadow: those behind the plane, beyond the light, or so near the parallel
/// plane through the light that their shadow is a thousand times as far from the light as they are. The result is empty
/// if no vertex is left, or if the light is in the plane; it has two corners if the shadow is a line. For a very large
/// mesh, uses an even sample of 20,000 vertices. Source of the hull: Andrew 1979, monotone chain.
std::vector<OutlineVertex> shadow_outline(const SceneObject& object, const glm::dvec4& unit_plane,
                                          const glm::dvec4& light_world);

/// Returns at most `at_most` of the vertices, evenly chosen.
std::vector<OutlineVertex> thinned(const std::vector<OutlineVertex>& outline, std::size_t at_most);

}  // namespace viewing
