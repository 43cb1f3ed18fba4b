#include "topics/hidden/numbers/scene_surface.h"

#include <algorithm>
#include <array>
#include <optional>

#include "geometry/normals.h"

namespace viewing {
namespace {

std::optional<CurvedKind> curved_kind(ShapeKind shape) {
    switch (shape) {
        case ShapeKind::sphere:
            return CurvedKind::sphere;
        case ShapeKind::cylinder:
            return CurvedKind::cylinder;
        case ShapeKind::cone:
            return CurvedKind::cone;
        case ShapeKind::torus:
            return CurvedKind::torus;
        default:
            return std::nullopt;
    }
}

/// Returns the weights of the corners a, b, c for the point nearest to `point` in their plane.
glm::dvec3 barycentric(const std::array<glm::dvec3, 3>& corners, const glm::dvec3& point) {
    const glm::dvec3 ab = corners[1] - corners[0], ac = corners[2] - corners[0], ap = point - corners[0];
    const glm::dvec3 normal = glm::cross(ab, ac);
    const double twice_area_squared = glm::dot(normal, normal);
    if (!(twice_area_squared > 0.0)) return {1.0, 0.0, 0.0};
    const double b = glm::dot(glm::cross(ap, ac), normal) / twice_area_squared;
    const double c = glm::dot(glm::cross(ab, ap), normal) / twice_area_squared;
    return {1.0 - b - c, b, c};
}

}  // namespace

SceneSurface surface_of(const Scene& scene, const WorkProgress* progress) {
    SceneSurface made;
    made.scene = scene;
    std::vector<MeshInstance> instances;
    for (const SceneObject& object : scene.objects) {
        instances.push_back({object.mesh.get(), object.world_from_model});
        made.first_source.push_back(made.first_curved_source);
        made.world_from_normal.push_back(normal_matrix(glm::dmat3(object.world_from_model)));
        made.first_curved_source += static_cast<int>(object.mesh->triangle_count());
    }
    PolygonSet set = polygons_of(instances, progress);
    made.polygons = std::move(set.polygons);
    made.dropped = set.dropped;
    for (std::size_t index = 0; index < scene.objects.size(); ++index)
        if (const auto kind = curved_kind(scene.objects[index].description.shape))
            made.curved.push_back({*kind, scene.objects[index].world_from_model, static_cast<int>(index),
                                   made.first_curved_source + static_cast<int>(made.curved.size())});
    if (!scene.bounds_world.empty()) made.diagonal = glm::length(scene.bounds_world.size());
    if (!(made.diagonal > 0.0)) made.diagonal = 1.0;
    return made;
}

int SceneSurface::object_of(int source) const {
    if (source < 0) return -1;
    if (const CurvedShape* shape = curved_of(source)) return shape->object;
    const auto after = std::upper_bound(first_source.begin(), first_source.end(), source);
    return static_cast<int>(after - first_source.begin()) - 1;
}

const CurvedShape* SceneSurface::curved_of(int source) const {
    const int index = source - first_curved_source;
    return index >= 0 && index < std::ssize(curved) ? &curved[index] : nullptr;
}

std::vector<int> SceneSurface::object_of_source() const {
    std::vector<int> objects(static_cast<std::size_t>(source_count()));
    for (std::size_t source = 0; source < objects.size(); ++source)
        objects[source] = object_of(static_cast<int>(source));
    return objects;
}

glm::dvec3 normal_at(const SceneSurface& surface, int source, const glm::dvec3& point_world) {
    if (const CurvedShape* shape = surface.curved_of(source)) {
        const glm::dvec3 point_model(glm::inverse(shape->world_from_model) * glm::dvec4(point_world, 1.0));
        return surface.world_from_normal[shape->object] * normal_of_curved(shape->kind, point_model);
    }
    const auto object = static_cast<std::size_t>(surface.object_of(source));
    const SceneObject& placed = surface.scene.objects[object];
    const Mesh& mesh = *placed.mesh;
    const auto first = 3 * static_cast<std::size_t>(source - surface.first_source[object]);
    std::array<glm::dvec3, 3> corners;
    for (std::size_t corner = 0; corner < 3; ++corner)
        corners[corner] = placed.world_from_model * glm::dvec4(mesh.positions[mesh.indices[first + corner]], 1.0);
    const glm::dvec3 weights = barycentric(corners, point_world);
    glm::dvec3 normal(0.0);
    for (std::size_t corner = 0; corner < 3; ++corner)
        normal += weights[static_cast<int>(corner)] * glm::dvec3(mesh.normals[mesh.indices[first + corner]]);
    return surface.world_from_normal[object] * normal;
}

}  // namespace viewing
