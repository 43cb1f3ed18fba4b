// Scenes for the hidden-surface tests: random interpenetrating polygons, cycles, and cameras. Failures print the seed.
#pragma once

#include <array>
#include <cstdlib>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "geometry/camera.h"
#include "geometry/projection.h"
#include "geometry/shapes.h"
#include "topics/hidden/methods/difference.h"
#include "topics/hidden/methods/polygons.h"
#include "topics/hidden/methods/ray_cast.h"
#include "topics/hidden/methods/software_zbuffer.h"
#include "topics/hidden/methods/viewpoint.h"
#include "unit/geometry/random.h"

namespace viewing {

inline constexpr int test_width = 96, test_height = 72;

inline int whole_number(Random& random, int min, int max) {
    return min + static_cast<int>(random.number(0.0, 1.0) * (max - min + 0.999));
}

/// Adds a polygon that is known to have an area; its number is its index.
inline void add(std::vector<Polygon>& polygons, std::vector<glm::dvec3> corners) {
    const int source = static_cast<int>(polygons.size());
    polygons.push_back(make_polygon(std::move(corners), source, source).value());
}

inline Viewpoint viewpoint_at(const glm::dvec3& eye, const glm::dvec3& target, const Lens& lens = {}) {
    const double aspect = static_cast<double>(test_width) / test_height;
    return {view_from_world(world_from_view(eye, angles_looking_at(eye, target))), clip_from_view(lens, aspect)};
}

/// Returns a viewpoint that looks along −z, from z = 7 in perspective and from z = 10 in orthographic projection.
inline Viewpoint viewpoint_on_z(bool orthographic = false) {
    return viewpoint_at({0, 0, orthographic ? 10 : 7}, {0, 0, 0}, {.orthographic = orthographic});
}

inline Viewpoint random_viewpoint(Random& random) {
    Lens lens{.orthographic = random.number(0, 1) < 0.3, .near = random.number(0.05, 1.0)};
    // One camera in five is within the scene, so that the near plane cuts polygons.
    const double distance = random.number(0, 1) < 0.2 ? random.number(0.2, 1.5) : random.number(4.0, 9.0);
    return viewpoint_at(distance * random.direction(), random.vec3(0.5), lens);
}

/// Returns three bars about the z axis. Seen from +z, each bar is over the next one and under the previous one. The
/// bars rise along their length and lean to one side, so that each lies in front of the next one's plane: Newell's
/// tests find one cycle instead of three pairs that each seem to need a cut.
inline std::vector<Polygon> cyclic_bars() {
    std::vector<Polygon> bars;
    for (int i = 0; i < 3; ++i) {
        const double turn = i * glm::radians(120.0);
        const glm::dvec3 along(std::cos(turn), std::sin(turn), 0.0), across(-along.y, along.x, 0.0);
        const auto corner = [&](double l, double a) {
            return l * along + a * across + glm::dvec3(0.0, 0.0, 0.3125 * l - 0.5 * (a + 0.55));
        };
        add(bars, {corner(-1.6, -0.7), corner(1.6, -0.7), corner(1.6, -0.4), corner(-1.6, -0.4)});
    }
    return bars;
}

/// Returns triangles that interpenetrate, and in some scenes also boxes, cones, or bars in a cycle.
inline std::vector<Polygon> random_polygons(Random& random) {
    std::vector<Polygon> polygons;
    const int triangles = whole_number(random, 2, 24);
    for (int i = 0; i < triangles; ++i) {
        const glm::dvec3 at = random.vec3(1.2);
        add(polygons, {at + random.vec3(1.3), at + random.vec3(1.3), at + random.vec3(1.3)});
    }
    const int solids = whole_number(random, 0, 2);
    for (int i = 0; i < solids; ++i) {
        const Mesh mesh = random.number(0, 1) < 0.5 ? box_mesh() : cone_mesh(7);
        const MeshInstance instance{
            &mesh, world_from_model(random.vec3(1.2), random.angles(), random.vec3(0.25) + glm::dvec3(0.6))};
        for (Polygon& polygon : polygons_of(std::span(&instance, 1)).polygons) {
            add(polygons, std::move(polygon.vertices));
        }
    }
    if (random.number(0, 1) < 0.3) {
        const glm::dmat4 pose = world_from_model(random.vec3(0.5), random.angles(), glm::dvec3(1));
        for (const Polygon& bar : cyclic_bars()) {
            std::vector<glm::dvec3> corners;
            for (const glm::dvec3& v : bar.vertices) corners.emplace_back(pose * glm::dvec4(v, 1));
            add(polygons, std::move(corners));
        }
    }
    return polygons;
}

inline IdImage ray_cast_image(std::span<const Polygon> polygons, const Viewpoint& viewpoint) {
    return cast_rays(RayScene(polygons), viewpoint.clip_from_world(), {.width = test_width, .height = test_height})
        .image;
}

inline IdImage paint(std::span<const Polygon> polygons, std::span<const int> order, const Viewpoint& viewpoint,
                     PaintRule rule = PaintRule::overwrite) {
    return rasterize(polygons, order, viewpoint.clip_from_world(),
                     {.rule = rule, .width = test_width, .height = test_height})
        .image;
}

inline IdImage zbuffer_image(std::span<const Polygon> polygons, const Viewpoint& viewpoint) {
    return rasterize(polygons, viewpoint.clip_from_world(), {.width = test_width, .height = test_height}).image;
}

/// Returns 300 or the value of VIEWING_TEST_SCENES.
inline int random_scene_count() {
    const char* count = std::getenv("VIEWING_TEST_SCENES");
    return count != nullptr ? std::atoi(count) : 300;
}

}  // namespace viewing
