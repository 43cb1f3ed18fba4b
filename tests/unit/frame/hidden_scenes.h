// Scenes and requests for the hidden-surface tests: the random polygons of the visibility tests as objects of a scene,
// and states that look at them. See also hidden_surfaces_test.cpp.
#pragma once

#include "topics/hidden/numbers/hidden_surfaces.h"
#include "unit/frame/frame_test.h"
#include "unit/methods/scenes.h"

namespace viewing::testing {

inline constexpr glm::ivec2 hidden_px(48, 36);

/// Makes a mesh of flat triangles, in which every polygon becomes a fan.
inline Mesh mesh_of(std::span<const Polygon> polygons) {
    Mesh mesh;
    for (const Polygon& polygon : polygons) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (const glm::dvec3& vertex : polygon.vertices) {
            mesh.positions.emplace_back(vertex);
            mesh.normals.emplace_back(polygon.plane);
        }
        for (std::uint32_t corner = 2; corner < polygon.vertices.size(); ++corner)
            mesh.indices.insert(mesh.indices.end(), {first, first + corner - 1, first + corner});
    }
    return mesh;
}

/// Returns random interpenetrating polygons as two objects of different colors.
inline Scene random_scene(Random& random) {
    const std::vector<Polygon> polygons = random_polygons(random);
    const auto half = static_cast<std::ptrdiff_t>(polygons.size() / 2);
    std::vector<Polygon> first(polygons.begin(), polygons.begin() + half),
        rest(polygons.begin() + half, polygons.end());
    Scene scene = scene_of({object("first", mesh_of(first), {}), object("rest", mesh_of(rest), {})});
    scene.objects[1].description.color = {240, 120, 30};
    return scene;
}

/// Returns a state whose camera looks at a point near the origin from a random position, in one case out of five from
/// inside the scene.
inline Params random_view(Random& random) {
    Params params;
    const double distance = random.number(0, 1) < 0.2 ? random.number(0.2, 1.5) : random.number(4.0, 9.0);
    params.camera.position = distance * random.direction();
    const Angles angles = angles_looking_at(params.camera.position, random.vec3(0.5));
    params.camera.yaw = angles.yaw_deg;
    params.camera.pitch = angles.pitch_deg;
    if (random.number(0, 1) < 0.3) params.projection.type = ProjectionType::orthographic;
    params.projection.near = random.number(0.05, 1.0);
    params.view.samples = 0;
    return params;
}

inline HiddenRequest request_of(const Params& params, const Scene& scene, glm::ivec2 size_px) {
    return hidden_request(params, derive(params, scene, Viewport{size_px}), size_px);
}

inline HiddenRequest with_method(HiddenRequest request, VisibilityMethod method, int step = -1) {
    request.visibility.method = method;
    request.visibility.step = step;
    return request;
}

}  // namespace viewing::testing
