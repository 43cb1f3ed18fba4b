// Visibility culling by boxes: a box is out of sight only if no sampled point of it could be visible.
#include "render/sight.h"

#include <gtest/gtest.h>

#include "frame/derive.h"
#include "gl_test.h"
#include "unit/geometry/random.h"

namespace viewing {
namespace {

/// Returns whether GL keeps a point, that is, whether the point lies between both pairs of the frustum's sides and in
/// front of every clip plane.
bool is_kept(const glm::dvec3& point_model, const Pass& pass, const glm::dmat4& world_from_model) {
    const glm::dvec4 scene = world_from_model * glm::dvec4(point_model, 1.0);
    for (const ClipPlane& plane : pass.clip_planes)
        if (glm::dot(plane, scene) < 0.0) return false;
    const glm::dvec4 clip = pass.clip_from_world * pass.world_from_scene * scene;
    return std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w;
}

TEST(Sight, NothingVisibleIsCulled) {
    SCOPED_TRACE("seed 7");
    Random random(7);
    int left_out = 0, unseen = 0;
    for (int i = 0; i < 4000; ++i) {
        Pass pass;
        const glm::dvec3 eye = random.vec3(6.0);
        pass.clip_from_world = clip_from_view({.fovy_deg = 40.0, .near = 0.1, .far = 50.0}, 1.6) *
                               view_from_world(world_from_view(eye, angles_looking_at(eye, random.vec3(2.0))));
        const glm::dvec4 plane = unit_plane(glm::dvec4(random.direction(), random.vec3(1.0).x));
        if (i % 3 == 1) pass.world_from_scene = mirror_matrix(plane);
        if (i % 3 == 2) pass.world_from_scene = shadow_matrix(plane, glm::dvec4(random.vec3(8.0), 1.0));
        if (i % 2 == 1) pass.clip_planes.emplace_back(plane);
        const glm::dmat4 world_from_model =
            viewing::world_from_model(random.vec3(5.0), random.angles(), glm::dvec3(0.2) + glm::abs(random.vec3(1.0)));
        const Bounds box{glm::dvec3(-1.0), glm::dvec3(1.0)};
        bool is_seen = false;
        for (int k = 0; k < 300 && !is_seen; ++k) is_seen = is_kept(random.vec3(1.0), pass, world_from_model);
        const bool is_left_out = is_out_of_sight(box, pass, world_from_model);
        EXPECT_FALSE(is_seen && is_left_out) << "at " << i;
        left_out += is_left_out;
        unseen += !is_seen;
    }
    // Culling may keep invisible boxes, but not most of them.
    EXPECT_GT(unseen, 1000);
    EXPECT_GT(left_out, unseen * 6 / 10);
}

TEST(Sight, BoxesAtTheEdgeAndEmptyBoxesAreDrawn) {
    Pass pass;  // clip space equals world space
    EXPECT_FALSE(is_out_of_sight({{1.0, -1.0, 0.0}, {2.0, 1.0, 0.0}}, pass, glm::dmat4(1.0)));
    EXPECT_TRUE(is_out_of_sight({{1.01, -1.0, 0.0}, {2.0, 1.0, 0.0}}, pass, glm::dmat4(1.0)));
    EXPECT_FALSE(is_out_of_sight({}, pass, glm::dmat4(1.0)));
    pass.forces_sign = true;  // vertices may be negated
    EXPECT_FALSE(is_out_of_sight({{1.01, -1.0, 0.0}, {2.0, 1.0, 0.0}}, pass, glm::dmat4(1.0)));
}

/// A box extends beyond its mesh. If a mesh has few vertices, is_kept_whole() therefore also tests the vertices.
TEST(Sight, APlaneCutsAnObjectIfAVertexIsBehindIt) {
    SCOPED_TRACE("seed 8");
    Random random(8);
    int whole = 0, only_by_vertices = 0;
    for (int i = 0; i < 3000; ++i) {
        std::vector<glm::vec3> positions;
        Bounds box;
        for (int k = 0; k < 40; ++k) {
            positions.emplace_back(random.direction());  // on a ball, whose box has empty corners
            box.add(glm::dvec3(positions.back()));
        }
        Pass pass;
        for (int k = 0; k < 1 + i % 2; ++k)
            pass.clip_planes.emplace_back(unit_plane(glm::dvec4(random.direction(), random.number(0.0, 3.0))));
        const glm::dmat4 world_from_model =
            viewing::world_from_model(random.vec3(1.0), random.angles(), glm::dvec3(0.2) + glm::abs(random.vec3(1.0)));
        double least = 1e9;
        for (const ClipPlane& plane : pass.clip_planes)
            for (const glm::vec3& position : positions)
                least = std::min(least, glm::dot(plane, world_from_model * glm::dvec4(position, 1.0)));
        if (std::abs(least) < 1e-9) continue;  // too close to call after rounding
        const bool is_whole = is_kept_whole(box, positions, pass, world_from_model);
        EXPECT_EQ(is_whole, least > 0.0) << "at " << i;
        whole += is_whole;
        const bool is_box_whole = is_kept_whole(box, {}, pass, world_from_model);
        EXPECT_FALSE(is_box_whole && !is_whole) << "at " << i;
        only_by_vertices += is_whole && !is_box_whole;
    }
    EXPECT_GT(whole, 500);
    EXPECT_LT(whole, 2500);
    EXPECT_GT(only_by_vertices, 50);
}

TEST(Sight, ObjectsOnAClipPlaneAreKeptWhole) {
    Pass pass;
    pass.clip_planes.emplace_back(glm::dvec4(0.0, 1.0, 0.0, 0.0));
    const Mesh box = box_mesh();
    const auto is_whole_at = [&](double y) {
        const glm::dmat4 placed = world_from_model({3.0, y, 1.0}, {12.0, 0.0, 0.0}, glm::dvec3(0.4));
        return is_kept_whole(bounds_of(box), box.positions, pass, placed);
    };
    EXPECT_TRUE(is_whole_at(0.4));
    EXPECT_FALSE(is_whole_at(0.39));
    EXPECT_TRUE(is_kept_whole({}, {}, pass, glm::dmat4(1.0)));
}

}  // namespace
}  // namespace viewing
