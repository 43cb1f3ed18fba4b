// The light's view: each caster hides its shadow, and no slider value breaks the view.
#include <cmath>

#include "unit/frame/frame_test.h"
#include "unit/geometry/random.h"

namespace viewing {
namespace {

ObserverView light_view(const glm::dvec4& light, const glm::dvec4& plane, glm::ivec2 size_px = {400, 300}) {
    Params params;
    params.lights.front().position = light;
    params.planes.front().equation = plane;
    return derive_light_view(derive(params, testing::box_scene(), {}), testing::box_scene(), {size_px});
}

bool is_finite_view(const ObserverView& view) {
    for (const glm::dmat4& matrix : {view.world_from_view, view.view_from_world, view.clip_from_world})
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 4; ++row)
                if (!std::isfinite(matrix[column][row])) return false;
    return std::isfinite(glm::length(view.eye_world));
}

TEST(LightView, HidesEveryShadowBehindItsCaster) {
    Random random(seed);
    int seen = 0;
    for (int i = 0; i < 400; ++i) {
        const glm::dvec4 plane(random.direction() * (i % 2 ? 1.0 : -2.0), random.number(-3, 3));
        glm::dvec4 light(random.vec3(9.0), i % 3 == 0 ? 0.0 : i % 3 == 1 ? 1.0 : random.number(0.2, 0.9));
        const ObserverView view = light_view(light, plane);
        ASSERT_TRUE(is_finite_view(view));
        const glm::dvec3 n = glm::dvec3(plane);
        // A caster between the light and a point of the plane.
        const glm::dvec3 across = glm::cross(n, random.vec3(2.0));
        const glm::dvec3 shadow = -plane.w / glm::dot(n, n) * n + across;
        const glm::dvec3 to_light = light.w == 0.0 ? glm::dvec3(light) : glm::dvec3(light) / light.w - shadow;
        const glm::dvec3 caster = shadow + random.number(0.1, light.w == 0.0 ? 0.4 : 0.8) * to_light;
        const glm::dvec4 a = view.clip_from_world * glm::dvec4(caster, 1.0);
        const glm::dvec4 b = view.clip_from_world * glm::dvec4(shadow, 1.0);
        if (a.w <= 1e-3 || b.w <= 1e-3) continue;
        ++seen;
        EXPECT_LT(glm::length(glm::dvec2(a) / a.w - glm::dvec2(b) / b.w), 1e-8) << "case " << i;
        EXPECT_LT(a.z / a.w, b.z / b.w) << "the caster is nearer";
    }
    EXPECT_GT(seen, 300);
}

TEST(LightView, IsFramedOnTheCastersForAnyLight) {
    const Scene scene = testing::box_scene();
    Random random(seed);
    for (int i = 0; i < 300; ++i) {
        const double w = i % 3 == 0 ? 0.0 : i % 3 == 1 ? 1.0 : 1e-4;
        const glm::dvec3 center = scene.bounds_world.center();
        const double radius = 0.5 * glm::length(scene.bounds_world.size());
        const glm::dvec3 way = random.direction() * radius * random.number(1.2, 40.0);
        const glm::dvec4 light = w == 0.0 ? glm::dvec4(way, 0.0) : glm::dvec4((center + way) * w, w);
        const ObserverView view = light_view(light, {random.direction(), random.number(-3, 3)});
        double farthest = 0.0;
        for (const SceneObject& object : scene.objects)
            for (const glm::vec3& vertex : object.mesh->positions) {
                const glm::dvec4 clip = view.clip_from_world * (object.world_from_model * glm::dvec4(vertex, 1.0));
                ASSERT_GT(clip.w, 0.0) << "case " << i;
                ASSERT_LT(glm::length(glm::dvec2(clip.x, clip.y)) / clip.w, 1.5) << "case " << i;
                farthest = std::max({farthest, std::abs(clip.x / clip.w), std::abs(clip.y / clip.w)});
                ASSERT_LT(std::abs(clip.z), clip.w) << "case " << i;
            }
        EXPECT_LE(farthest, 1.0) << "case " << i << ": the casters are cut off";
        EXPECT_GT(farthest, 0.4) << "case " << i << ": the casters are too small";
    }
}

TEST(LightView, IsDefinedForAnySliderValue) {
    const glm::dvec4 ground(0, 1, 0, 0), tilted(0.3, 1, 0.15, 0.5);
    const glm::dvec4 lights[] = {{0, 5, 0, 1},    {0, -5, 0, 1},   {0, 1, 0, 0},   {0, -1, 0, 0},   {3, 0, 2, 1},
                                 {3, 0, 2, 0},    {0, 0, 0, 1},    {2, 5, 1, .5},  {2, 5, 1, 1e-3}, {2, 5, 1, 1e-7},
                                 {2, 5, 1, 1e-5}, {0, 1e-4, 0, 1}, {1e-3, 0, 0, 0}};
    for (const glm::dvec4& plane : {ground, tilted})
        for (const glm::dvec4& light : lights)
            for (const glm::ivec2 size_px : {glm::ivec2(400, 300), glm::ivec2(100, 700), glm::ivec2(900, 1)}) {
                const ObserverView view = light_view(light, plane, size_px);
                EXPECT_TRUE(is_finite_view(view)) << light.x << " " << light.y << " " << light.z << " " << light.w;
                const glm::dmat4 product = view.world_from_view * view.view_from_world;
                EXPECT_LT(worst_difference(product, glm::dmat4(1.0)), 1e-6);
            }
}

}  // namespace
}  // namespace viewing
