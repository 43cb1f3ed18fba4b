// Back-face culling: two tests that must agree, known counts, and the scenes that culling alone draws correctly.
#include "topics/hidden/methods/culling.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "unit/methods/scenes.h"

namespace viewing {
namespace {

std::vector<Polygon> polygons_of(const Mesh& mesh, const glm::dmat4& world_from_model = glm::dmat4(1.0)) {
    const MeshInstance instance{&mesh, world_from_model};
    return polygons_of(std::span(&instance, 1)).polygons;
}

std::vector<int> as_they_stand(std::span<const Polygon> polygons) {
    std::vector<int> order;
    for (std::size_t i = 0; i < polygons.size(); ++i) order.push_back(static_cast<int>(i));
    return order;
}

std::int64_t wrong_after_culling(std::span<const Polygon> polygons, const Viewpoint& viewpoint) {
    const std::vector<Polygon> left = culled(polygons, viewpoint, CullFace::back);
    return difference(ray_cast_image(polygons, viewpoint), paint(left, as_they_stand(left), viewpoint)).different;
}

void expect_counts(const CullCounts& counts, int towards, int away, int edge_on) {
    EXPECT_EQ(counts.facing_towards, towards);
    EXPECT_EQ(counts.facing_away, away);
    EXPECT_EQ(counts.edge_on, edge_on);
    EXPECT_EQ(counts.gl_front, towards);
    EXPECT_EQ(counts.gl_back, away);
    EXPECT_EQ(counts.gl_none, edge_on);
    EXPECT_EQ(counts.disagree, 0);
}

TEST(Culling, CountsTheFacesOfABox) {
    const std::vector<Polygon> box = polygons_of(box_mesh());
    expect_counts(count_facing(box, viewpoint_at({4, 5, 6}, {0, 0, 0})), 6, 6, 0);
    expect_counts(count_facing(box, viewpoint_at({0, 3, 8}, {0, 0, 0})), 4, 8, 0);
    expect_counts(count_facing(box, viewpoint_on_z()), 2, 10, 0);
    expect_counts(count_facing(box, viewpoint_on_z(true)), 2, 2, 8);
    // The eye is in the plane y = 1 of the top.
    expect_counts(count_facing(box, viewpoint_at({0, 1, 8}, {0, 1, 0})), 2, 8, 2);
    // From any point outside, one to three faces are visible.
    SCOPED_TRACE(seed);
    Random random(seed);
    for (int i = 0; i < 200; ++i) {
        const CullCounts counts = count_facing(box, viewpoint_at(random.number(2, 9) * random.direction(), {0, 0, 0}));
        EXPECT_GE(counts.facing_towards, 2);
        EXPECT_LE(counts.facing_towards, 6);
        EXPECT_EQ(counts.facing_towards + counts.facing_away + counts.edge_on, 12);
    }
}

TEST(Culling, FromInsideEveryFaceIsBackFacing) {
    const std::vector<Polygon> box = polygons_of(box_mesh());
    const Viewpoint inside = viewpoint_at({0.1, 0.2, 0.3}, {-5, 1, 0}, {.near = 0.05});
    const CullCounts counts = count_facing(box, inside);
    EXPECT_EQ(counts.facing_away, 12);
    EXPECT_EQ(counts.gl_front, 0);
    EXPECT_GT(counts.gl_back, 0);
    EXPECT_GT(counts.gl_none, 0) << "triangles behind the eye have no area";
    EXPECT_EQ(counts.gl_back + counts.gl_none, 12);
    EXPECT_TRUE(culled(box, inside, CullFace::back).empty());
    EXPECT_EQ(culled(box, inside, CullFace::front).size(), 12U);
}

TEST(Culling, BothTestsAgreeOnRandomScenes) {
    int facing = 0, clipped = 0;
    for (int scene = 0; scene < random_scene_count(); ++scene) {
        SCOPED_TRACE("seed " + std::to_string(seed + scene));
        Random random(seed + scene);
        const std::vector<Polygon> polygons = random_polygons(random);
        const Viewpoint viewpoint = random_viewpoint(random);
        for (const FrontFace front : {FrontFace::ccw, FrontFace::cw}) {
            const CullCounts counts = count_facing(polygons, viewpoint, front);
            EXPECT_EQ(counts.disagree, 0);
            EXPECT_EQ(counts.facing_towards + counts.facing_away + counts.edge_on, counts.input);
            EXPECT_EQ(counts.gl_front + counts.gl_back + counts.gl_none, counts.input);
            facing += counts.gl_front + counts.gl_back;
            clipped += counts.gl_none;
        }
    }
    EXPECT_GT(facing, 1000);
    EXPECT_GT(clipped, 0) << "some eyes are inside the scene";
}

TEST(Culling, FirstRayHitOnAClosedMeshIsFrontFacing) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const std::vector<Polygon> torus = polygons_of(torus_mesh(20, 10));
    for (int i = 0; i < 20; ++i) {
        const Viewpoint viewpoint = viewpoint_at(5.0 * random.direction(), {0, 0, 0}, {.orthographic = i % 2 == 0});
        const std::vector<Facing> facing = facing_by_plane(torus, viewpoint);
        int met = 0;
        for (const int id : ray_cast_image(torus, viewpoint).ids) {
            if (id == IdImage::background) continue;
            EXPECT_EQ(facing.at(id), Facing::towards);
            ++met;
        }
        EXPECT_GT(met, 100);
    }
}

TEST(Culling, FlipsWithTheWindingAndTheFace) {
    const std::vector<Polygon> cone = polygons_of(cone_mesh(12));
    const Viewpoint viewpoint = viewpoint_at({3, 1, 5}, {0, 0, 0});
    const auto sources = [&](CullFace faces, FrontFace front) {
        std::vector<int> result;
        for (const Polygon& polygon : culled(cone, viewpoint, faces, front)) result.push_back(polygon.source);
        return result;
    };
    const std::vector<int> fronts = sources(CullFace::back, FrontFace::ccw);
    EXPECT_EQ(fronts, sources(CullFace::front, FrontFace::cw));
    EXPECT_EQ(sources(CullFace::front, FrontFace::ccw), sources(CullFace::back, FrontFace::cw));
    EXPECT_TRUE(sources(CullFace::front_and_back, FrontFace::cw).empty());
    EXPECT_TRUE(std::is_sorted(fronts.begin(), fronts.end())) << "culling keeps the order";
    const CullCounts as_is = count_facing(cone, viewpoint), turned = count_facing(cone, viewpoint, FrontFace::cw);
    EXPECT_EQ(static_cast<int>(fronts.size()), as_is.facing_towards);
    EXPECT_EQ(as_is.facing_towards, turned.facing_away);
    EXPECT_EQ(as_is.gl_front, turned.gl_back);
}

TEST(Culling, AloneIsEnoughForOneConvexMesh) {
    SCOPED_TRACE(seed);
    Random random(seed);
    for (const Mesh& mesh : {box_mesh(), sphere_mesh(12, 8), cone_mesh(9), cylinder_mesh(9)}) {
        for (int i = 0; i < 20; ++i) {
            const glm::dmat4 pose = world_from_model(random.vec3(0.5), random.angles(), {0.8, 1.2, 1.0});
            const std::vector<Polygon> polygons = polygons_of(mesh, pose);
            const glm::dvec3 eye = random.number(4, 9) * random.direction();
            EXPECT_EQ(wrong_after_culling(polygons, viewpoint_at(eye, {0, 0, 0}, {.orthographic = i % 3 == 0})), 0);
        }
    }
}

TEST(Culling, AloneFailsForAConcaveMeshAndForTwoMeshes) {
    const Viewpoint viewpoint = viewpoint_at({0.5, 1.5, 4}, {0, 0, 0});
    std::vector<Polygon> torus = polygons_of(torus_mesh(16, 8));
    const std::int64_t one_order = wrong_after_culling(torus, viewpoint);
    std::reverse(torus.begin(), torus.end());
    EXPECT_GT(one_order + wrong_after_culling(torus, viewpoint), 20);
    const Mesh box = box_mesh();
    const std::array boxes{MeshInstance{&box, world_from_model({0, 0, 0}, {}, glm::dvec3(0.4))},
                           MeshInstance{&box, world_from_model({0, 0, -2}, {}, glm::dvec3(0.8))}};
    EXPECT_GT(wrong_after_culling(polygons_of(std::span(boxes)).polygons, viewpoint), 100);
}

TEST(Culling, HandlesDegenerateInput) {
    expect_counts(count_facing({}, viewpoint_on_z()), 0, 0, 0);
    EXPECT_TRUE(culled({}, viewpoint_on_z(), CullFace::back).empty());
    std::vector<Polygon> edge_on, behind;
    add(edge_on, {{-1, 0, -1}, {1, 0, -1}, {0, 0, 1}});
    expect_counts(count_facing(edge_on, viewpoint_on_z()), 0, 0, 1);
    EXPECT_EQ(culled(edge_on, viewpoint_on_z(), CullFace::back).size(), 1U);
    EXPECT_EQ(culled(edge_on, viewpoint_on_z(), CullFace::front).size(), 1U);
    add(behind, {{-1, 0, 20}, {1, 0, 20}, {0, 1, 20}});
    const CullCounts counts = count_facing(behind, viewpoint_on_z());
    EXPECT_EQ(counts.facing_away, 1);
    EXPECT_EQ(counts.gl_none, 1);
}

}  // namespace
}  // namespace viewing
