// A scene as the input of hidden-surface methods: polygons and exact curved shapes in world space, with the data needed
// to shade a point on them. It is made once per scene. Read hidden_surfaces.h next.
#pragma once

#include <memory>
#include <vector>

#include "state/scene.h"
#include "topics/hidden/methods/ray_cast.h"

namespace viewing {

struct SceneSurface {
    Scene scene;                                ///< shares the meshes
    std::vector<Polygon> polygons;              ///< triangles with nonzero area; `source` numbers all triangles, from 0
    int dropped = 0;                            ///< triangles without area
    std::vector<int> first_source;              ///< per object: the source of its first triangle
    std::vector<CurvedShape> curved;            ///< objects with an exact shape; their sources follow the triangles'
    double diagonal = 1.0;                      ///< of the bounds, world units; 1 for an empty scene
    std::vector<glm::dmat3> world_from_normal;  ///< per object: normal_matrix() of its placement

    int source_count() const { return first_curved_source + static_cast<int>(curved.size()); }
    int object_of(int source) const;  ///< −1 for the background
    const CurvedShape* curved_of(int source) const;
    std::vector<int> object_of_source() const;

    int first_curved_source = 0;
};

/// Makes a scene's surface. If canceled, it has only the first polygons.
SceneSurface surface_of(const Scene& scene, const WorkProgress* progress = nullptr);

/// Returns the normal at a point, not normalized: the normal that GL interpolates from the corners of the triangle
/// `source`, or that of the curved shape. Extrapolates outside the triangle; a triangle of zero area has the normal of
/// its first corner.
glm::dvec3 normal_at(const SceneSurface& surface, int source, const glm::dvec3& point_world);

}  // namespace viewing
