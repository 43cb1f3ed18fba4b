// The outline of an object as the light sees it: the vertices through which rays graze past to the edge of its shadow.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/plane.h"
#include "state/scene.h"

namespace viewing {

/// A vertex of the outline and where its shadow falls.
struct OutlineVertex {
    glm::dvec3 vertex_world{0.0};
    glm::dvec3 shadow_world{0.0};
};

/// The vertices whose shadows are the corners of the convex hull of the object's shadow on the plane, in order around
/// it. Left out are those that throw none: behind the plane, beyond the light, or so near to the light's own plane that
/// their shadow lies a thousand times as far away. Empty without such vertices or with the light in the plane. Two
/// corners where the shadow is a line. Of a mesh with very many vertices an even sample of 20,000 is looked at.
/// Source of the hull: Andrew 1979, monotone chain.
std::vector<OutlineVertex> shadow_outline(const SceneObject& object, const glm::dvec4& unit_plane,
                                          const glm::dvec4& light_world);

/// At most so many of them, evenly chosen.
std::vector<OutlineVertex> thinned(const std::vector<OutlineVertex>& outline, std::size_t at_most);

}  // namespace viewing
