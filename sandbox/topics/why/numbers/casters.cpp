#include "topics/why/numbers/casters.h"

#include <array>
#include <cmath>

#include "geometry/ray.h"

namespace viewing {

std::optional<Blocker> blocker(const FragmentFinder& finder, const glm::dvec3& point_world,
                               const glm::dvec4& light_world) {
    const Scene& scene = finder.scene();
    const glm::dvec3 way = glm::dvec3(light_world) - light_world.w * point_world;
    const double length = glm::length(way);
    if (length == 0.0 || scene.bounds_world.empty()) return std::nullopt;
    const double nearest = 1e-4 * glm::length(scene.bounds_world.size()) / length;
    double limit = light_world.w != 0.0 ? 1.0 / light_world.w : std::numeric_limits<double>::infinity();
    std::optional<Blocker> found;
    for (std::size_t index = 0; index < scene.objects.size(); ++index) {
        const SceneObject& object = scene.objects[index];
        if (glm::determinant(object.world_from_model) == 0.0) continue;
        const glm::dmat4 model_from_world = glm::inverse(object.world_from_model);
        const Ray ray{glm::dvec3(model_from_world * glm::dvec4(point_world, 1.0)), glm::dmat3(model_from_world) * way};
        const Mesh& mesh = *object.mesh;
        finder.triangles_of(index).each([&](const Bounds& box) { return meets_box(ray, box, limit); },
                                        [&](std::uint32_t triangle) {
                                            std::array<glm::dvec3, 3> corners;
                                            for (std::size_t k = 0; k < 3; ++k)
                                                corners[k] =
                                                    mesh.positions[mesh.indices[3 * std::size_t{triangle} + k]];
                                            const std::optional<TriangleHit> hit = intersect_triangle(ray, corners);
                                            if (!hit || hit->t <= nearest || hit->t >= limit) return;
                                            limit = hit->t;
                                            found = Blocker{static_cast<int>(index), point_world + hit->t * way};
                                        });
    }
    return found;
}

CasterPlace place_of(const DerivedPlane& plane, const CastShadow& cast, const glm::dvec3& caster_world) {
    const double light_side = cast.plane_dot_light < 0.0 ? -1.0 : 1.0;
    const double height = light_side * glm::dot(plane.unit_plane, glm::dvec4(caster_world, 1.0));
    if (height < 0.0) return CasterPlace::behind_plane;
    const bool is_point = cast.light_world.w > 0.0;
    return is_point && height * cast.light_world.w >= std::abs(cast.plane_dot_light) ? CasterPlace::beyond_light
                                                                                     : CasterPlace::between;
}

ShadowAtPixel shadow_at(const FramePlan& plan, const PixelChain& chain, std::size_t plane, std::size_t light,
                        const std::vector<std::size_t>& mirrors_met) {
    ShadowAtPixel made;
    for (const Touch& touch : chain.touches) {
        const Pass& pass = plan.passes[touch.fragment.pass];
        if (role_of(pass) != PassRole::shadow || pass.plane != plane || pass.light != light ||
            pass.mirrors_met != mirrors_met)
            continue;
        if (touch.fragment.passes) {
            if (!made.first) made.first = &touch;
            made.last = &touch;
            ++made.passing;
        } else if (!touch.fragment.stencil_fails && !touch.fragment.cut_off && !made.rejected) {
            made.rejected = &touch;
        }
    }
    return made;
}

}  // namespace viewing
